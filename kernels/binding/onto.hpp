// Newton's method onto a pose, as Python sees it.
#pragma once

#include "binding/chain.hpp"
#include "chain/onto.hpp"

namespace {

nb::tuple onto(const Forward& arm, nb::handle start, nb::handle poses, int steps, double cutoff, double longest) {
  const pieper::PlainChain chain = arm.plain();
  const npy_intp n = chain.n;
  nb::object q = float_array(start, "q"), T = float_array(poses, "T");
  const npy_intp count = PyArray_NDIM(as_array(q)) == 2 ? PyArray_DIM(as_array(q), 0) : -1,
                 numbers = PyArray_SIZE(as_array(T));
  if (count < 0 || PyArray_SIZE(as_array(q)) != count * n || (numbers != 16 && numbers != 16 * count))
    throw nb::value_error("q must be (k, n), T (4, 4) or (k, 4, 4).");
  nb::object out = new_array(2, PyArray_DIMS(as_array(q)), NPY_DOUBLE);
  nb::object left = new_array(1, &count, NPY_DOUBLE);
  double *rows = static_cast<double*>(PyArray_DATA(as_array(out))),
         *misses = static_cast<double*>(PyArray_DATA(as_array(left)));
  std::copy(doubles(q), doubles(q) + count * n, rows);
  {
    nb::gil_scoped_release release;
    pieper::onto(chain, {steps, cutoff, longest}, count, doubles(T), numbers == 16, rows, misses);
  }
  return nb::make_tuple(out, left);
}

nb::object parts_of_weakest(const Forward& arm, nb::handle given) {
  const pieper::PlainChain chain = arm.plain();
  nb::object q = float_array(given, "q");
  const npy_intp count = PyArray_NDIM(as_array(q)) == 2 ? PyArray_DIM(as_array(q), 0) : -1;
  if (count < 0 || PyArray_SIZE(as_array(q)) != count * chain.n) throw nb::value_error("q must be (k, n).");
  nb::object out = new_array(1, &count, NPY_DOUBLE);
  pieper::parts_of_weakest(chain, count, doubles(q), static_cast<double*>(PyArray_DATA(as_array(out))));
  return out;
}

void bind_onto(nb::module_& m) {
  m.def("onto", &onto, nb::arg("chain"), nb::kw_only(), nb::arg("q"), nb::arg("T"), nb::arg("steps"), nb::arg("cutoff"),
        nb::arg("longest"),
        "Newton's method from q (k, n) onto T (4, 4) or (k, 4, 4): (k, n), and what is missed then (k,).");
  m.def("parts_of_weakest", &parts_of_weakest, nb::arg("chain"), nb::kw_only(), nb::arg("q"),
        "Of q (k, n), bounds from below of sigma_min over sigma_max without units (k,), at most six times too low.");
}

}  // namespace
