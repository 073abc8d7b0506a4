// One family for one instruction set: CMake compiles this file once for every line of its table of families and every
// instruction set, with -DPIEPER_FAMILY=<geometry> -DPIEPER_HEADER=<file>.
//
// To add a family: write its header with a struct <Name> (dispatch/geometry.hpp) and, in namespace pieper::PIEPER_ISA, a class
// <Name>Kernel that is made from it and has `in_order` and `solve` (FamilyEntry in dispatch/isa.hpp); add its line to the table in
// CMakeLists.txt; write its Python file in solver/families.
#include "dispatch/isa.hpp"
#include PIEPER_TEXT(PIEPER_HEADER)

namespace pieper::PIEPER_ISA {

using Own = PIEPER_FAMILY;
using Kernel = PIEPER_JOIN(PIEPER_FAMILY, Kernel);

template <class K> constexpr decltype(FamilyEntry::solve_inside) solve_inside() {
  if constexpr (!requires { &K::solve_inside; }) return nullptr;
  else
    return [](const void* kernel, const double* T, long count, const Directly& how, const Answers& to) {
      return static_cast<const K*>(kernel)->solve_inside(T, count, how, to);
    };
}

extern const FamilyEntry PIEPER_JOIN(PIEPER_FAMILY, Entry);
const FamilyEntry PIEPER_JOIN(PIEPER_FAMILY, Entry) = {
    Own::name,
    Own::joints,
    Own::slots,
    Kernel::in_order,
    [](const Geometry& geometry) -> const void* { return new Kernel(static_cast<const Own&>(geometry)); },
    [](const void* kernel) { delete static_cast<const Kernel*>(kernel); },
    [](const void* kernel, const double* T, long count, double* q, std::uint8_t* valid, std::uint8_t* flag) {
      static_cast<const Kernel*>(kernel)->solve(T, count, q, valid, flag);
    },
    solve_inside<Kernel>()};

}  // namespace pieper::PIEPER_ISA
