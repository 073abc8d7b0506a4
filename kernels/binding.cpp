// The Python module pieper._kernel: forward kinematics of a chain, and the solver that all inverse families share.
//
// Arrays come and go through NumPy's C interface: making one costs 60 ns there, and a single pose is solved in less
// than a microsecond.
#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <numpy/arrayobject.h>

#include <cmath>
#include <algorithm>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "dispatch/solver.hpp"
#include "family_headers.hpp"

namespace nb = nanobind;

namespace {

using pieper::IsaTable;

[[noreturn]] void raise_input_error(const std::string& message, nb::dict data) {
  nb::object kind = nb::module_::import_("pieper.errors").attr("InputError");
  nb::object error = kind(message, **data);
  PyErr_SetObject(kind.ptr(), error.ptr());
  throw nb::python_error();
}

// A C-contiguous float64 array; an object that already is one passes through without a copy.
nb::object float_array(nb::handle given, const char* what) {
  PyObject* array = PyArray_FROM_OTF(given.ptr(), NPY_DOUBLE, NPY_ARRAY_IN_ARRAY);
  if (!array) {
    PyErr_Clear();
    nb::dict data;
    data["given"] = nb::str(Py_TYPE(given.ptr())->tp_name);
    raise_input_error(std::string(what) + " must be numbers in an array, got " + Py_TYPE(given.ptr())->tp_name + ".", data);
  }
  return nb::steal(array);
}

PyArrayObject* as_array(const nb::object& o) { return reinterpret_cast<PyArrayObject*>(o.ptr()); }
const double* doubles(const nb::object& o) { return static_cast<const double*>(PyArray_DATA(as_array(o))); }

std::string shape_text(PyArrayObject* array) {
  std::string text = "(";
  for (int i = 0; i < PyArray_NDIM(array); ++i)
    text += (i ? ", " : "") + std::to_string(PyArray_DIM(array, i));
  return text + (PyArray_NDIM(array) == 1 ? ",)" : ")");
}

nb::object new_array(int dimensions, const npy_intp* shape, int type) {
  PyObject* array = PyArray_SimpleNew(dimensions, shape, type);
  if (!array) throw nb::python_error();
  return nb::steal(array);
}

template <class T> std::vector<T> to_vector(nb::handle given, int type) {
  PyObject* array = PyArray_FROM_OTF(given.ptr(), type, NPY_ARRAY_IN_ARRAY | NPY_ARRAY_FORCECAST);
  if (!array) throw nb::python_error();
  nb::object owner = nb::steal(array);
  const T* data = static_cast<const T*>(PyArray_DATA(as_array(owner)));
  return std::vector<T>(data, data + PyArray_SIZE(as_array(owner)));
}

// ---- a geometry's fields: keyword arguments, attributes, state -----------------------------------------------------

void fill(nb::handle given, double* to, std::initializer_list<npy_intp> shape) {
  nb::object array = float_array(given, "the field");
  PyArrayObject* a = as_array(array);
  bool fits = PyArray_NDIM(a) == static_cast<int>(shape.size());
  std::string wanted;
  npy_intp size = 1;
  int axis = 0;
  for (npy_intp n : shape) {
    fits = fits && PyArray_DIM(a, axis++) == n;
    wanted += std::to_string(n) + ", ";
    size *= n;
  }
  if (!fits) throw nb::value_error(("must have shape (" + wanted.substr(0, wanted.size() - 2) + "), got " + shape_text(a) + ".").c_str());
  std::copy(doubles(array), doubles(array) + size, to);
}
nb::object shown(const double* from, std::initializer_list<npy_intp> shape) {
  nb::object array = new_array(static_cast<int>(shape.size()), shape.begin(), NPY_DOUBLE);
  std::copy(from, from + PyArray_SIZE(as_array(array)), static_cast<double*>(PyArray_DATA(as_array(array))));
  return array;
}

// What a field can be: `put` reads it from Python, `get` says it in Python.
void put(nb::handle h, double& to) { to = nb::cast<double>(nb::float_(h)); }
nb::object get(double v) { return nb::float_(v); }
void put(nb::handle h, bool& to) {
  const int truth = PyObject_IsTrue(h.ptr());
  if (truth < 0) throw nb::python_error();
  to = truth;
}
nb::object get(bool v) { return nb::bool_(v); }
void put(nb::handle h, int& to) { to = nb::cast<int>(nb::int_(h)); }
nb::object get(int v) { return nb::int_(v); }
template <int N> void put(nb::handle h, double (&to)[N]) { fill(h, to, {N}); }
template <int N> nb::object get(const double (&v)[N]) { return shown(v, {N}); }
template <int N, int M> void put(nb::handle h, double (&to)[N][M]) { fill(h, to[0], {N, M}); }
template <int N, int M> nb::object get(const double (&v)[N][M]) { return shown(v[0], {N, M}); }
template <int N, int M, int K> void put(nb::handle h, double (&to)[N][M][K]) { fill(h, to[0][0], {N, M, K}); }
template <int N, int M, int K> nb::object get(const double (&v)[N][M][K]) { return shown(v[0][0], {N, M, K}); }
void put(nb::handle h, pieper::Vector& to) { fill(h, &to.x, {3}); }
nb::object get(const pieper::Vector& v) { return shown(&v.x, {3}); }
template <int N> void put(nb::handle h, pieper::Vector (&to)[N]) { fill(h, &to[0].x, {N, 3}); }
template <int N> nb::object get(const pieper::Vector (&v)[N]) { return shown(&v[0].x, {N, 3}); }
template <int N> void put(nb::handle h, bool (&to)[N]) {
  double values[N];
  fill(h, values, {N});
  for (int i = 0; i < N; ++i) to[i] = values[i] != 0;
}
template <int N> nb::object get(const bool (&v)[N]) {
  nb::list out;
  for (bool x : v) out.append(x);
  return nb::tuple(out);
}
void put(nb::handle h, pieper::Choice& to) {
  to.count = 0;
  for (nb::handle x : h) {
    if (to.count == 6) throw nb::value_error("at most six numbers.");
    to.at[to.count++] = nb::cast<int>(nb::int_(x));
  }
}
nb::object get(const pieper::Choice& v) {
  nb::list out;
  for (int i = 0; i < v.count; ++i) out.append(v.at[i]);
  return nb::tuple(out);
}

template <class Own> struct Bound;
void put(nb::handle h, const pieper::General*& to);
nb::object get(const pieper::General* v);

// A geometry that Python holds.
template <class Own> struct Bound : Own {
  nb::object held;  // kept alive, where the geometry refers to one

  Bound(int family, nb::dict given) {
    this->family = family;
    std::string known;
    std::size_t taken = 0;
    Own::fields(*this, [&](const char* name, auto& field) {
      known += (known.empty() ? "" : ", ") + std::string(name);
      if (!given.contains(name)) throw nb::type_error((std::string(Own::name) + " needs '" + name + "'.").c_str());
      nb::object value = given[name];
      if constexpr (std::is_same_v<decltype(field), const pieper::General*&>) held = value;
      try {
        put(value, field);
      } catch (const nb::python_error&) {
        throw;
      } catch (const std::exception& e) {
        throw nb::value_error((std::string(Own::name) + "." + name + ": " + e.what()).c_str());
      }
      ++taken;
    });
    if (taken != given.size()) throw nb::type_error((std::string(Own::name) + " takes " + known + ".").c_str());
    if constexpr (std::is_same_v<Own, pieper::General>) pieper::isa().make_model(*this);
  }
  ~Bound() {
    if constexpr (std::is_same_v<Own, pieper::General>) pieper::isa().drop_model(*this);
  }
  Bound(const Bound&) = delete;
  Bound& operator=(const Bound&) = delete;

  nb::dict state() const {
    nb::dict out;
    Own::fields(*this, [&](const char* name, const auto& field) { out[name] = get(field); });
    return out;
  }
};

void put(nb::handle h, const pieper::General*& to) { to = h.is_none() ? nullptr : nb::cast<const Bound<pieper::General>*>(h); }
nb::object get(const pieper::General* v) {
  return v ? nb::find(*static_cast<const Bound<pieper::General>*>(v)) : nb::none();
}

template <class Own> nb::class_<Bound<Own>, pieper::Geometry> bind_family(nb::module_& m, const char* title, int family) {
  using B = Bound<Own>;
  nb::class_<B, pieper::Geometry> c(m, title, Own::doc);
  c.def("__init__", [family](B* self, nb::kwargs given) { new (self) B(family, given); });
  c.def("__getstate__", &B::state);
  c.def("__setstate__", [family](B& self, nb::dict given) { new (&self) B(family, given); });
  // nothing can change it: a copy is the same
  c.def("__copy__", [](nb::object self) { return self; });
  c.def("__deepcopy__", [](nb::object self, nb::handle) { return self; }, nb::arg("memo"));
  c.attr("name") = Own::name;
  c.attr("joints") = Own::joints;
  c.attr("slots") = Own::slots;
  alignas(B) static unsigned char blank[sizeof(B)];  // only the names are looked at
  Own::fields(*reinterpret_cast<const Own*>(blank), [&](const char* name, const auto&) {
    c.def_prop_ro(name, [name](const B& self) {
      nb::object found;
      Own::fields(static_cast<const Own&>(self), [&](const char* other, const auto& field) {
        if (std::strcmp(name, other) == 0) found = get(field);
      });
      return found;
    });
  });
  return c;
}

// Forward kinematics of one chain.
class Forward {
 public:
  Forward(nb::handle links, nb::handle prismatic, nb::handle after)
      : isa_(pieper::isa()),
        links_(to_vector<double>(links, NPY_DOUBLE)),
        prismatic_(to_vector<std::uint8_t>(prismatic, NPY_UINT8)),
        after_(to_vector<double>(after, NPY_DOUBLE)),
        n_(static_cast<int>(prismatic_.size())) {
    if (links_.size() != 16u * (n_ + 1) || after_.size() != 16u * n_)
      throw nb::value_error("links must be (n + 1, 4, 4), prismatic (n,) and frames_after (n, 4, 4).");
  }

  nb::tuple state() const {
    const npy_intp n = n_;
    nb::object prismatic = new_array(1, &n, NPY_UINT8);
    std::copy(prismatic_.begin(), prismatic_.end(), static_cast<std::uint8_t*>(PyArray_DATA(as_array(prismatic))));
    return nb::make_tuple(shown(links_.data(), {n + 1, 4, 4}), prismatic, shown(after_.data(), {n, 4, 4}));
  }

  nb::object fk(nb::handle q) const {
    const npy_intp tail[] = {4, 4};
    return run(q, tail, 2, [&](const double* in, long count, double* out) {
      isa_.fk(links_.data(), prismatic_.data(), n_, in, count, out);
    });
  }
  nb::object frames(nb::handle q, nb::handle base) const {
    const std::vector<double> b = to_vector<double>(base, NPY_DOUBLE);
    if (b.size() != 16) throw nb::value_error("base must be (4, 4).");
    const npy_intp tail[] = {n_ + 2, 4, 4};
    return run(q, tail, 3, [&](const double* in, long count, double* out) {
      isa_.frames(links_.data(), prismatic_.data(), n_, b.data(), after_.data(), in, count, out);
    });
  }
  nb::object jacobian(nb::handle q) const {
    const npy_intp tail[] = {6, n_};
    return run(q, tail, 2, [&](const double* in, long count, double* out) {
      isa_.jacobian(links_.data(), prismatic_.data(), n_, in, count, out);
    });
  }

 private:
  // q (..., n) -> an array (..., *tail). The caller has checked that q is finite.
  template <class Work> nb::object run(nb::handle given, const npy_intp* tail, int tail_size, Work work) const {
    nb::object q = float_array(given, "q");
    PyArrayObject* array = as_array(q);
    const int leading = PyArray_NDIM(array) - 1;
    if (leading < 0 || PyArray_DIM(array, leading) != n_ || leading + tail_size > NPY_MAXDIMS) {
      nb::dict data;
      raise_input_error("q must have shape (..., " + std::to_string(n_) + "), one number a joint, got " +
                            shape_text(array) + ".", data);
    }
    npy_intp shape[NPY_MAXDIMS];
    long count = 1;
    for (int i = 0; i < leading; ++i) {
      shape[i] = PyArray_DIM(array, i);
      count *= shape[i];
    }
    for (int i = 0; i < tail_size; ++i) shape[leading + i] = tail[i];
    nb::object out = new_array(leading + tail_size, shape, NPY_DOUBLE);
    double* data = static_cast<double*>(PyArray_DATA(as_array(out)));
    const double* in = doubles(q);
    if (count < 1000) {
      work(in, count, data);
    } else {
      nb::gil_scoped_release release;
      work(in, count, data);
    }
    return out;
  }

  const IsaTable& isa_;
  std::vector<double> links_;
  std::vector<std::uint8_t> prismatic_;
  std::vector<double> after_;
  int n_;
};

class PySolver {
 public:
  PySolver(nb::object geometry, nb::handle lower, nb::handle upper, nb::handle prismatic, double slack, double accepted, double exact)
      : geometry_(geometry),
        accepted_(accepted),
        solver_(*nb::cast<const pieper::Geometry*>(geometry), shifted(lower, -slack), shifted(upper, slack),
                to_vector<std::uint8_t>(prismatic, NPY_UINT8), accepted, exact) {}

  nb::object geometry() const { return geometry_; }

  nb::tuple many(nb::handle given, int threads) const {
    nb::object poses = float_array(given, "Ts");
    PyArrayObject* array = as_array(poses);
    if (PyArray_NDIM(array) != 3 || PyArray_DIM(array, 1) != 4 || PyArray_DIM(array, 2) != 4) {
      nb::dict data;
      raise_input_error("Ts must have shape (N, 4, 4), got " + shape_text(array) + ".", data);
    }
    const long count = PyArray_DIM(array, 0);
    const double* T = doubles(poses);
    pieper::BadPose bad{};
    bool proper, exact;
    {
      nb::gil_scoped_release release;
      proper = solver_.check(T, count, bad, exact);
    }
    if (!proper) refuse(bad, T, true);
    const npy_intp shape[] = {count, solver_.slots(), solver_.joints()};
    nb::object q = new_array(3, shape, NPY_DOUBLE), valid = new_array(2, shape, NPY_BOOL),
               in_limits = new_array(2, shape, NPY_BOOL), flag = new_array(1, shape, NPY_UINT8);
    bool finished;
    {
      nb::gil_scoped_release release;
      finished = solver_.solve(T, count, exact, threads, static_cast<double*>(PyArray_DATA(as_array(q))), bytes(valid),
                               bytes(in_limits), bytes(flag), [] {
                                 nb::gil_scoped_acquire acquire;
                                 return PyErr_CheckSignals() == 0;
                               });
    }
    if (!finished) throw nb::python_error();  // KeyboardInterrupt, or whatever the signal handler raised
    return nb::make_tuple(q, valid, in_limits, flag);
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

 private:
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
      message = which + " is left-handed (its rotation part has a negative determinant): a mirror, not a pose. Check the signs "
                        "and the order of its columns.";
    } else {
      message = which + " is not a pose: its rotation part or last row departs from a rigid motion by " + number + ", and at most " + limit +
                " is accepted. Check that it is not scaled, sheared or transposed, that angles were in radians and the last row is "
                "0 0 0 1.";
    }
    nb::dict data;
    data["index"] = bad.index;
    data["deviation"] = bad.deviation;
    raise_input_error(message, data);
  }

  static double determinant(const double* T) {
    return T[0] * (T[5] * T[10] - T[6] * T[9]) - T[1] * (T[4] * T[10] - T[6] * T[8]) + T[2] * (T[4] * T[9] - T[5] * T[8]);
  }

  nb::object geometry_;
  double accepted_;
  pieper::Solver solver_;
};

nb::object elementary(int what, nb::handle given) {
  nb::object x = float_array(given, "x");
  const npy_intp count = PyArray_SIZE(as_array(x)) / (what == 0 ? 1 : 2);
  const npy_intp shape[] = {count, 2};
  nb::object out = new_array(what == 0 ? 2 : 1, shape, NPY_DOUBLE);
  pieper::isa().elementary(what, doubles(x), count, static_cast<double*>(PyArray_DATA(as_array(out))));
  return out;
}

int import_numpy() {
  import_array1(-1);
  return 0;
}

}  // namespace

NB_MODULE(_kernel, m) {
  // arms that live as long as the program (a script's globals, caches) are no leaks
  nb::set_leak_warnings(false);
  if (import_numpy() < 0) throw nb::python_error();
  m.doc() = "The native kernels of pieper: forward kinematics and the inverse families, several poses per instruction.";
  m.attr("isa") = pieper::isa().name;
  m.attr("isa_available") = pieper::isa_names();
  m.attr("lanes") = pieper::isa().lanes;
  nb::enum_<pieper::Flag>(m, "Flag", nb::is_arithmetic(), nb::is_flag(), "What a solver says of a pose; bits of `flag`.")
      .value("DEGENERATE", pieper::Flag::DEGENERATE, "So near a singular pose that self-motions or merged roots are possible.")
      .value("UNCERTAIN", pieper::Flag::UNCERTAIN, "The family cannot vouch that nothing is missing.")
      .value("OUT_OF_REACH", pieper::Flag::OUT_OF_REACH, "No solution, for reasons of reach.")
      .value("ROUNDED", pieper::Flag::ROUNDED, "The rotation was replaced by the nearest exact one.")
      .value("NO_ARM_ANGLE", pieper::Flag::NO_ARM_ANGLE, "The arm angle is undefined here.")
      .value("COUNT_CHANGES", pieper::Flag::COUNT_CHANGES, "The arm as described has another number of solutions here than the one solved.")
      .value("AT_ARM_ANGLE", pieper::Flag::AT_ARM_ANGLE, "Solved at a chosen arm angle.");

  nb::class_<Forward>(m, "Forward", "Forward kinematics of a chain: links (n + 1, 4, 4), prismatic (n,), frames_after (n, 4, 4).")
      .def(nb::init<nb::handle, nb::handle, nb::handle>(), nb::arg("links"), nb::arg("prismatic"), nb::arg("frames_after"))
      .def("__getstate__", &Forward::state)
      .def("__setstate__", [](Forward& self, nb::tuple s) { new (&self) Forward(s[0], s[1], s[2]); })
      .def("fk", &Forward::fk, nb::arg("q"), "Poses (..., 4, 4) of q (..., n).")
      .def("frames", &Forward::frames, nb::arg("q"), nb::arg("base"), "Frames (..., n + 2, 4, 4) of q (..., n).")
      .def("jacobian", &Forward::jacobian, nb::arg("q"), "Jacobians (..., 6, n) of q (..., n), linear rows first.");

  nb::class_<pieper::Geometry>(m, "Geometry", "What a family is told of an arm: made from keyword arguments, unchangeable, picklable.");
  int family = 0;
#define PIEPER_FAMILY(name) [[maybe_unused]] auto name = bind_family<pieper::name>(m, #name, family++);
#include "families.def"
#undef PIEPER_FAMILY
  General
      .def_prop_ro("trials", [](const Bound<pieper::General>& self) { return get(self.trials); },
                   "(24, 4): rank, missed, open, noise of every hand-out of roles (shift, direction, swap).")
      .def_prop_ro("usable", [](const Bound<pieper::General>& self) { return self.usable; }, "How many ways are of use.");

  nb::class_<PySolver>(m, "Solver", "Every solution of poses by the kernel of one family.")
      .def(nb::init<nb::object, nb::handle, nb::handle, nb::handle, double, double, double>(), nb::arg("geometry"), nb::kw_only(),
           nb::arg("lower"), nb::arg("upper"), nb::arg("prismatic"), nb::arg("slack"), nb::arg("accepted"), nb::arg("exact"))
      .def_prop_ro("geometry", &PySolver::geometry)
      .def("many", &PySolver::many, nb::arg("Ts"), nb::arg("threads") = 1,
           "(N, 4, 4) -> q (N, slots, joints), valid, in_limits (N, slots), flag (N,). threads 0: all cores.")
      .def("one", &PySolver::one, nb::arg("T"),
           "(4, 4) -> q (m, joints) of the valid slots in order, slots (m,), in_limits (m,), flag.");

  m.def("sincos", [](nb::handle x) { return elementary(0, x); }, nb::arg("x"), "(N,) -> (N, 2) sine and cosine, for tests.");
  m.def("atan2", [](nb::handle yx) { return elementary(1, yx); }, nb::arg("yx"), "(N, 2) y, x -> (N,), for tests.");
}
