// NumPy arrays in and out of the binding, and the error that a wrong one raises.
//
// Arrays come and go through NumPy's C interface: making one costs 60 ns there, and a single pose is solved in less
// than a microsecond.
#pragma once

#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <numpy/arrayobject.h>

#include <algorithm>
#include <string>
#include <vector>

namespace nb = nanobind;

namespace {

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
    const nb::object kind = given.type().attr("__name__");
    data["given"] = kind;
    raise_input_error(std::string(what) + " must be numbers in an array, got " + nb::cast<std::string>(kind) + ".",
                      data);
  }
  return nb::steal(array);
}

PyArrayObject* as_array(const nb::object& o) { return reinterpret_cast<PyArrayObject*>(o.ptr()); }
const double* doubles(const nb::object& o) { return static_cast<const double*>(PyArray_DATA(as_array(o))); }

std::string shape_text(PyArrayObject* array) {
  std::string text = "(";
  for (int i = 0; i < PyArray_NDIM(array); ++i) text += (i ? ", " : "") + std::to_string(PyArray_DIM(array, i));
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

}  // namespace
