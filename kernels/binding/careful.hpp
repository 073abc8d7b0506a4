// The look at singular poses as Python sees it.
#pragma once

#include <complex>

#include "binding/chain.hpp"
#include "binding/solver.hpp"
#include "singular/careful.hpp"

namespace {

class PyLinkage {
 public:
  PyLinkage(const Forward& arm, nb::handle through, nb::handle joints, nb::handle axes, nb::handle spots,
            nb::handle senses, int lead, double low, double high, int course) {
    const pieper::PlainChain chain = arm.plain();
    pieper::SelfMotionSaid said{};
    said.flat = !spots.is_none(), said.lead = lead, said.low = low, said.high = high, said.course = course;
    const auto q = to_vector<double>(through, NPY_DOUBLE), z = to_vector<double>(axes, NPY_DOUBLE),
               turns = to_vector<double>(senses, NPY_DOUBLE);
    const auto which = to_vector<std::int64_t>(joints, NPY_INT64);
    if (chain.n != 6 || q.size() != 6 || z.size() != 12 || turns.size() != 4 || which.size() != 4)
      throw nb::value_error("the chain must have six joints, through be (6,), axes (4, 3), senses and joints (4,).");
    std::copy(q.begin(), q.end(), said.through);
    std::copy(z.begin(), z.end(), &said.axes[0][0]);
    std::copy(turns.begin(), turns.end(), said.senses);
    for (int k = 0; k < 4; ++k) said.joints[k] = static_cast<int>(which[k]);
    if (said.flat) {
      const auto at = to_vector<std::complex<double>>(spots, NPY_CDOUBLE);
      if (at.size() != 4) throw nb::value_error("spots must be (4,).");
      for (int k = 0; k < 4; ++k) said.spots[k][0] = at[k].real(), said.spots[k][1] = at[k].imag();
    }
    linkage_ = std::make_unique<pieper::Linkage>(said, chain.prismatic, chain.length);
  }

  nb::object points(nb::handle given) const {
    const auto u = to_vector<double>(given, NPY_DOUBLE);
    const npy_intp shape[] = {static_cast<npy_intp>(u.size()), 6};
    nb::object out = new_array(2, shape, NPY_DOUBLE);
    for (std::size_t k = 0; k < u.size(); ++k)
      linkage_->point(u[k], static_cast<double*>(PyArray_DATA(as_array(out))) + 6 * k);
    return out;
  }
  double place(nb::handle given) const {
    const auto q = to_vector<double>(given, NPY_DOUBLE);
    if (q.size() != 6) throw nb::value_error("q must be (6,).");
    return linkage_->place(q.data());
  }
  nb::object inside(nb::handle lower, nb::handle upper) const {
    const auto low = to_vector<double>(lower, NPY_DOUBLE), high = to_vector<double>(upper, NPY_DOUBLE);
    if (low.size() != 6 || high.size() != 6) throw nb::value_error("lower and upper must be (6,).");
    const std::vector<double> ends = linkage_->inside(low.data(), high.data());
    const npy_intp shape[] = {static_cast<npy_intp>(ends.size() / 2), 2};
    nb::object out = new_array(2, shape, NPY_DOUBLE);
    std::copy(ends.begin(), ends.end(), static_cast<double*>(PyArray_DATA(as_array(out))));
    return out;
  }

 private:
  std::unique_ptr<pieper::Linkage> linkage_;
};

class PyCarefulLook {
 public:
  PyCarefulLook(nb::object solver, const Forward& arm, nb::handle lower, nb::handle upper, bool closed_form)
      : solver_(solver) {
    const PySolver& own = *nb::cast<const PySolver*>(solver);
    const auto low = to_vector<double>(lower, NPY_DOUBLE), high = to_vector<double>(upper, NPY_DOUBLE);
    const pieper::PlainChain chain = arm.plain();
    if (chain.n != 6 || low.size() != 6 || high.size() != 6)
      throw nb::value_error("the chain must have six joints, lower and upper be (6,).");
    look_ = std::make_unique<pieper::CarefulLook>(own.solver(), chain.links, chain.prismatic, chain.length, low.data(),
                                                  high.data(), own.exact(), closed_form);
  }

  // None where what there is cannot be read off.
  nb::object one(nb::handle given, nb::handle known, int flag) const {
    nb::object pose = float_array(given, "T"), rows = float_array(known, "q");
    const npy_intp size = PyArray_SIZE(as_array(rows));
    if (PyArray_SIZE(as_array(pose)) != 16 || size % 6) throw nb::value_error("T must be (4, 4) and q (m, 6).");
    static thread_local pieper::CarefulPose found;
    if (!look_->look(doubles(pose), doubles(rows), static_cast<int>(size / 6), static_cast<std::uint8_t>(flag), found))
      return nb::none();
    const npy_intp shape[] = {found.count, 6};
    nb::object q = new_array(2, shape, NPY_DOUBLE), inside = new_array(1, shape, NPY_BOOL),
               singular = new_array(1, shape, NPY_BOOL), branches = new_array(1, shape, NPY_INT64),
               motion = new_array(1, shape, NPY_INT64);
    std::copy(found.q.begin(), found.q.end(), static_cast<double*>(PyArray_DATA(as_array(q))));
    std::copy(found.inside.begin(), found.inside.end(), static_cast<std::uint8_t*>(PyArray_DATA(as_array(inside))));
    std::copy(found.singular.begin(), found.singular.end(),
              static_cast<std::uint8_t*>(PyArray_DATA(as_array(singular))));
    std::copy(found.branches.begin(), found.branches.end(),
              static_cast<std::int64_t*>(PyArray_DATA(as_array(branches))));
    std::copy(found.motion.begin(), found.motion.end(), static_cast<std::int64_t*>(PyArray_DATA(as_array(motion))));
    nb::list motions;
    for (const auto& said : found.motions) motions.append(told(said));
    return nb::make_tuple(q, inside, static_cast<int>(found.flag), singular, branches, motion, motions);
  }

  // Looks at the poses that index (K,) names, whose rows and flags are given, and writes what there is; returns (K,) 0 where that
  // could not be read off, else 1, and 2 where a self-motion was found.
  nb::object into(nb::handle given, nb::handle which, nb::handle q, nb::handle valid, nb::handle inside,
                  nb::handle flags) const {
    nb::object poses = poses_in(given), index = nb::steal(PyArray_FROM_OTF(which.ptr(), NPY_INT64, NPY_ARRAY_IN_ARRAY));
    if (!index.is_valid()) throw nb::python_error();
    const npy_intp count = PyArray_SIZE(as_array(index)), all = PyArray_DIM(as_array(poses), 0);
    const auto target = [&](nb::handle array, int type, npy_intp size) {
      PyArrayObject* a = reinterpret_cast<PyArrayObject*>(array.ptr());
      if (!PyArray_Check(array.ptr()) || PyArray_TYPE(a) != type || !PyArray_ISCARRAY(a) || PyArray_SIZE(a) != size)
        throw nb::value_error("rows must be contiguous and writable, of the poses' number.");
      return PyArray_DATA(a);
    };
    const int slots = nb::cast<const PySolver*>(solver_)->solver().slots();
    auto* to = static_cast<double*>(target(q, NPY_DOUBLE, all * slots * 6));
    auto* is = static_cast<std::uint8_t*>(target(valid, NPY_BOOL, all * slots));
    auto* in = static_cast<std::uint8_t*>(target(inside, NPY_BOOL, all * slots));
    auto* flag = static_cast<std::uint8_t*>(target(flags, NPY_UINT8, all));
    nb::object out = new_array(1, &count, NPY_UINT8);
    auto* read = static_cast<std::uint8_t*>(PyArray_DATA(as_array(out)));
    const auto* at = static_cast<const std::int64_t*>(PyArray_DATA(as_array(index)));
    const double* T = doubles(poses);
    for (npy_intp k = 0; k < count; ++k)
      if (at[k] < 0 || at[k] >= all) throw nb::index_error("index names a pose that is not there.");
    nb::gil_scoped_release release;
    pieper::CarefulPose found;
    std::vector<double> known;
    for (npy_intp k = 0; k < count; ++k) {
      const std::int64_t i = at[k];
      read[k] = 0, known.clear();
      for (int s = 0; s < slots; ++s)
        if (is[i * slots + s]) known.insert(known.end(), to + 6 * (i * slots + s), to + 6 * (i * slots + s + 1));
      if (!look_->look(T + 16 * i, known.data(), static_cast<int>(known.size() / 6), flag[i], found) ||
          found.count > slots)
        continue;
      read[k] = found.motions.empty() ? 1 : 2;
      std::fill(to + i * slots * 6, to + (i + 1) * slots * 6, 0.0);
      std::copy(found.q.begin(), found.q.end(), to + i * slots * 6);
      for (int s = 0; s < slots; ++s)
        is[i * slots + s] = s < found.count, in[i * slots + s] = s < found.count && found.inside[s];
      flag[i] = found.flag | (flag[i] & pieper::kRounded);
    }
    return out;
  }

 private:
  // A line as (through, (i, j), sense), a linkage as (through, joints, axes, spots or None, senses, lead, low, high, course),
  // one that was followed as (points, closed).
  static nb::object told(const pieper::SelfMotionSaid& said) {
    const npy_intp points[] = {static_cast<npy_intp>(said.points.size() / 6), 6};
    if (points[0]) return nb::make_tuple(copied(said.points.data(), 2, points, NPY_DOUBLE), said.closed);
    const npy_intp six[] = {6}, four[] = {4}, wide[] = {4, 3};
    nb::object through = copied(said.through, 1, six, NPY_DOUBLE);
    if (said.line) return nb::make_tuple(through, nb::make_tuple(said.joints[0], said.joints[1]), said.sense);
    nb::object joints = new_array(1, four, NPY_INT64);
    std::copy(said.joints, said.joints + 4, static_cast<std::int64_t*>(PyArray_DATA(as_array(joints))));
    nb::object spots = said.flat ? copied(&said.spots[0][0], 1, four, NPY_CDOUBLE) : nb::object(nb::none());
    return nb::make_tuple(through, joints, copied(&said.axes[0][0], 2, wide, NPY_DOUBLE), spots,
                          copied(said.senses, 1, four, NPY_DOUBLE), said.lead, said.low, said.high, said.course);
  }
  static nb::object copied(const double* from, int dimensions, const npy_intp* shape, int type) {
    nb::object out = new_array(dimensions, shape, type);
    npy_intp size = type == NPY_CDOUBLE ? 2 : 1;
    for (int k = 0; k < dimensions; ++k) size *= shape[k];
    std::copy(from, from + size, static_cast<double*>(PyArray_DATA(as_array(out))));
    return out;
  }

  nb::object solver_;
  std::unique_ptr<pieper::CarefulLook> look_;
};

void bind_careful(nb::module_& m) {
  nb::class_<PyLinkage>(m, "Linkage", "A self-motion of four joints that are a linkage, of six.")
      .def(nb::init<const Forward&, nb::handle, nb::handle, nb::handle, nb::handle, nb::handle, int, double, double,
                    int>(),
           nb::arg("chain"), nb::arg("through"), nb::arg("joints"), nb::arg("axes"), nb::arg("spots").none(),
           nb::arg("senses"), nb::arg("lead"), nb::arg("low"), nb::arg("high"), nb::arg("course"))
      .def("points", &PyLinkage::points, nb::arg("u"), "(k,) -> (k, 6), angles the short way round from `through`.")
      .def("place", &PyLinkage::place, nb::arg("q"), "(6,) -> u; NaN where q is not on this piece of the curve.")
      .def("inside", &PyLinkage::inside, nb::arg("lower"), nb::arg("upper"), "(6,), (6,) -> intervals of u (k, 2).");
  nb::class_<PyCarefulLook>(m, "CarefulLook",
                            "What is free at a singular pose of six joints, read off the axes of a solver's rows.")
      .def(nb::init<nb::object, const Forward&, nb::handle, nb::handle, bool>(), nb::arg("solver"), nb::arg("chain"),
           nb::kw_only(), nb::arg("lower"), nb::arg("upper"), nb::arg("closed_form"))
      .def("one", &PyCarefulLook::one, nb::arg("T"), nb::arg("q"), nb::arg("flag"),
           "(4, 4), the solver's rows (m, 6) and flag -> q (m, 6), inside (m,), flag, singular (m,), branches (m,), "
           "self_motion (m,), the self-motions; None "
           "where that cannot be read off.")
      .def("into", &PyCarefulLook::into, nb::arg("Ts"), nb::arg("index"), nb::arg("q"), nb::arg("valid"),
           nb::arg("in_limits"), nb::arg("flag"),
           "Writes the rows of the poses that `index` names; returns 0 where they cannot be read off, 2 where a "
           "self-motion "
           "is among them, else 1.");
}

}  // namespace
