// What a call is handed most often, looked at in one go: an array that needs neither words nor a copy.
#pragma once

#include <cmath>

#include "binding/arrays.hpp"
#include "dispatch/isa.hpp"

namespace {

// The array itself where it is a C-contiguous one of float64, else null.
PyArrayObject* plain_array(nb::handle given) {
  if (!PyArray_CheckExact(given.ptr())) return nullptr;
  PyArrayObject* array = reinterpret_cast<PyArrayObject*>(given.ptr());
  return PyArray_TYPE(array) == NPY_DOUBLE && PyArray_ISCARRAY_RO(array) ? array : nullptr;
}

// Numbers that are looked at one by one; NumPy looks at more of them faster, with the widest registers there are.
inline constexpr npy_intp kFew = 1024;

bool usual_joints(nb::handle given, npy_intp n, double below) {
  PyArrayObject* q = plain_array(given);
  const int axes = q ? PyArray_NDIM(q) : 0;
  if (!axes || PyArray_DIM(q, axes - 1) != n || PyArray_SIZE(q) > kFew) return false;
  const double* x = static_cast<const double*>(PyArray_DATA(q));
  return std::all_of(x, x + PyArray_SIZE(q), [&](double value) { return std::fabs(value) < below; });
}

bool exact_poses(nb::handle given, double exact, double farthest) {
  PyArrayObject* T = plain_array(given);
  const int axes = T ? PyArray_NDIM(T) : 0;
  if (axes < 2 || PyArray_DIM(T, axes - 1) != 4 || PyArray_DIM(T, axes - 2) != 4) return false;
  constexpr npy_intp kAtOnce = 64;
  double deviation[kAtOnce];
  const npy_intp count = PyArray_SIZE(T) / 16;
  const double* pose = static_cast<const double*>(PyArray_DATA(T));
  for (npy_intp first = 0; first < count; first += kAtOnce) {
    const npy_intp some = std::min(kAtOnce, count - first);
    if (!(pieper::isa().deviation(pose + 16 * first, some, deviation) <= exact)) return false;
    for (npy_intp i = first; i < first + some; ++i)
      for (int k = 0; k < 3; ++k)
        if (!(std::fabs(pose[16 * i + 4 * k + 3]) <= farthest)) return false;
  }
  return true;
}

void bind_usual(nb::module_& m) {
  m.def("usual_joints", &usual_joints, nb::arg("q").none(), nb::arg("n"), nb::arg("below"),
        "Whether q is a plain float64 array (..., n) of few numbers, all below a bound in size.");
  m.def(
      "exact_poses", &exact_poses, nb::arg("T").none(), nb::arg("exact"), nb::arg("farthest"),
      "Whether T is a plain float64 array (..., 4, 4) of rigid motions that are exact, none farther than a bound, m.");
}

}  // namespace
