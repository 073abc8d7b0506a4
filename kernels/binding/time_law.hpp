// Splines and time laws as Python sees them.
#pragma once

#include "binding/arrays.hpp"
#include "dispatch/isa.hpp"
#include "time_law/smooth.hpp"
#include "time_law/spline.hpp"

namespace {

double* written(const nb::object& o) { return static_cast<double*>(PyArray_DATA(as_array(o))); }

// Room of a thread that is not handed back to the system from call to call.
double* scratch(long doubles) {
  static thread_local std::vector<double> room;
  if (static_cast<long>(room.size()) < doubles) room.resize(doubles);
  return room.data();
}

nb::tuple spline(nb::handle given_s, nb::handle given_q) {
  nb::object s = float_array(given_s, "s"), q = float_array(given_q, "q");
  PyArrayObject *S = as_array(s), *Q = as_array(q);
  if (PyArray_NDIM(S) != 1 || PyArray_NDIM(Q) != 2 || PyArray_DIM(Q, 0) != PyArray_DIM(S, 0) || PyArray_DIM(S, 0) < 2)
    throw nb::value_error("s must be (N,) and q (N, n), N at least 2.");
  const npy_intp shape[] = {PyArray_DIM(Q, 0) - 1, PyArray_DIM(Q, 1)};
  nb::object out[3] = {new_array(2, shape, NPY_DOUBLE), new_array(2, shape, NPY_DOUBLE),
                       new_array(2, shape, NPY_DOUBLE)};
  pieper::spline_pieces(doubles(s), doubles(q), PyArray_DIM(S, 0), static_cast<int>(shape[1]), written(out[0]),
                        written(out[1]), written(out[2]));
  return nb::make_tuple(out[0], out[1], out[2]);
}

nb::tuple fastest(nb::handle s, nb::handle d1, nb::handle d2, nb::handle d3, nb::handle speed, nb::handle acceleration,
                  nb::handle share, nb::handle easing, nb::handle a, nb::handle b, nb::handle c, nb::handle most,
                  nb::handle wanted, double start, double end) {
  const nb::handle given[] = {s, d1, d2, d3, speed, acceleration, share, easing, a, b, c, most, wanted};
  const char* names[] = {"s",      "d1", "d2", "d3", "speed", "acceleration", "share",
                         "easing", "a",  "b",  "c",  "most",  "wanted"};
  nb::object held[13];
  for (int k = 0; k < 13; ++k) held[k] = float_array(given[k], names[k]);
  const npy_intp points = PyArray_SIZE(as_array(held[0])), cells = points - 1;
  if (points < 2 || PyArray_NDIM(as_array(held[1])) != 2 || PyArray_NDIM(as_array(held[8])) != 2)
    throw nb::value_error("s must be (cells + 1,), d1 (cells, n) and a (cells, rows).");
  const npy_intp joints = PyArray_DIM(as_array(held[1]), 1), extra = PyArray_DIM(as_array(held[8]), 1);
  for (int k = 1; k < 13; ++k) {
    const npy_intp size = k < 4 ? cells * joints : k < 6 ? joints : k < 8 ? cells : k < 11 ? cells * extra : points;
    if (PyArray_SIZE(as_array(held[k])) != size)
      throw nb::value_error((std::string(names[k]) + " has a wrong size.").c_str());
  }
  const double* in[13];
  for (int k = 0; k < 13; ++k) in[k] = doubles(held[k]);
  const pieper::TimedPath path{cells,
                               static_cast<int>(joints),
                               static_cast<int>(extra),
                               in[0],
                               in[1],
                               in[2],
                               in[3],
                               in[4],
                               in[5],
                               in[6],
                               in[7],
                               in[8],
                               in[9],
                               in[10],
                               in[11],
                               in[12]};
  nb::object x = new_array(1, &points, NPY_DOUBLE), highest = new_array(1, &points, NPY_DOUBLE);
  double *out = written(x), *sets = written(highest);
  std::fill(out, out + points, 0.0);
  std::fill(sets, sets + points, 0.0);
  pieper::Timing timing;
  {
    nb::gil_scoped_release release;
    timing = pieper::isa().fastest(path, start, end, scratch(pieper::isa().fastest_doubles(path)), out, sets);
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

double strays(nb::handle s, nb::handle d2, nb::handle d3) {
  const HeldPieces curve(s, d2, d2, d2, d3);
  const pieper::CubicPieces& p = curve.pieces;
  return pieper::strays(p.s, p.d2, p.d3, p.cells, p.joints);
}

// Runs of pieces (k) on which one row of values (r, k) is the largest and at least `least`: (m,) first piece, one behind the
// last, row.
nb::tuple tightest(nb::handle given, double least) {
  nb::object values = float_array(given, "values");
  if (PyArray_NDIM(as_array(values)) != 2) throw nb::value_error("values must be (r, k).");
  const npy_intp rows = PyArray_DIM(as_array(values), 0), pieces = PyArray_DIM(as_array(values), 1);
  const double* v = doubles(values);
  std::vector<int> which(pieces, 0);
  std::vector<double> top(v, v + (rows ? pieces : 0));
  for (npy_intp r = 1; r < rows; ++r)
    for (npy_intp k = 0; k < pieces; ++k)
      if (v[r * pieces + k] > top[k]) top[k] = v[r * pieces + k], which[k] = static_cast<int>(r);
  nb::list out;
  for (npy_intp k = 0, end = 0; k < (rows ? pieces : 0); k = end) {
    const bool tight = top[k] >= least;
    for (end = k + 1; end < pieces && (top[end] >= least) == tight && (!tight || which[end] == which[k]);) ++end;
    if (tight) out.append(nb::make_tuple(k, end, which[k]));
  }
  return nb::tuple(out);
}

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
  pieper::isa().peak_ratios(curve.pieces, doubles(x), doubles(speed), doubles(bend), doubles(share), written(out));
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
  pieper::isa().in_time(curve.pieces, pieces, doubles(t), doubles(c), doubles(times), count, written(out[0]),
                        written(out[1]), written(out[2]), written(out[3]), written(out[4]));
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
  if (PyArray_NDIM(as_array(held)) != 2 || PyArray_DIM(as_array(held), 1) != asked || asked == 1 || asked > 9)
    throw nb::value_error("coefficients must be square, at most (9, 9), or (0, 0).");
  const pieper::Profile profile = pieper::split_at(profile_of(t, c), curve.pieces, moment);
  const npy_intp pieces = profile.pieces(), shape[] = {3 * joints, pieces};
  nb::object out = new_array(2, shape, NPY_DOUBLE), fastest = new_array(1, &pieces, NPY_DOUBLE);
  const pieper::JerkBounds bounds{doubles(speed), doubles(bend), doubles(jerk), cells, doubles(grid), doubles(share)};
  pieper::isa().jerk_ratios(curve.pieces, pieces, profile.t.data(), profile.c.data(), bounds,
                            asked ? doubles(held) : nullptr, asked ? static_cast<int>(asked) : 3, written(out),
                            written(fastest));
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
        "(N,), (N, n) -> three (N - 1, n): the first three derivatives at the beginning of each piece of the spline.");
  m.def("strays", &strays, nb::arg("s"), nb::arg("d2"), nb::arg("d3"),
        "How far pieces of third degree stray from their own chords, the largest of all joints.");
  m.def("tightest", &tightest, nb::arg("values"), nb::arg("least"),
        "Runs (first piece, one behind the last, row) on which one row of values (r, k) is largest and at least so "
        "much.");
  m.def("fastest", &fastest, nb::kw_only(), nb::arg("s"), nb::arg("d1"), nb::arg("d2"), nb::arg("d3"), nb::arg("speed"),
        nb::arg("acceleration"), nb::arg("share"), nb::arg("easing"), nb::arg("a"), nb::arg("b"), nb::arg("c"),
        nb::arg("most"), nb::arg("wanted"), nb::arg("start"), nb::arg("end"),
        "x (N,), upper ends of the controllable sets (N,), whether it can be done, where not.");
}

}  // namespace
