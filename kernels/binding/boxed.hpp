// Descent inside limits, as Python sees it.
#pragma once

#include "binding/chain.hpp"
#include "chain/boxed.hpp"

namespace {

nb::tuple descend(const Forward& arm, nb::handle start, nb::handle poses, nb::handle lower, nb::handle upper, int steps,
                  int again, double longest, nb::handle damping, double done, int idle, double left) {
  const auto d = to_vector<double>(damping, NPY_DOUBLE);
  const pieper::PlainChain chain = arm.plain();
  const npy_intp n = chain.n;
  nb::object q = float_array(start, "q"), T = float_array(poses, "T"), low = float_array(lower, "lower"),
             high = float_array(upper, "upper");
  const npy_intp count = PyArray_NDIM(as_array(q)) == 2 ? PyArray_DIM(as_array(q), 0) : -1;
  const auto whole = [&](const nb::object& a) { return PyArray_SIZE(as_array(a)) == count * n; };
  if (count < 0 || !whole(q) || !whole(low) || !whole(high) || d.size() != 6 || PyArray_SIZE(as_array(T)) != 16 * count)
    throw nb::value_error("q, lower, upper must be (k, n), T (k, 4, 4), damping (6,).");
  const npy_intp shape[] = {count, n};
  nb::object out = new_array(2, shape, NPY_DOUBLE), missed = new_array(1, &count, NPY_DOUBLE);
  double *rows = static_cast<double*>(PyArray_DATA(as_array(out))),
         *off = static_cast<double*>(PyArray_DATA(as_array(missed)));
  std::copy(doubles(q), doubles(q) + count * n, rows);
  const pieper::Descent how{steps, again, longest, d[0], d[1], d[2], d[3], d[4], d[5], done, idle, left};
  {
    nb::gil_scoped_release release;
    pieper::descend(chain, how, count, doubles(T), doubles(low), doubles(high), rows, off);
  }
  return nb::make_tuple(out, missed);
}

void bind_boxed(nb::module_& m) {
  m.def("descend", &descend, nb::arg("chain"), nb::kw_only(), nb::arg("q"), nb::arg("T"), nb::arg("lower"),
        nb::arg("upper"), nb::arg("steps"), nb::arg("again"), nb::arg("longest"), nb::arg("damping"), nb::arg("done"),
        nb::arg("idle"), nb::arg("left"),
        "From q (k, n) towards T (k, 4, 4) inside boxes: (k, n), and what is missed (k,).");
}

}  // namespace
