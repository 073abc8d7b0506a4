// Merged roots, as Python sees them.
#pragma once

#include "binding/chain.hpp"
#include "singular/unfold.hpp"

namespace {

nb::tuple unfold(const Forward& arm, nb::handle given, nb::handle pose, nb::handle mixed) {
  const pieper::PlainChain chain = arm.plain();
  auto q = to_vector<double>(given, NPY_DOUBLE);
  const auto T = to_vector<double>(pose, NPY_DOUBLE);
  const auto by = mixed.is_none() ? std::vector<double>() : to_vector<double>(mixed, NPY_DOUBLE);
  const std::size_t n = q.size();
  if (n < 1 || n > 6 || T.size() != 16 || (by.empty() ? n != std::size_t(chain.n) : by.size() != n * chain.n))
    throw nb::value_error("q must be (n,), of one to six joints, T (4, 4), mixed (axes, n).");
  const int branches = pieper::unfold(chain, static_cast<int>(n), by.empty() ? nullptr : by.data(), T.data(), q.data());
  const npy_intp shape[] = {static_cast<npy_intp>(n)};
  nb::object out = new_array(1, shape, NPY_DOUBLE);
  std::copy(q.begin(), q.end(), static_cast<double*>(PyArray_DATA(as_array(out))));
  return nb::make_tuple(out, branches);
}

void bind_unfold(nb::module_& m) {
  m.def("unfold", &unfold, nb::arg("chain"), nb::kw_only(), nb::arg("q"), nb::arg("T"), nb::arg("mixed").none(),
        "The root of T (4, 4) that a singular solution q (n,), lengths in units of the arm, is a part of, and how many "
        "branches merge there. mixed (axes, n): what joints do to axes, None where each moves its own.");
}

}  // namespace
