// A family's geometry in Python: its fields as keyword arguments, as attributes and as a state to be pickled.
#pragma once

#include <cstring>
#include <type_traits>

#include "binding/arrays.hpp"
#include "dispatch/isa.hpp"
#include "family_headers.hpp"

namespace {

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
  if (!fits)
    throw nb::value_error(
        ("must have shape (" + wanted.substr(0, wanted.size() - 2) + "), got " + shape_text(a) + ".").c_str());
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

void put(nb::handle h, const pieper::General*& to) {
  to = h.is_none() ? nullptr : nb::cast<const Bound<pieper::General>*>(h);
}
nb::object get(const pieper::General* v) {
  return v ? nb::find(*static_cast<const Bound<pieper::General>*>(v)) : nb::none();
}

template <class Own>
nb::class_<Bound<Own>, pieper::Geometry> bind_family(nb::module_& m, const char* title, int family) {
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

}  // namespace
