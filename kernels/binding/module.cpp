// The Python module pieper._kernel: forward kinematics of a chain, and the solver that all inverse families share.
#include <cmath>

#include "binding/boxed.hpp"
#include "binding/careful.hpp"
#include "binding/chain.hpp"
#include "binding/collision.hpp"
#include "binding/curve.hpp"
#include "binding/fields.hpp"
#include "binding/nearer.hpp"
#include "binding/onto.hpp"
#include "binding/route.hpp"
#include "binding/time_law.hpp"
#include "binding/unfold.hpp"
#include "binding/usual.hpp"

namespace {

nb::object deviations(nb::handle given) {
  nb::object poses = poses_in(given);
  const npy_intp count = PyArray_DIM(as_array(poses), 0);
  nb::object out = new_array(1, &count, NPY_DOUBLE);
  pieper::isa().deviation(doubles(poses), count, static_cast<double*>(PyArray_DATA(as_array(out))));
  return out;
}

nb::object elementary(int what, nb::handle given) {
  nb::object x = float_array(given, "x");
  const npy_intp count = PyArray_SIZE(as_array(x)) / (what == 0 ? 1 : 2);
  const npy_intp shape[] = {count, 2};
  nb::object out = new_array(what == 0 ? 2 : 1, shape, NPY_DOUBLE);
  pieper::isa().elementary(what, doubles(x), count, static_cast<double*>(PyArray_DATA(as_array(out))));
  return out;
}

nb::object posture_measures(nb::handle given, double length) {
  nb::object J = float_array(given, "J");
  const npy_intp shape[] = {PyArray_SIZE(as_array(J)) / 36, 2};
  nb::object out = new_array(2, shape, NPY_DOUBLE);
  pieper::isa().posture_measures(doubles(J), shape[0], length, static_cast<double*>(PyArray_DATA(as_array(out))));
  return out;
}

int import_numpy() {
  import_array1(-1);
  return 0;
}

}  // namespace

NB_MODULE(_kernel, m) {
  // arms that live as long as the program (a script's globals, caches) are no leaks
  nb::set_leak_warnings(false);
  if (import_numpy() < 0) throw nb::python_error();
  m.doc() = "The native kernels of pieper: forward kinematics and the inverse families, several poses per instruction.";
  m.attr("isa") = pieper::isa().name;
  m.attr("isa_available") = pieper::isa_names();
  m.attr("lanes") = pieper::isa().lanes;
  nb::enum_<pieper::Flag>(m, "Flag", nb::is_arithmetic(), nb::is_flag(),
                          "What a solver says of a pose; bits of `flag`.")
      .value("DEGENERATE", pieper::Flag::DEGENERATE,
             "So near a singular pose that self-motions or merged roots are possible.")
      .value("UNCERTAIN", pieper::Flag::UNCERTAIN, "The family cannot vouch that nothing is missing.")
      .value("OUT_OF_REACH", pieper::Flag::OUT_OF_REACH, "No solution, for reasons of reach.")
      .value("ROUNDED", pieper::Flag::ROUNDED, "The rotation was replaced by the nearest exact one.")
      .value("NO_ARM_ANGLE", pieper::Flag::NO_ARM_ANGLE, "The arm angle is undefined here.")
      .value("COUNT_CHANGES", pieper::Flag::COUNT_CHANGES,
             "The arm as described has another number of solutions here than the one solved.")
      .value("AT_ARM_ANGLE", pieper::Flag::AT_ARM_ANGLE, "Solved at a chosen arm angle.")
      .value("EDGE", pieper::Flag::EDGE, "No solution, but perhaps beside it.");

  bind_chain(m);

  nb::class_<pieper::Geometry>(
      m, "Geometry", "What a family is told of an arm: made from keyword arguments, unchangeable, picklable.");
  int family = 0;
#define PIEPER_FAMILY(name) [[maybe_unused]] auto name = bind_family<pieper::name>(m, #name, family++);
#include "families.def"
#undef PIEPER_FAMILY
  General
      .def_prop_ro(
          "trials", [](const Bound<pieper::General>& self) { return get(self.trials); },
          "(24, 4): rank, missed, open, noise of every hand-out of roles (shift, direction, swap).")
      .def_prop_ro(
          "usable", [](const Bound<pieper::General>& self) { return self.usable; }, "How many ways are of use.");

  nb::class_<PySelection>(m, "Selection", "How rows are compared with a joint vector: limits, weights, whole turns.")
      .def(nb::init<nb::handle, nb::handle, nb::handle, nb::handle>(), nb::kw_only(), nb::arg("lower"),
           nb::arg("upper"), nb::arg("weight"), nb::arg("prismatic"))
      .def("choose", &PySelection::choose, nb::arg("q"), nb::arg("inside"), nb::arg("near"), nb::arg("chosen"),
           nb::arg("has"), "Writes the row (N, n) nearest to `near`, (n,) or (N, n), and whether there is one (N,).")
      .def("in_turn", &PySelection::in_turn, nb::arg("q"), nb::arg("inside"), nb::arg("start").none(),
           nb::arg("chosen"), nb::arg("has"), "The same, each near to the one chosen before it.");

  nb::class_<PySolver>(m, "Solver", "Every solution of poses by the kernel of one family.")
      .def(nb::init<nb::object, nb::handle, nb::handle, nb::handle, double, double, double>(), nb::arg("geometry"),
           nb::kw_only(), nb::arg("lower"), nb::arg("upper"), nb::arg("prismatic"), nb::arg("slack"),
           nb::arg("accepted"), nb::arg("exact"))
      .def_prop_ro("geometry", &PySolver::geometry)
      .def("many", &PySolver::many, nb::arg("Ts"), nb::arg("threads") = 1,
           "(N, 4, 4) -> q (N, slots, joints), valid, in_limits (N, slots), flag (N,). threads 0: all cores.")
      .def("into", &PySolver::into, nb::arg("Ts"), nb::arg("threads"), nb::arg("q"), nb::arg("valid"),
           nb::arg("in_limits"), nb::arg("flag"), nb::arg("outcome"), nb::arg("selection") = nb::none(),
           nb::arg("near") = nb::none(), nb::arg("chosen") = nb::none(), nb::arg("has") = nb::none(),
           nb::arg("progress") = nb::none(),
           "The same written into arrays of the caller's, with an outcome (N,) and, near joint vectors, a chosen row a "
           "pose (N, joints).")
      .def("reach", &PySolver::reach, nb::arg("centres"), nb::arg("turns"), nb::arg("rolls"), nb::arg("sense"),
           nb::arg("images"), nb::arg("first_sense"), nb::arg("links").none(), nb::arg("length"), nb::arg("threads"),
           "Voxels (v, 3) times orientations (k, 3, 3), each voxel for its images (v, fold): bits reached and bits to "
           "look "
           "at one by one (w, ceil(k / 8)), solutions (w,), measures (w, 6) or (w, 0), by the images' numbers.")
      .def("one", &PySolver::one, nb::arg("T"),
           "(4, 4) -> q (m, joints) of the valid slots in order, slots (m,), in_limits (m,), flag.");

  bind_careful(m);
  bind_boxed(m);
  bind_curve(m);
  bind_nearer(m);
  bind_onto(m);
  bind_unfold(m);
  bind_usual(m);
  bind_time_law(m);
  bind_collision(m);
  bind_route(m);
  m.def("deviations", &deviations, nb::arg("Ts"),
        "(N, 4, 4) -> (N,) how far each is from a rigid motion; NaN where it is not finite.");
  m.def("posture_measures", &posture_measures, nb::arg("J"), nb::arg("length"),
        "(N, 6, 6) -> (N, 2) determinant, and smallest singular value with lengths divided by one.");
  m.def(
      "sincos", [](nb::handle x) { return elementary(0, x); }, nb::arg("x"),
      "(N,) -> (N, 2) sine and cosine, for tests.");
  m.def("atan2", [](nb::handle yx) { return elementary(1, yx); }, nb::arg("yx"), "(N, 2) y, x -> (N,), for tests.");
  m.def(
      "unit_angle", [](nb::handle yx) { return elementary(2, yx); }, nb::arg("yx"),
      "(N, 2) y, x of length one -> (N,), in [-pi, pi], for tests.");
}
