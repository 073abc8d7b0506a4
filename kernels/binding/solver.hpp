// The solver that all inverse families share, as Python sees it.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include "binding/fields.hpp"
#include "binding/selection.hpp"
#include "dispatch/solver.hpp"
#include "maps/reach.hpp"

namespace {

nb::object poses_in(nb::handle given) {
  nb::object poses = float_array(given, "Ts");
  PyArrayObject* array = as_array(poses);
  if (PyArray_NDIM(array) != 3 || PyArray_DIM(array, 1) != 4 || PyArray_DIM(array, 2) != 4) {
    nb::dict data;
    raise_input_error("Ts must have shape (N, 4, 4), got " + shape_text(array) + ".", data);
  }
  return poses;
}

class PySolver {
 public:
  PySolver(nb::object geometry, nb::handle lower, nb::handle upper, nb::handle prismatic, double slack, double accepted,
           double exact)
      : geometry_(geometry),
        accepted_(accepted),
        exact_(exact),
        solver_(*nb::cast<const pieper::Geometry*>(geometry), shifted(lower, -slack), shifted(upper, slack),
                to_vector<std::uint8_t>(prismatic, NPY_UINT8), accepted, exact) {}

  nb::object geometry() const { return geometry_; }
  const pieper::Solver& solver() const { return solver_; }
  double exact() const { return exact_; }

  nb::tuple many(nb::handle given, int threads) const {
    nb::object poses = poses_in(given);
    const npy_intp shape[] = {PyArray_DIM(as_array(poses), 0), solver_.slots(), solver_.joints()};
    nb::object q = new_array(3, shape, NPY_DOUBLE), valid = new_array(2, shape, NPY_BOOL),
               in_limits = new_array(2, shape, NPY_BOOL), flag = new_array(1, shape, NPY_UINT8),
               outcome = new_array(1, shape, NPY_UINT8);
    run(poses, threads,
        {static_cast<double*>(PyArray_DATA(as_array(q))), bytes(valid), bytes(in_limits), bytes(flag), bytes(outcome)},
        {}, nb::none());
    return nb::make_tuple(q, valid, in_limits, flag);
  }

  void into(nb::handle given, int threads, nb::handle q, nb::handle valid, nb::handle in_limits, nb::handle flag,
            nb::handle outcome, nb::handle selection, nb::handle near, nb::handle chosen, nb::handle has,
            nb::handle progress) const {
    nb::object poses = poses_in(given), at;
    const npy_intp count = PyArray_DIM(as_array(poses), 0), n = solver_.joints(), rows = count * solver_.slots();
    const pieper::Answers to = {target<double>(q, NPY_DOUBLE, rows * n, "q"),
                                target<std::uint8_t>(valid, NPY_BOOL, rows, "valid"),
                                target<std::uint8_t>(in_limits, NPY_BOOL, rows, "in_limits"),
                                target<std::uint8_t>(flag, NPY_UINT8, count, "flag"),
                                target<std::uint8_t>(outcome, NPY_UINT8, count, "outcome")};
    pieper::Chosen choice;
    if (!selection.is_none()) {
      const PySelection& by = *nb::cast<const PySelection*>(selection);
      if (by.plain().n != n) throw nb::value_error("the selection is of another number of joints.");
      at = float_array(near, "near");
      choice = {&by.plain(), doubles(at), by.stride(at, count), target<double>(chosen, NPY_DOUBLE, count * n, "chosen"),
                target<std::uint8_t>(has, NPY_BOOL, count, "has")};
    }
    run(poses, threads, to, choice, progress);
  }

  nb::tuple one(nb::handle given) const {
    nb::object pose = float_array(given, "T");
    PyArrayObject* array = as_array(pose);
    if (PyArray_NDIM(array) != 2 || PyArray_DIM(array, 0) != 4 || PyArray_DIM(array, 1) != 4) {
      nb::dict data;
      raise_input_error("T must be one pose of shape (4, 4), got " + shape_text(array) + "; ik_many takes many.", data);
    }
    const int n = solver_.joints(), slots = solver_.slots();
    double small[8 * 8];
    std::vector<double> large;
    double* q = small;
    if (slots * n > 64) {
      large.resize(static_cast<std::size_t>(slots) * n);
      q = large.data();
    }
    std::uint8_t valid[256], in_limits[256], flag;
    pieper::BadPose bad{};
    if (!solver_.solve_one(doubles(pose), q, valid, in_limits, &flag, bad)) refuse(bad, doubles(pose), false);
    int m = 0;
    for (int i = 0; i < slots; ++i) m += valid[i];
    const npy_intp shape[] = {m, n};
    nb::object rows = new_array(2, shape, NPY_DOUBLE), which = new_array(1, shape, NPY_UINT8),
               inside = new_array(1, shape, NPY_BOOL);
    double* row = static_cast<double*>(PyArray_DATA(as_array(rows)));
    for (int i = 0, k = 0; i < slots; ++i) {
      if (!valid[i]) continue;
      row = std::copy(q + i * n, q + (i + 1) * n, row);
      bytes(which)[k] = static_cast<std::uint8_t>(i);
      bytes(inside)[k++] = in_limits[i];
    }
    return nb::make_tuple(rows, which, inside, static_cast<int>(flag));
  }

  nb::tuple reach(nb::handle centres, nb::handle turns, int rolls, double sense, nb::handle images, double first_sense,
                  nb::handle links, double length, int threads) const {
    nb::object at = float_array(centres, "centres"), R = float_array(turns, "turns"), L;
    const npy_intp count = PyArray_SIZE(as_array(at)) / 3, orientations = PyArray_SIZE(as_array(R)) / 9;
    const std::vector<std::int64_t> numbers = to_vector<std::int64_t>(images, NPY_INT64);
    const npy_intp fold = count ? static_cast<npy_intp>(numbers.size()) / count : 1;
    if (PyArray_SIZE(as_array(at)) != 3 * count || PyArray_SIZE(as_array(R)) != 9 * orientations || rolls < 1 ||
        fold < 1 || static_cast<npy_intp>(numbers.size()) != fold * count || orientations % (rolls * fold))
      throw nb::value_error(
          "centres must be (v, 3), images (v, fold) and turns (k, 3, 3), k a multiple of rolls * fold.");
    const npy_intp voxels = numbers.empty() ? 0 : 1 + *std::max_element(numbers.begin(), numbers.end());
    if (std::ranges::count_if(numbers, [](std::int64_t i) { return i >= 0; }) != voxels)
      throw nb::value_error("images must name each voxel once.");
    pieper::Voxels asked{doubles(at), count,          doubles(R), orientations, rolls, sense, static_cast<int>(fold),
                         first_sense, numbers.data(), nullptr,    length};
    if (!links.is_none()) {
      L = float_array(links, "links");
      if (solver_.joints() != 6 || PyArray_SIZE(as_array(L)) != 16 * 7)
        throw nb::value_error("links must be (7, 4, 4): what is measured is a determinant.");
      asked.links = doubles(L);
    }
    const npy_intp packed[] = {voxels, (orientations + 7) / 8}, six[] = {voxels, asked.links ? pieper::kMeasures : 0};
    nb::object bits = new_array(2, packed, NPY_UINT8), look = new_array(2, packed, NPY_UINT8),
               solutions = new_array(1, &voxels, NPY_INT64), measures = new_array(2, six, NPY_DOUBLE);
    const auto raw = [](const nb::object& o) { return PyArray_DATA(as_array(o)); };
    const pieper::Reached to{bytes(bits), bytes(look), static_cast<std::int64_t*>(raw(solutions)),
                             static_cast<double*>(raw(measures))};
    bool finished;
    {
      nb::gil_scoped_release release;
      finished = pieper::reach(solver_, asked, to, threads, [] {
        nb::gil_scoped_acquire acquire;
        return PyErr_CheckSignals() == 0;
      });
    }
    if (!finished) throw nb::python_error();
    return nb::make_tuple(bits, look, solutions, measures);
  }

 private:
  // progress: called with the number of poses that are done, or None.
  void run(const nb::object& poses, int threads, const pieper::Answers& to, const pieper::Chosen& chosen,
           nb::handle progress) const {
    const long count = PyArray_DIM(as_array(poses), 0);
    const double* T = doubles(poses);
    pieper::BadPose bad{};
    pieper::Outcome outcome;
    {
      nb::gil_scoped_release release;
      outcome = solver_.solve(T, count, threads, to, chosen, bad, [&](long done) {
        nb::gil_scoped_acquire acquire;
        if (PyErr_CheckSignals() != 0) return false;
        if (progress.is_none()) return true;
        PyObject* said = PyObject_CallFunction(progress.ptr(), "l", done);
        Py_XDECREF(said);
        return said != nullptr;
      });
    }
    // KeyboardInterrupt, whatever the signal handler raised, or what `progress` did
    if (outcome == pieper::Outcome::STOPPED) throw nb::python_error();
    if (outcome == pieper::Outcome::BAD_POSE) refuse(bad, T, true);
  }

  static std::uint8_t* bytes(const nb::object& o) { return static_cast<std::uint8_t*>(PyArray_DATA(as_array(o))); }

  static std::vector<double> shifted(nb::handle values, double by) {
    std::vector<double> out = to_vector<double>(values, NPY_DOUBLE);
    for (double& v : out) v += by;
    return out;
  }

  [[noreturn]] void refuse(const pieper::BadPose& bad, const double* T, bool of_many) const {
    const double* pose = T + 16 * bad.index;
    char number[32], limit[32];
    std::snprintf(number, sizeof number, "%.3g", bad.deviation);
    std::snprintf(limit, sizeof limit, "%.3g", accepted_);
    std::string which = of_many ? "Ts[" + std::to_string(bad.index) + "]" : "T";
    bool finite = true;
    for (int k = 0; k < 16; ++k) finite &= std::isfinite(pose[k]);
    std::string message;
    if (!finite) {
      message = which + " holds NaN or infinity; every entry of a pose must be a finite number.";
    } else if (bad.deviation >= 2.0 && determinant(pose) < 0) {
      message = which +
                " is left-handed (its rotation part has a negative determinant): a mirror, not a pose. Check the signs "
                "and the order of its columns.";
    } else {
      message = which + " is not a pose: its rotation part or last row departs from a rigid motion by " + number +
                ", and at most " + limit +
                " is accepted. Check that it is not scaled, sheared or transposed, that angles were in radians and the "
                "last row is "
                "0 0 0 1.";
    }
    nb::dict data;
    data["index"] = bad.index;
    data["deviation"] = bad.deviation;
    raise_input_error(message, data);
  }

  static double determinant(const double* T) {
    return T[0] * (T[5] * T[10] - T[6] * T[9]) - T[1] * (T[4] * T[10] - T[6] * T[8]) +
           T[2] * (T[4] * T[9] - T[5] * T[8]);
  }

  nb::object geometry_;
  double accepted_, exact_;
  pieper::Solver solver_;
};

}  // namespace
