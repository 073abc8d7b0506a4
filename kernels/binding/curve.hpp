// Following a self-motion, as Python sees it.
#pragma once

#include "binding/arrays.hpp"
#include "chain/curve.hpp"

namespace {

nb::tuple follow_curve(nb::handle links, nb::handle prismatic, double length, nb::handle start, nb::handle pose,
                       nb::handle direction, double step, double straight, int most_steps) {
  const auto l = to_vector<double>(links, NPY_DOUBLE), q = to_vector<double>(start, NPY_DOUBLE),
             T = to_vector<double>(pose, NPY_DOUBLE), along = to_vector<double>(direction, NPY_DOUBLE);
  const auto slides = to_vector<std::uint8_t>(prismatic, NPY_UINT8);
  const std::size_t n = slides.size();
  if (n == 0 || l.size() != 16 * (n + 1) || q.size() != n || along.size() != n || T.size() != 16)
    throw nb::value_error("q and direction must be (n,), prismatic (n,), links (n + 1, 4, 4), T (4, 4).");
  const pieper::PlainChain chain{static_cast<int>(n), length, l.data(), slides.data()};
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
  m.def("follow_curve", &follow_curve, nb::kw_only(), nb::arg("links"), nb::arg("prismatic"), nb::arg("length"),
        nb::arg("q"), nb::arg("T"), nb::arg("direction"), nb::arg("step"), nb::arg("straight"), nb::arg("most_steps"),
        "Along a self-motion from q (n,) of pose T (4, 4): points (k, n), and whether it closed.");
}

}  // namespace
