// How rows are compared with a joint vector, as Python holds it, and arrays that are written into.
#pragma once

#include "binding/arrays.hpp"
#include "dispatch/isa.hpp"

namespace {

// An array to write into: of this type and size, in C order and writable. The caller has told the user what it must be.
template <class T> T* target(nb::handle given, int type, npy_intp size, const char* what) {
  if (!PyArray_Check(given.ptr())) throw nb::value_error((std::string(what) + " must be an array.").c_str());
  PyArrayObject* array = reinterpret_cast<PyArrayObject*>(given.ptr());
  if (PyArray_TYPE(array) != type || PyArray_SIZE(array) != size || !PyArray_ISCARRAY(array))
    throw nb::value_error((std::string(what) + " must hold " + std::to_string(size) +
                           " entries of the right type, in C order and writable; its shape is " + shape_text(array) +
                           ".")
                              .c_str());
  return static_cast<T*>(PyArray_DATA(array));
}

class PySelection {
 public:
  PySelection(nb::handle lower, nb::handle upper, nb::handle weight, nb::handle prismatic)
      : lower_(to_vector<double>(lower, NPY_DOUBLE)),
        upper_(to_vector<double>(upper, NPY_DOUBLE)),
        weight_(to_vector<double>(weight, NPY_DOUBLE)),
        prismatic_(to_vector<std::uint8_t>(prismatic, NPY_UINT8)) {
    const std::size_t n = lower_.size();
    if (upper_.size() != n || weight_.size() != n || prismatic_.size() != n)
      throw nb::value_error("lower, upper, weight and prismatic must have one entry a joint.");
    plain_ = {static_cast<int>(n), lower_.data(), upper_.data(), weight_.data(), prismatic_.data()};
  }
  PySelection(const PySelection&) = delete;
  PySelection& operator=(const PySelection&) = delete;

  const pieper::Selection& plain() const { return plain_; }

  // The stride of `near`, (n,) or (count, n).
  int stride(const nb::object& near, long count) const {
    PyArrayObject* array = as_array(near);
    const npy_intp size = PyArray_SIZE(array), n = plain_.n;
    if (PyArray_NDIM(array) == 1 && size == n) return 0;
    if (PyArray_NDIM(array) != 2 || PyArray_DIM(array, 0) != count || PyArray_DIM(array, 1) != n)
      throw nb::value_error(("near must have shape (n,) or (N, n), got " + shape_text(array) + ".").c_str());
    return static_cast<int>(n);
  }

  void choose(nb::handle given, nb::handle inside, nb::handle to, nb::handle chosen, nb::handle has) const {
    const Rows rows = read(given, inside);
    nb::object near = float_array(to, "near");
    const int step = stride(near, rows.count);
    double* out = target<double>(chosen, NPY_DOUBLE, rows.count * plain_.n, "chosen");
    std::uint8_t* found = target<std::uint8_t>(has, NPY_BOOL, rows.count, "has");
    nb::gil_scoped_release release;
    pieper::isa().choose(plain_, rows.q, rows.inside, rows.count, rows.slots, doubles(near), step, out, found);
  }

  void in_turn(nb::handle given, nb::handle inside, nb::handle start, nb::handle chosen, nb::handle has) const {
    const Rows rows = read(given, inside);
    std::vector<double> now(plain_.n, 0.0);
    bool started = !start.is_none();
    if (started) {
      nb::object at = float_array(start, "start");
      if (stride(at, -1) != 0) throw nb::value_error("start must have shape (n,).");
      now.assign(doubles(at), doubles(at) + plain_.n);
    }
    double* out = target<double>(chosen, NPY_DOUBLE, rows.count * plain_.n, "chosen");
    std::uint8_t* found = target<std::uint8_t>(has, NPY_BOOL, rows.count, "has");
    nb::gil_scoped_release release;
    pieper::isa().choose_in_turn(plain_, rows.q, rows.inside, rows.count, rows.slots, now.data(), &started, out, found);
  }

 private:
  struct Rows {
    nb::object held;
    const double* q;
    const std::uint8_t* inside;
    long count;
    int slots;
  };
  Rows read(nb::handle given, nb::handle inside) const {
    nb::object q = float_array(given, "q");
    PyArrayObject* array = as_array(q);
    if (PyArray_NDIM(array) != 3 || PyArray_DIM(array, 2) != plain_.n)
      throw nb::value_error(("q must have shape (N, slots, n), got " + shape_text(array) + ".").c_str());
    const long count = PyArray_DIM(array, 0), slots = PyArray_DIM(array, 1);
    return {q, doubles(q), target<std::uint8_t>(inside, NPY_BOOL, count * slots, "inside"), count,
            static_cast<int>(slots)};
  }

  std::vector<double> lower_, upper_, weight_;
  std::vector<std::uint8_t> prismatic_;
  pieper::Selection plain_;
};

}  // namespace
