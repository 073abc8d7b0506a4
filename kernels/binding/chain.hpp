// A chain as Python holds it.
#pragma once

#include "binding/fields.hpp"
#include "chain/plain.hpp"
#include "dispatch/isa.hpp"

namespace {

// A chain: its forward kinematics, and what all other functions of a chain are given.
class Forward {
 public:
  Forward(nb::handle links, nb::handle prismatic, nb::handle after, double length)
      : isa_(pieper::isa()),
        links_(to_vector<double>(links, NPY_DOUBLE)),
        prismatic_(to_vector<std::uint8_t>(prismatic, NPY_UINT8)),
        after_(to_vector<double>(after, NPY_DOUBLE)),
        n_(static_cast<int>(prismatic_.size())),
        length_(length) {
    if (n_ == 0 || links_.size() != 16u * (n_ + 1) || after_.size() != 16u * n_)
      throw nb::value_error("links must be (n + 1, 4, 4), prismatic (n,) and frames_after (n, 4, 4).");
  }

  pieper::PlainChain plain() const { return {n_, length_, links_.data(), prismatic_.data()}; }

  nb::tuple state() const {
    const npy_intp n = n_;
    nb::object prismatic = new_array(1, &n, NPY_UINT8);
    std::copy(prismatic_.begin(), prismatic_.end(), static_cast<std::uint8_t*>(PyArray_DATA(as_array(prismatic))));
    return nb::make_tuple(shown(links_.data(), {n + 1, 4, 4}), prismatic, shown(after_.data(), {n, 4, 4}), length_);
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
      raise_input_error(
          "q must have shape (..., " + std::to_string(n_) + "), one number a joint, got " + shape_text(array) + ".",
          data);
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

  const pieper::IsaTable& isa_;
  std::vector<double> links_;
  std::vector<std::uint8_t> prismatic_;
  std::vector<double> after_;
  int n_;
  double length_;  // m, what lengths are compared with
};

void bind_chain(nb::module_& m) {
  nb::class_<Forward>(m, "Forward",
                      "A chain: links (n + 1, 4, 4), prismatic (n,), frames_after (n, 4, 4), m; its length, m.")
      .def(nb::init<nb::handle, nb::handle, nb::handle, double>(), nb::arg("links"), nb::arg("prismatic"),
           nb::arg("frames_after"), nb::arg("length"))
      .def("__getstate__", &Forward::state)
      .def("__setstate__",
           [](Forward& self, nb::tuple s) { new (&self) Forward(s[0], s[1], s[2], nb::cast<double>(s[3])); })
      .def("fk", &Forward::fk, nb::arg("q"), "Poses (..., 4, 4) of q (..., n).")
      .def("frames", &Forward::frames, nb::arg("q"), nb::arg("base"), "Frames (..., n + 2, 4, 4) of q (..., n).")
      .def("jacobian", &Forward::jacobian, nb::arg("q"), "Jacobians (..., 6, n) of q (..., n), linear rows first.");
}

}  // namespace
