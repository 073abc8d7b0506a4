// Following a self-motion, as Python sees it.
#pragma once

#include "binding/chain.hpp"
#include "chain/curve.hpp"

namespace {

nb::tuple follow_curve(const Forward& arm, nb::handle start, nb::handle pose, nb::handle direction, double step,
                       double straight, int most_steps) {
  const auto q = to_vector<double>(start, NPY_DOUBLE), T = to_vector<double>(pose, NPY_DOUBLE),
             along = to_vector<double>(direction, NPY_DOUBLE);
  const pieper::PlainChain chain = arm.plain();
  const std::size_t n = chain.n;
  if (q.size() != n || along.size() != n || T.size() != 16)
    throw nb::value_error("q and direction must be (n,), T (4, 4).");
  std::vector<double> points;
  bool closed;
  {
    nb::gil_scoped_release release;
    closed = pieper::follow_curve(chain, T.data(), q.data(), along.data(), {step, straight, most_steps}, points);
  }
  const npy_intp shape[] = {static_cast<npy_intp>(points.size() / n), static_cast<npy_intp>(n)};
  nb::object out = new_array(2, shape, NPY_DOUBLE);
  std::copy(points.begin(), points.end(), static_cast<double*>(PyArray_DATA(as_array(out))));
  return nb::make_tuple(out, closed);
}

void bind_curve(nb::module_& m) {
  m.def("follow_curve", &follow_curve, nb::arg("chain"), nb::kw_only(), nb::arg("q"), nb::arg("T"),
        nb::arg("direction"), nb::arg("step"), nb::arg("straight"), nb::arg("most_steps"),
        "Along a self-motion from q (n,) of pose T (4, 4): points (k, n), and whether it closed.");
}

}  // namespace
