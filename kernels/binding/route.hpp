// Ladders and chains of small systems, as Python sees them.
#pragma once

#include "binding/chain.hpp"
#include "route/chain_of_blocks.hpp"
#include "route/front.hpp"
#include "route/ladder.hpp"

namespace {

nb::object array_of(nb::handle given, int type) {
  PyObject* array = PyArray_FROM_OTF(given.ptr(), type, NPY_ARRAY_IN_ARRAY | NPY_ARRAY_FORCECAST);
  if (!array) throw nb::python_error();
  return nb::steal(array);
}

template <class T> const T* data_of(const nb::object& o) { return static_cast<const T*>(PyArray_DATA(as_array(o))); }

nb::tuple ladder(nb::handle q, nb::handle valid, nb::handle limits, nb::handle circle, nb::handle weights,
                 nb::handle longest, nb::handle parts, nb::handle near, nb::handle spot, nb::handle on_spot,
                 bool largest, double slack, nb::handle first, nb::handle last) {
  nb::object Q = float_array(q, "q"), V = array_of(valid, NPY_BOOL), B = float_array(limits, "limits"),
             C = array_of(circle, NPY_BOOL), W = float_array(weights, "weights"), S = float_array(longest, "longest"),
             P = float_array(parts, "parts"), N = array_of(near, NPY_INT32), M = array_of(spot, NPY_INT32),
             O = float_array(on_spot, "on_spot"), F = array_of(first, NPY_INT32), L = array_of(last, NPY_INT32);
  if (PyArray_NDIM(as_array(Q)) != 4 || PyArray_NDIM(as_array(N)) != 2 || PyArray_NDIM(as_array(M)) != 2)
    throw nb::value_error("q must be (rungs, cells, rows, joints), near and spot (cells, ...).");
  const npy_intp* shape = PyArray_DIMS(as_array(Q));
  const npy_intp rungs = shape[0], cells = shape[1], rows = shape[2], n = shape[3];
  if (rungs < 1 || n < 1 || PyArray_SIZE(as_array(V)) != rungs * cells * rows || PyArray_SIZE(as_array(B)) != 2 * n ||
      PyArray_SIZE(as_array(C)) != n || PyArray_SIZE(as_array(W)) != n ||
      PyArray_SIZE(as_array(S)) != (rungs - 1) * n || PyArray_SIZE(as_array(P)) != rungs - 1 ||
      PyArray_DIM(as_array(N), 0) != cells || PyArray_DIM(as_array(M), 0) != cells || PyArray_SIZE(as_array(O)) != n ||
      PyArray_SIZE(as_array(F)) != n || PyArray_SIZE(as_array(L)) != n)
    throw nb::value_error("a ladder's arrays do not fit together.");
  std::vector<double> lower(n), upper(n);
  for (npy_intp j = 0; j < n; ++j) lower[j] = doubles(B)[2 * j], upper[j] = doubles(B)[2 * j + 1];
  const pieper::Ladder told{rungs,
                            cells,
                            static_cast<int>(rows),
                            static_cast<int>(n),
                            static_cast<int>(PyArray_DIM(as_array(N), 1)),
                            static_cast<int>(PyArray_DIM(as_array(M), 1)),
                            doubles(Q),
                            data_of<std::uint8_t>(V),
                            lower.data(),
                            upper.data(),
                            data_of<std::uint8_t>(C),
                            doubles(W),
                            doubles(S),
                            doubles(P),
                            data_of<std::int32_t>(N),
                            data_of<std::int32_t>(M),
                            doubles(O),
                            largest,
                            slack,
                            data_of<std::int32_t>(F),
                            data_of<std::int32_t>(L)};
  pieper::Climbed found;
  {
    nb::gil_scoped_release release;
    found = pieper::Climb(told).run();
  }
  const npy_intp path[2] = {static_cast<npy_intp>(found.rung.size()), n};
  nb::object out = new_array(2, path, NPY_DOUBLE), at = new_array(1, path, NPY_INT64);
  std::copy(found.q.begin(), found.q.end(), static_cast<double*>(PyArray_DATA(as_array(out))));
  std::copy(found.rung.begin(), found.rung.end(), static_cast<std::int64_t*>(PyArray_DATA(as_array(at))));
  return nb::make_tuple(out, at, found.cost, found.furthest, found.edges);
}

nb::tuple chain_of_blocks(nb::handle diagonal, nb::handle beside, nb::handle right) {
  nb::object D = float_array(diagonal, "diagonal"), E = float_array(beside, "beside"), R = float_array(right, "right");
  if (PyArray_NDIM(as_array(D)) != 3 || PyArray_DIM(as_array(D), 1) != PyArray_DIM(as_array(D), 2))
    throw nb::value_error("diagonal must be (N, d, d).");
  const npy_intp count = PyArray_DIM(as_array(D), 0), d = PyArray_DIM(as_array(D), 1);
  if (count < 1 || PyArray_SIZE(as_array(E)) != (count - 1) * d * d || PyArray_SIZE(as_array(R)) != count * d)
    throw nb::value_error("beside must be (N - 1, d, d) and right (N, d).");
  const npy_intp shape[2] = {count, d};
  nb::object x = new_array(2, shape, NPY_DOUBLE);
  const bool positive = pieper::chain_of_blocks(doubles(D), doubles(E), doubles(R), count, static_cast<int>(d),
                                                static_cast<double*>(PyArray_DATA(as_array(x))));
  return nb::make_tuple(x, positive);
}

nb::tuple front(const Forward& arm, nb::handle joints, nb::handle limits, nb::handle poses, nb::handle axis,
                nb::handle angle, nb::handle seeds, double fine, std::int64_t most) {
  const auto b = to_vector<double>(limits, NPY_DOUBLE), T = to_vector<double>(poses, NPY_DOUBLE),
             u = to_vector<double>(axis, NPY_DOUBLE), t = to_vector<double>(angle, NPY_DOUBLE),
             q = to_vector<double>(seeds, NPY_DOUBLE), combined = to_vector<double>(joints, NPY_DOUBLE);
  const pieper::PlainChain chain = arm.plain();
  const std::size_t n = chain.n, N = T.size() / 16;
  if (n < 6 || n > 7 || b.size() != 2 * n || N < 1 || T.size() != 16 * N || u.size() != 3 * (N - 1) ||
      t.size() != N - 1 || q.size() % n || combined.size() != n * n)
    throw nb::value_error("a front's arrays do not fit together.");
  std::vector<double> lower(n), upper(n);
  for (std::size_t j = 0; j < n; ++j) lower[j] = b[2 * j], upper[j] = b[2 * j + 1];
  const pieper::FrontAsked asked{chain.n,
                                 chain.links,
                                 chain.prismatic,
                                 chain.length,
                                 combined.data(),
                                 lower.data(),
                                 upper.data(),
                                 static_cast<std::int64_t>(N),
                                 T.data(),
                                 u.data(),
                                 t.data(),
                                 static_cast<std::int64_t>(q.size() / n),
                                 q.data(),
                                 fine,
                                 most};
  pieper::FrontFound found;
  {
    nb::gil_scoped_release release;
    found = pieper::front(asked);
  }
  const npy_intp shape[2] = {static_cast<npy_intp>(found.within.size()), static_cast<npy_intp>(n)};
  nb::object rows = new_array(2, shape, NPY_DOUBLE), within = new_array(1, shape, NPY_DOUBLE);
  std::copy(found.q.begin(), found.q.end(), static_cast<double*>(PyArray_DATA(as_array(rows))));
  std::copy(found.within.begin(), found.within.end(), static_cast<double*>(PyArray_DATA(as_array(within))));
  const npy_intp count = static_cast<npy_intp>(found.stretch.size());
  nb::object stretch = new_array(1, &count, NPY_INT64);
  std::copy(found.stretch.begin(), found.stretch.end(), static_cast<std::int64_t*>(PyArray_DATA(as_array(stretch))));
  return nb::make_tuple(static_cast<int>(found.end), found.at, found.rows_at, rows, within, stretch, found.looked,
                        found.narrowest);
}

void bind_route(nb::module_& m) {
  m.def("front", &front, nb::arg("chain"), nb::kw_only(), nb::arg("joints"), nb::arg("limits"), nb::arg("poses"),
        nb::arg("axis"), nb::arg("angle"), nb::arg("seeds"), nb::arg("fine"), nb::arg("most"),
        "How it ended (0 died, 1 arrived, 2 singular, 3 tired), where, where it was last told, its points there (k, n) "
        "and "
        "how far each stands for (k,), points of each stretch (below zero: closed), points looked at, the narrowest.");
  m.def("ladder", &ladder, nb::kw_only(), nb::arg("q"), nb::arg("valid"), nb::arg("limits"), nb::arg("circle"),
        nb::arg("weights"), nb::arg("longest"), nb::arg("parts"), nb::arg("near"), nb::arg("spot"), nb::arg("on_spot"),
        nb::arg("largest"), nb::arg("slack"), nb::arg("first"), nb::arg("last"),
        "The cheapest chain (k, n), its rungs (k,), its cost, the last rung reached, the steps looked at.");
  m.def("chain_of_blocks", &chain_of_blocks, nb::arg("diagonal"), nb::arg("beside"), nb::arg("right"),
        "(N, d, d), (N - 1, d, d), (N, d) -> (N, d) and whether the symmetric matrix is positive definite.");
}

}  // namespace
