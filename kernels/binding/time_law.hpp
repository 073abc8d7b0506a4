// Splines and time laws as Python sees them.
#pragma once

#include "binding/arrays.hpp"
#include "time_law/fastest.hpp"
#include "time_law/in_time.hpp"
#include "time_law/smooth.hpp"
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

// Holds the arrays of a curve s, q, d1, d2, d3 as long as the pieces that point into them.
struct HeldPieces {
  nb::object held[5];
  pieper::CubicPieces pieces;

  HeldPieces(nb::handle s, nb::handle q, nb::handle d1, nb::handle d2, nb::handle d3) {
    const nb::handle given[] = {s, q, d1, d2, d3};
    const char* names[] = {"s", "q", "d1", "d2", "d3"};
    for (int k = 0; k < 5; ++k) held[k] = float_array(given[k], names[k]);
    PyArrayObject* first = as_array(held[1]);
    if (PyArray_NDIM(first) != 2) throw nb::value_error("q must be (k, n).");
    const npy_intp cells = PyArray_DIM(first, 0), joints = PyArray_DIM(first, 1);
    for (int k = 0; k < 5; ++k)
      if (PyArray_SIZE(as_array(held[k])) != (k == 0 ? cells + 1 : cells * joints))
        throw nb::value_error((std::string(names[k]) + " has a wrong size.").c_str());
    pieces = {cells,
              static_cast<int>(joints),
              doubles(held[0]),
              doubles(held[1]),
              doubles(held[2]),
              doubles(held[3]),
              doubles(held[4])};
  }
};

double* written(const nb::object& o) { return static_cast<double*>(PyArray_DATA(as_array(o))); }

nb::object peak_ratios(nb::handle s, nb::handle d1, nb::handle d2, nb::handle d3, nb::handle given_x,
                       nb::handle given_speed, nb::handle given_acceleration, nb::handle given_share) {
  const HeldPieces curve(s, d1, d1, d2, d3);
  const npy_intp cells = curve.pieces.cells, joints = curve.pieces.joints;
  nb::object x = float_array(given_x, "x"), share = float_array(given_share, "share");
  nb::object speed = float_array(given_speed, "speed"), bend = float_array(given_acceleration, "acceleration");
  if (PyArray_SIZE(as_array(x)) != cells + 1) throw nb::value_error("x must be (k + 1,).");
  if (PyArray_SIZE(as_array(share)) != cells) throw nb::value_error("share must be (k,).");
  if (PyArray_SIZE(as_array(speed)) != joints || PyArray_SIZE(as_array(bend)) != joints)
    throw nb::value_error("speed and acceleration must be (n,).");
  const npy_intp shape[] = {2 * joints, cells};
  nb::object out = new_array(2, shape, NPY_DOUBLE);
  pieper::peak_ratios(curve.pieces, doubles(x), doubles(speed), doubles(bend), doubles(share), written(out));
  return out;
}

nb::tuple in_time(nb::handle s, nb::handle q, nb::handle d1, nb::handle d2, nb::handle d3, nb::handle given_t,
                  nb::handle given_c, nb::handle given_times) {
  const HeldPieces curve(s, q, d1, d2, d3);
  nb::object t = float_array(given_t, "t"), c = float_array(given_c, "c"), times = float_array(given_times, "times");
  const npy_intp pieces = PyArray_SIZE(as_array(t)) - 1, count = PyArray_SIZE(as_array(times));
  if (pieces < 1 || PyArray_SIZE(as_array(c)) != 4 * pieces) throw nb::value_error("c must be (k, 4) and t (k + 1,).");
  const npy_intp shape[] = {count, curve.pieces.joints};
  nb::object out[5] = {new_array(1, shape, NPY_DOUBLE), new_array(2, shape, NPY_DOUBLE),
                       new_array(2, shape, NPY_DOUBLE), new_array(2, shape, NPY_DOUBLE),
                       new_array(2, shape, NPY_DOUBLE)};
  pieper::in_time(curve.pieces, pieces, doubles(t), doubles(c), doubles(times), count, written(out[0]), written(out[1]),
                  written(out[2]), written(out[3]), written(out[4]));
  return nb::make_tuple(out[0], out[1], out[2], out[3], out[4]);
}

pieper::Profile profile_of(nb::handle given_t, nb::handle given_c) {
  nb::object t = float_array(given_t, "t"), c = float_array(given_c, "c");
  const npy_intp times = PyArray_SIZE(as_array(t));
  if (times < 2 || PyArray_SIZE(as_array(c)) != 4 * (times - 1))
    throw nb::value_error("c must be (k, 4) and t (k + 1,).");
  return {{doubles(t), doubles(t) + times}, {doubles(c), doubles(c) + 4 * (times - 1)}};
}

nb::tuple arrays_of(const pieper::Profile& profile) {
  const npy_intp times = profile.pieces() + 1, shape[] = {profile.pieces(), 4};
  nb::object t = new_array(1, &times, NPY_DOUBLE), c = new_array(2, shape, NPY_DOUBLE);
  std::copy(profile.t.begin(), profile.t.end(), written(t));
  std::copy(profile.c.begin(), profile.c.end(), written(c));
  return nb::make_tuple(t, c);
}

nb::tuple evened(nb::handle t, nb::handle c, double window, double moment) {
  if (!(window > 0)) throw nb::value_error("window must be positive.");
  return arrays_of(pieper::evened(profile_of(t, c), window, moment));
}

nb::tuple jerk_ratios(nb::handle s, nb::handle d1, nb::handle d2, nb::handle d3, nb::handle t, nb::handle c,
                      nb::handle given_speed, nb::handle given_acceleration, nb::handle given_jerk,
                      nb::handle given_grid, nb::handle given_share, nb::handle given_coefficients, double moment) {
  const HeldPieces curve(s, d1, d1, d2, d3);
  const npy_intp joints = curve.pieces.joints;
  nb::object speed = float_array(given_speed, "speed"), bend = float_array(given_acceleration, "acceleration");
  nb::object jerk = float_array(given_jerk, "jerk"), grid = float_array(given_grid, "grid");
  nb::object share = float_array(given_share, "share"), held = float_array(given_coefficients, "coefficients");
  for (const nb::object* limit : {&speed, &bend, &jerk})
    if (PyArray_SIZE(as_array(*limit)) != joints) throw nb::value_error("limits must be (n,).");
  const npy_intp cells = PyArray_SIZE(as_array(share)), asked = PyArray_DIM(as_array(held), 0);
  if (PyArray_SIZE(as_array(grid)) != cells + 1) throw nb::value_error("grid must be (cells + 1,).");
  if (PyArray_NDIM(as_array(held)) != 2 || PyArray_DIM(as_array(held), 1) != asked || asked == 1)
    throw nb::value_error("coefficients must be square, or (0, 0).");
  const pieper::Profile profile = pieper::split_at(profile_of(t, c), curve.pieces, moment);
  const npy_intp pieces = profile.pieces(), shape[] = {3 * joints, pieces};
  nb::object out = new_array(2, shape, NPY_DOUBLE), fastest = new_array(1, &pieces, NPY_DOUBLE);
  const pieper::Bounds bounds{doubles(speed), doubles(bend), doubles(jerk), cells, doubles(grid), doubles(share)};
  pieper::jerk_ratios(curve.pieces, profile, bounds, asked ? doubles(held) : nullptr,
                      asked ? static_cast<int>(asked) : 3, written(out), written(fastest));
  const nb::tuple split = arrays_of(profile);
  return nb::make_tuple(split[0], split[1], out, fastest);
}

void bind_time_law(nb::module_& m) {
  m.def(
      "peak_ratios", &peak_ratios, nb::kw_only(), nb::arg("s"), nb::arg("d1"), nb::arg("d2"), nb::arg("d3"),
      nb::arg("x"), nb::arg("speed"), nb::arg("acceleration"), nb::arg("share"),
      "(2 n, k): the largest parts of speed and acceleration, joint by joint, on each piece; x (k + 1,) linear there.");
  m.def("evened", &evened, nb::arg("t"), nb::arg("c"), nb::arg("window"), nb::arg("moment"),
        "t (k + 1,), c (k, 4) of a profile averaged over a window of time before each moment.");
  m.def(
      "jerk_ratios", &jerk_ratios, nb::kw_only(), nb::arg("s"), nb::arg("d1"), nb::arg("d2"), nb::arg("d3"),
      nb::arg("t"), nb::arg("c"), nb::arg("speed"), nb::arg("acceleration"), nb::arg("jerk"), nb::arg("grid"),
      nb::arg("share"), nb::arg("coefficients"), nb::arg("moment"),
      "t (p + 1,), c (p, 4) split where the curve's pieces meet; (3 n, p) parts of speed, acceleration and jerk, joint "
      "by joint; (p,) the largest ds/dt.");
  m.def("in_time", &in_time, nb::kw_only(), nb::arg("s"), nb::arg("q"), nb::arg("d1"), nb::arg("d2"), nb::arg("d3"),
        nb::arg("t"), nb::arg("c"), nb::arg("times"),
        "s (m,), q, dq, ddq, dddq (m, n) at times (m,) that do not fall.");
  m.def("spline", &spline, nb::arg("s"), nb::arg("q"),
        "(N,), (N, n) -> (N, n) second derivatives of the cubic spline.");
  m.def("fastest", &fastest, nb::kw_only(), nb::arg("s"), nb::arg("d1"), nb::arg("d2"), nb::arg("d3"), nb::arg("speed"),
        nb::arg("acceleration"), nb::arg("a"), nb::arg("b"), nb::arg("c"), nb::arg("most"), nb::arg("wanted"),
        nb::arg("start"), nb::arg("end"),
        "x (N,), upper ends of the controllable sets (N,), whether it can be done, where not.");
}

}  // namespace
