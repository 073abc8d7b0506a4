// Distances between bodies and the swept proof as Python sees them.
#pragma once

#include <utility>

#include "binding/chain.hpp"
#include "dispatch/isa.hpp"

namespace {

// The bodies of an arm and of what stands around it, and the pairs that must keep apart. The chain stays where it is.
class Collision {
 public:
  Collision(const Forward& arm, nb::handle link, nb::handle place, nb::handle half, nb::handle radius, nb::handle kind,
            nb::handle pair, nb::handle outer)
      : place_(to_vector<double>(place, NPY_DOUBLE)),
        half_(to_vector<double>(half, NPY_DOUBLE)),
        radius_(to_vector<double>(radius, NPY_DOUBLE)),
        kind_(to_vector<std::uint8_t>(kind, NPY_UINT8)),
        outer_(to_vector<std::uint8_t>(outer, NPY_UINT8)),
        link_(to_vector<int>(link, NPY_INT)),
        pair_(to_vector<int>(pair, NPY_INT)),
        isa_(pieper::isa()) {
    const pieper::PlainChain chain = arm.plain();
    const std::size_t n = chain.n, bodies = link_.size(), pairs = outer_.size();
    if (place_.size() != 16 * bodies || half_.size() != 3 * bodies || radius_.size() != bodies ||
        kind_.size() != bodies || pair_.size() != 2 * pairs)
      throw nb::value_error("arrays of a collision model have sizes that do not fit each other.");
    for (std::size_t k = 0; k < bodies; ++k)
      if (link_[k] < 0 || link_[k] > static_cast<int>(n) || kind_[k] > 2)
        throw nb::value_error("a body is on a link or of a kind that there is not.");
    // bodies are walked in the order of their links
    for (std::size_t k = 0, moving = 0; k < bodies; ++k) {
      if (link_[k] == 0) continue;
      if (link_[k] < static_cast<int>(moving))
        throw nb::value_error("bodies that move must be in the order of their links.");
      moving = static_cast<std::size_t>(link_[k]);
    }
    for (std::size_t k = 0; k < pairs; ++k) {
      const int i = pair_[2 * k], j = pair_[2 * k + 1];
      if (i < 0 || j < 0 || i >= static_cast<int>(bodies) || j >= static_cast<int>(bodies) || link_[i] <= link_[j])
        throw nb::value_error("of a pair the first body must be on the higher link.");
    }
    model_ = {
        static_cast<int>(n), chain.links,    chain.prismatic, static_cast<int>(bodies), link_.data(), place_.data(),
        half_.data(),        radius_.data(), kind_.data(),    static_cast<int>(pairs),  pair_.data(), outer_.data()};
  }
  Collision(const Collision&) = delete;
  Collision& operator=(const Collision&) = delete;

  int pairs() const { return model_.pairs; }

  nb::tuple nearest(nb::handle given, bool points) const {
    nb::object q = joints(given);
    const npy_intp count = PyArray_DIM(as_array(q), 0), shape[] = {count, 2, 3};
    nb::object distance = new_array(1, &count, NPY_DOUBLE), pair = new_array(1, &count, NPY_INT);
    nb::object at = points ? new_array(3, shape, NPY_DOUBLE) : nb::none(), normal = nb::none();
    const npy_intp flat[] = {count, 3};
    if (points) normal = new_array(2, flat, NPY_DOUBLE);
    run(q, distance, pair, points ? numbers(at) : nullptr, points ? numbers(normal) : nullptr, nullptr);
    return nb::make_tuple(distance, pair, at, normal);
  }

  nb::object each(nb::handle given) const {
    nb::object q = joints(given);
    const npy_intp count = PyArray_DIM(as_array(q), 0), shape[] = {count, model_.pairs};
    nb::object distance = new_array(1, &count, NPY_DOUBLE), pair = new_array(1, &count, NPY_INT),
               out = new_array(2, shape, NPY_DOUBLE);
    run(q, distance, pair, nullptr, nullptr, numbers(out));
    return out;
  }

  nb::tuple sweep(nb::handle given, double margin, double gap, double slack) const {
    nb::object q = joints(given);
    std::vector<double> room(static_cast<std::size_t>(isa_.sweep_bytes(model_)) / sizeof(double) + 1);
    std::vector<int> lists(static_cast<std::size_t>(isa_.sweep_levels()) * model_.pairs);
    std::vector<std::pair<long, int>> open;
    const pieper::OuterPairs outer = {&open, [](void* context, long segment, int pair) {
                                        static_cast<std::vector<std::pair<long, int>>*>(context)->emplace_back(segment,
                                                                                                               pair);
                                      }};
    pieper::Sweep found;
    {
      const double* in = doubles(q);
      const long count = PyArray_DIM(as_array(q), 0);
      nb::gil_scoped_release release;
      found = isa_.collision_sweep(model_, in, count, margin, gap, slack, room.data(), lists.data(), outer);
    }
    nb::list left;
    for (const auto& [segment, pair] : open) left.append(nb::make_tuple(segment, pair));
    return nb::make_tuple(found.hit, found.hit_s, found.hit_pair, found.hit_distance, found.doubtful, found.doubtful_s,
                          found.doubtful_pair, found.doubtful_distance, found.evaluated, left);
  }

 private:
  static double* numbers(const nb::object& o) { return static_cast<double*>(PyArray_DATA(as_array(o))); }
  nb::object joints(nb::handle given) const {
    nb::object q = float_array(given, "q");
    if (PyArray_NDIM(as_array(q)) != 2 || PyArray_DIM(as_array(q), 1) != model_.n)
      throw nb::value_error("q must be (N, n).");
    return q;
  }
  void run(const nb::object& q, const nb::object& distance, const nb::object& pair, double* points, double* normal,
           double* each) const {
    if (model_.pairs == 0) throw nb::value_error("there is no pair to look at.");
    // lanes of eight at most, and a pose and a vector of them a body
    std::vector<double> room(static_cast<std::size_t>(model_.bodies) * 15 * 8 + 16);
    int* pairs = static_cast<int*>(PyArray_DATA(as_array(pair)));
    const double* in = doubles(q);
    const long count = PyArray_DIM(as_array(q), 0);
    nb::gil_scoped_release release;
    isa_.collision_nearest(model_, in, count, room.data(), numbers(distance), pairs, points, normal, each);
  }

  std::vector<double> place_, half_, radius_;
  std::vector<std::uint8_t> kind_, outer_;
  std::vector<int> link_, pair_;
  const pieper::IsaTable& isa_;
  pieper::CollisionModel model_;
};

void bind_collision(nb::module_& m) {
  nb::class_<Collision>(m, "Collision", "Bodies on a chain and around it, and the pairs of them that must keep apart.")
      .def(nb::init<const Forward&, nb::handle, nb::handle, nb::handle, nb::handle, nb::handle, nb::handle,
                    nb::handle>(),
           nb::keep_alive<1, 2>(), nb::arg("chain"), nb::kw_only(), nb::arg("link"), nb::arg("place"), nb::arg("half"),
           nb::arg("radius"), nb::arg("kind"), nb::arg("pair"), nb::arg("outer"))
      .def_prop_ro("pairs", &Collision::pairs)
      .def("nearest", &Collision::nearest, nb::arg("q"), nb::arg("points") = true,
           "(N, n) -> distance (N,), pair (N,), points (N, 2, 3) and normal (N, 3), or None.")
      .def("each", &Collision::each, nb::arg("q"), "(N, n) -> distances (N, pairs).")
      .def("sweep", &Collision::sweep, nb::arg("q"), nb::arg("margin"), nb::arg("gap"), nb::arg("slack"),
           "(N, n) -> hit, its s, pair, distance; doubtful places, the first one's s, pair, distance; postures looked "
           "at; [(segment, pair)] on which enclosing pairs are not proved clear.");
}

}  // namespace
