// The Python module pieper._code: the straight road of a closed form, for one arm, as a list of operations.
//
// The kernels themselves are run, with a number type that records (code/recording.hpp), so that there is no second derivation to
// keep in step. Families with loops that end when a value says so cannot be recorded.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "code/recording.hpp"

#include "closed_form/lanes/spherical_wrist.hpp"
#include "closed_form/lanes/spherical_wrist_parallel.hpp"
#include "closed_form/lanes/three_parallel.hpp"

namespace nb = nanobind;

namespace {

using namespace pieper;
using namespace pieper::PIEPER_ISA;
namespace cf = pieper::PIEPER_ISA::closed_form;

void flat(nb::handle given, double* to, int count) {
  const auto array = nb::cast<nb::ndarray<const double, nb::c_contig, nb::device::cpu>>(given);
  if (static_cast<int>(array.size()) != count) throw nb::value_error("a field has another size.");
  for (int i = 0; i < count; ++i) to[i] = static_cast<const double*>(array.data())[i];
}
void put(nb::handle h, double& to) { to = nb::cast<double>(nb::float_(h)); }
void put(nb::handle h, bool& to) { to = PyObject_IsTrue(h.ptr()) == 1; }
void put(nb::handle h, int& to) { to = nb::cast<int>(nb::int_(h)); }
void put(nb::handle h, Vector& to) { flat(h, &to.x, 3); }
template <int N> void put(nb::handle h, double (&to)[N]) { flat(h, to, N); }
template <int N, int M> void put(nb::handle h, double (&to)[N][M]) { flat(h, to[0], N * M); }
template <int N, int M, int K> void put(nb::handle h, double (&to)[N][M][K]) { flat(h, to[0][0], N * M * K); }
template <int N> void put(nb::handle h, bool (&to)[N]) {
  int k = 0;
  for (nb::handle x : h)
    if (k < N) to[k++] = PyObject_IsTrue(x.ptr()) == 1;
}

template <class Own> Own read(nb::dict given) {
  Own own{};
  Own::fields(own, [&](const char* name, auto& field) { put(given[name], field); });
  return own;
}

RigidT<Recorded> the_pose() {
  RigidT<Recorded> T;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) T.r(i, j) = Recorded::of(tape->add("in", 4 * i + j));
    T.p(i) = Recorded::of(tape->add("in", 4 * i + 3));
  }
  return T;
}

struct Rows {
  Recorded q[8][6];
  RecordedMask valid[8], unclear;
};

template <class Own, class Family> bool record_group(nb::dict given, Rows& out) {
  const Own own = read<Own>(given);
  const cf::GroupArm arm(own);
  const Family family(arm);
  if (!arm.straight || !family.straight) return false;
  const cf::LoopRestT<Recorded> rest(arm.links, in_lengths(the_pose(), arm.length), arm.first);
  cf::LaneSolutions<Recorded> found;
  family.template solve<Recorded>(arm, rest, found);
  for (int m = 0; m < 8; ++m) {
    for (int j = 0; j < 6; ++j) out.q[m][j] = found.q[m][j] * arm.unit[j];
    out.valid[m] = found.valid[m];
  }
  out.unclear = found.unclear;
  return true;
}

// Rows are in the list where they are in reach, verified or not: a pose where one is not is unclear, and a file puts rows of
// unclear poses back through forward kinematics. Otherwise a compiler that works the same truth out twice, rounded otherwise, says of
// the row that it fails and of the pose that it is clear.
bool record_parallel(nb::dict given, Rows& out) {
  const SphericalWristParallel own = read<SphericalWristParallel>(given);
  Branches<Recorded, 8, 6> found;
  SphericalWristParallelKernel::branches<Recorded>(own, the_pose(), found,
                                                   SphericalWristParallelKernel::AsTheyCome<Recorded>(own));
  for (int m = 0; m < 8; ++m) {
    for (int j = 0; j < 6; ++j) out.q[m][j] = found.q[m][j];
    out.valid[m] = found.reached[m];
  }
  out.unclear = found.degenerate | found.missed;
  return true;
}

nb::list listed(const Tape& own) {
  nb::list nodes;
  for (const Node& n : own.nodes) nodes.append(nb::make_tuple(n.op, n.a, n.b, n.c, n.value));
  return nodes;
}

nb::object record(const std::string& family, nb::dict fields) {
  Tape own;
  tape = &own;
  Rows rows;
  bool done = false;
  if (family == SphericalWristParallel::name) done = record_parallel(fields, rows);
  else if (family == SphericalWrist::name) done = record_group<SphericalWrist, cf::SphericalWristLanes>(fields, rows);
  else if (family == ThreeParallel::name) done = record_group<ThreeParallel, cf::ThreeParallelLanes>(fields, rows);
  if (!done) return nb::none();
  nb::list q, valid, loops;
  for (const Loop& l : own.loops) loops.append(nb::make_tuple(l.steps, l.start, l.next, l.moving));
  for (int m = 0; m < 8; ++m) {
    for (int j = 0; j < 6; ++j) q.append(rows.q[m][j].i);
    valid.append(rows.valid[m].i);
  }
  return nb::make_tuple(listed(own), q, valid, rows.unclear.i, loops);
}

}  // namespace

NB_MODULE(_code, m) {
  m.doc() = "Closed forms as lists of operations.";
  m.def("record", &record, nb::arg("family"), nb::arg("fields"),
        "The operations of a family's closed form for one arm: nodes (operation, a, b, c, value), rows, valid, "
        "unclear, loops (steps, start, next, moving); None "
        "where the straight road is closed.");
}
