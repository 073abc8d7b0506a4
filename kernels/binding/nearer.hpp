// The descent to a pose that is out of reach, as Python sees it.
#pragma once

#include "binding/chain.hpp"
#include "chain/nearer.hpp"

namespace {

nb::tuple nearer(const Forward& arm, nb::handle coupling, nb::handle lower, nb::handle upper, nb::handle given,
                 nb::handle pose, nb::handle turning, int steps) {
  const auto low = to_vector<double>(lower, NPY_DOUBLE), high = to_vector<double>(upper, NPY_DOUBLE),
             by = to_vector<double>(turning, NPY_DOUBLE), T = to_vector<double>(pose, NPY_DOUBLE);
  const std::vector<double> C = coupling.is_none() ? std::vector<double>() : to_vector<double>(coupling, NPY_DOUBLE);
  nb::object starts = float_array(given, "q");
  const std::size_t n = arm.plain().n;
  PyArrayObject* from = as_array(starts);
  if (PyArray_NDIM(from) != 2 || PyArray_DIM(from, 1) != static_cast<npy_intp>(n) || low.size() != n ||
      high.size() != n || T.size() != 16 || (!C.empty() && C.size() != n * n) ||
      by.size() != static_cast<std::size_t>(PyArray_DIM(from, 0)))
    throw nb::value_error("q must be (k, n), turning (k,), lower and upper (n,), T (4, 4).");
  const npy_intp count = PyArray_DIM(from, 0);
  nb::object q = new_array(2, PyArray_DIMS(from), NPY_DOUBLE), value = new_array(1, &count, NPY_DOUBLE);
  double *rows = static_cast<double*>(PyArray_DATA(as_array(q))),
         *left = static_cast<double*>(PyArray_DATA(as_array(value)));
  std::copy(doubles(starts), doubles(starts) + count * n, rows);
  const pieper::DownhillChain chain{arm.plain(), C.empty() ? nullptr : C.data(), low.data(), high.data()};
  {
    nb::gil_scoped_release release;
    for (npy_intp k = 0; k < count; ++k) left[k] = pieper::nearer(chain, T.data(), by[k], steps, rows + k * n);
  }
  return nb::make_tuple(q, value);
}

void bind_nearer(nb::module_& m) {
  m.def("nearer", &nearer, nb::arg("chain"), nb::kw_only(), nb::arg("coupling").none(), nb::arg("lower"),
        nb::arg("upper"), nb::arg("q"), nb::arg("T"), nb::arg("turning"), nb::arg("steps"),
        "Downhill from q (k, n) to T (4, 4): (k, n) and what is left (k,).");
}

}  // namespace
