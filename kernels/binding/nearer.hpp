// The descent to a pose that is out of reach, as Python sees it.
#pragma once

#include "binding/chain.hpp"
#include "chain/closest.hpp"

namespace {

// A chain and its limits as the descents take them, with what keeps the numbers alive.
struct Downward {
  std::vector<double> low, high, C;
  pieper::DownhillChain chain;

  Downward(const Forward& arm, nb::handle coupling, nb::handle lower, nb::handle upper)
      : low(to_vector<double>(lower, NPY_DOUBLE)),
        high(to_vector<double>(upper, NPY_DOUBLE)),
        C(coupling.is_none() ? std::vector<double>() : to_vector<double>(coupling, NPY_DOUBLE)),
        chain{arm.plain(), C.empty() ? nullptr : C.data(), low.data(), high.data()} {
    const std::size_t n = chain.n;
    if (low.size() != n || high.size() != n || (!C.empty() && C.size() != n * n))
      throw nb::value_error("lower and upper must be (n,), coupling (n, n).");
  }
};

// A table of so many columns; how many rows it has.
npy_intp rows_of(const nb::object& table, npy_intp columns) {
  const npy_intp size = PyArray_SIZE(as_array(table));
  if (size % columns) throw nb::value_error("q must be (k, n), poses (k, 4, 4), stages (k, 3).");
  return size / columns;
}

nb::tuple nearer(const Forward& arm, nb::handle coupling, nb::handle lower, nb::handle upper, nb::handle given,
                 nb::handle pose, nb::handle turning, int steps) {
  const Downward down(arm, coupling, lower, upper);
  const nb::object by = float_array(turning, "turning"), T = float_array(pose, "T"), starts = float_array(given, "q");
  const npy_intp n = down.chain.n, count = rows_of(starts, n);
  if (PyArray_SIZE(as_array(T)) != 16 || PyArray_NDIM(as_array(starts)) != 2 || PyArray_SIZE(as_array(by)) != count)
    throw nb::value_error("q must be (k, n), turning (k,), T (4, 4).");
  nb::object q = new_array(2, PyArray_DIMS(as_array(starts)), NPY_DOUBLE), value = new_array(1, &count, NPY_DOUBLE);
  double *rows = static_cast<double*>(PyArray_DATA(as_array(q))),
         *left = static_cast<double*>(PyArray_DATA(as_array(value)));
  std::copy(doubles(starts), doubles(starts) + count * n, rows);
  {
    nb::gil_scoped_release release;
    pieper::nearer(down.chain, doubles(T), count, doubles(by), steps, rows, left);
  }
  return nb::make_tuple(q, value);
}

std::vector<pieper::Stage> stages_of(nb::handle given) {
  const nb::object table = float_array(given, "stages");
  const npy_intp count = rows_of(table, 3);
  std::vector<pieper::Stage> out;
  for (const double* row = doubles(table); row < doubles(table) + 3 * count; row += 3)
    out.push_back({row[0], static_cast<int>(row[1]), static_cast<int>(row[2])});
  return out;
}

nb::object closest(const Forward& arm, nb::handle coupling, nb::handle lower, nb::handle upper, nb::handle looked_at,
                   nb::handle looked_at_poses, nb::handle given, nb::handle pose, bool turning, nb::handle stages,
                   nb::handle back, int starts, int spread, int turned, int more, int more_kept, int few_steps,
                   int in_place, int led_back, int alike, int last_steps, nb::handle near, nb::handle crawl) {
  const Downward down(arm, coupling, lower, upper);
  const nb::object q = float_array(looked_at, "q"), poses = float_array(looked_at_poses, "poses"),
                   seeds = float_array(given, "seeds"), T = float_array(pose, "T"), slow = float_array(crawl, "crawl"),
                   nearness = float_array(near, "near");
  if (PyArray_SIZE(as_array(slow)) != 5 || PyArray_SIZE(as_array(nearness)) != 4)
    throw nb::value_error("crawl must be (5,), near (4,).");
  const double *c = doubles(slow), *d = doubles(nearness);
  const npy_intp n = down.chain.n, count = rows_of(q, n);
  const pieper::Search how{starts,
                           spread,
                           turned,
                           more,
                           more_kept,
                           few_steps,
                           in_place,
                           led_back,
                           alike,
                           last_steps,
                           d[0],
                           d[1],
                           d[2],
                           d[3],
                           {static_cast<int>(c[0]), c[1], c[2], c[3], c[4]},
                           stages_of(stages),
                           stages_of(back)};
  if (PyArray_SIZE(as_array(T)) != 16 || rows_of(poses, 16) != count || how.stages.size() < 2)
    throw nb::value_error("q must be (k, n), poses (k, 4, 4), T (4, 4), stages two or more.");
  std::vector<double> found;
  {
    const pieper::Table table{static_cast<int>(count), doubles(q), doubles(poses)};
    nb::gil_scoped_release release;
    found = pieper::closest(down.chain, doubles(T), table, rows_of(seeds, n), doubles(seeds), how, turning);
  }
  const npy_intp shape[2] = {static_cast<npy_intp>(found.size()) / n, n};
  nb::object out = new_array(2, shape, NPY_DOUBLE);
  std::copy(found.begin(), found.end(), static_cast<double*>(PyArray_DATA(as_array(out))));
  return out;
}

void bind_nearer(nb::module_& m) {
  m.def("nearer", &nearer, nb::arg("chain"), nb::kw_only(), nb::arg("coupling").none(), nb::arg("lower"),
        nb::arg("upper"), nb::arg("q"), nb::arg("T"), nb::arg("turning"), nb::arg("steps"),
        "Downhill from q (k, n) to T (4, 4): (k, n) and what is left (k,).");
  m.def("closest", &closest, nb::arg("chain"), nb::kw_only(), nb::arg("coupling").none(), nb::arg("lower"),
        nb::arg("upper"), nb::arg("q"), nb::arg("poses"), nb::arg("seeds"), nb::arg("T"), nb::arg("turning"),
        nb::arg("stages"), nb::arg("back"), nb::arg("starts"), nb::arg("spread"), nb::arg("turned"), nb::arg("more"),
        nb::arg("more_kept"), nb::arg("few_steps"), nb::arg("in_place"), nb::arg("led_back"), nb::arg("alike"),
        nb::arg("last_steps"), nb::arg("near"), nb::arg("crawl"),
        "Postures (k, n) of which one comes nearest to T (4, 4), the position first.");
}

}  // namespace
