// Splines and time laws as Python sees them.
#pragma once

#include "binding/arrays.hpp"
#include "time_law/fastest.hpp"
#include "time_law/spline.hpp"

namespace {

nb::object spline(nb::handle given_s, nb::handle given_q) {
  nb::object s = float_array(given_s, "s"), q = float_array(given_q, "q");
  PyArrayObject *S = as_array(s), *Q = as_array(q);
  if (PyArray_NDIM(S) != 1 || PyArray_NDIM(Q) != 2 || PyArray_DIM(Q, 0) != PyArray_DIM(S, 0))
    throw nb::value_error("s must be (N,) and q (N, n).");
  nb::object out = new_array(2, PyArray_DIMS(Q), NPY_DOUBLE);
  pieper::spline_second_derivatives(doubles(s), doubles(q), PyArray_DIM(S, 0), static_cast<int>(PyArray_DIM(Q, 1)),
                                    static_cast<double*>(PyArray_DATA(as_array(out))));
  return out;
}

nb::tuple fastest(nb::handle s, nb::handle d1, nb::handle d2, nb::handle d3, nb::handle speed, nb::handle acceleration,
                  nb::handle a, nb::handle b, nb::handle c, nb::handle most, nb::handle wanted, double start,
                  double end) {
  const nb::handle given[] = {s, d1, d2, d3, speed, acceleration, a, b, c, most, wanted};
  const char* names[] = {"s", "d1", "d2", "d3", "speed", "acceleration", "a", "b", "c", "most", "wanted"};
  nb::object held[11];
  for (int k = 0; k < 11; ++k) held[k] = float_array(given[k], names[k]);
  const npy_intp points = PyArray_SIZE(as_array(held[0])), cells = points - 1;
  if (points < 2 || PyArray_NDIM(as_array(held[1])) != 2 || PyArray_NDIM(as_array(held[6])) != 2)
    throw nb::value_error("s must be (cells + 1,), d1 (cells, n) and a (cells, rows).");
  const npy_intp joints = PyArray_DIM(as_array(held[1]), 1), extra = PyArray_DIM(as_array(held[6]), 1);
  for (int k = 1; k < 11; ++k) {
    const npy_intp size = k < 6 ? cells * joints : k < 9 ? cells * extra : points;
    if (PyArray_SIZE(as_array(held[k])) != size)
      throw nb::value_error((std::string(names[k]) + " has a wrong size.").c_str());
  }
  const pieper::TimedPath path{cells,
                               static_cast<int>(joints),
                               static_cast<int>(extra),
                               doubles(held[0]),
                               doubles(held[1]),
                               doubles(held[2]),
                               doubles(held[3]),
                               doubles(held[4]),
                               doubles(held[5]),
                               doubles(held[6]),
                               doubles(held[7]),
                               doubles(held[8]),
                               doubles(held[9]),
                               doubles(held[10])};
  nb::object x = new_array(1, &points, NPY_DOUBLE), highest = new_array(1, &points, NPY_DOUBLE);
  double* out = static_cast<double*>(PyArray_DATA(as_array(x)));
  double* sets = static_cast<double*>(PyArray_DATA(as_array(highest)));
  std::fill(out, out + points, 0.0);
  std::fill(sets, sets + points, 0.0);
  pieper::Timing timing;
  {
    nb::gil_scoped_release release;
    pieper::FastestPass pass(path);
    timing = pass.run(start, end, out, sets);
  }
  return nb::make_tuple(x, highest, timing.done, timing.where);
}

void bind_time_law(nb::module_& m) {
  m.def("spline", &spline, nb::arg("s"), nb::arg("q"),
        "(N,), (N, n) -> (N, n) second derivatives of the cubic spline.");
  m.def("fastest", &fastest, nb::kw_only(), nb::arg("s"), nb::arg("d1"), nb::arg("d2"), nb::arg("d3"), nb::arg("speed"),
        nb::arg("acceleration"), nb::arg("a"), nb::arg("b"), nb::arg("c"), nb::arg("most"), nb::arg("wanted"),
        nb::arg("start"), nb::arg("end"),
        "x (N,), upper ends of the controllable sets (N,), whether it can be done, where not.");
}

}  // namespace
