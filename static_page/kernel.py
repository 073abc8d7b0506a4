"""The kernels of all families as one WebAssembly without imports, for any arm whose numbers are handed over."""

from __future__ import annotations

from typing import Any

import numpy as np

import pieper
from pieper.code.between import between
from pieper.code.cpp import numbers_of
from pieper.code.kernel_source import fingerprint, header_of, joined
from pieper.code.wasm import compiled
from pieper.tolerances import FILLED_STARTS, LIMIT_SLACK, ROTATION_ACCEPTED, VERIFIED

#: In the order of their numbers in the module.
FAMILIES = ("spherical_wrist_parallel", "spherical_wrist", "three_parallel", "offset_wrist", "two_slides", "general")

UNIT = """
#define PIEPER_ISA taken2
#define PIEPER_LANES 2
@KERNEL@
#include <new>
#include <stdlib.h>
#define PIEPER_EXPORT(name) __attribute__((export_name(name)))
void* operator new(size_t size) { return malloc(size); }
void operator delete(void* p) noexcept { free(p); }
void operator delete(void* p, size_t) noexcept { free(p); }
namespace lanes = @MARK@::PIEPER_ISA;
using Bytes = unsigned char;
struct Arm {
  const void* solver;
  long (*solve)(const void*, const double*, long, double*, Bytes*, Bytes*, Bytes*);
};
template <class Taken> Arm* made(const double* numbers, const double* general, const lanes::TakenChain& chain) {
  return new Arm{new Taken(numbers, general, chain), [](const void* solver, const double* T, long count, double* q,
                                                        Bytes* valid, Bytes* inside, Bytes* flag) {
                   return static_cast<const Taken*>(solver)->solve(T, count, q, valid, inside, flag);
                 }};
}
extern "C" {
int __cxa_atexit(void (*)(void*), void*, void*) { return 0; }
PIEPER_EXPORT("alloc") void* w_alloc(int bytes) { return malloc(bytes); }
PIEPER_EXPORT("release") void w_release(void* p) { free(p); }
/* numbers, general (or null), links, lower and upper stay where they are. */
PIEPER_EXPORT("make") Arm* w_make(int family, const double* numbers, const double* general, const double* links,
                                  const double* lower, const double* upper, const Bytes* slides) {
  const lanes::TakenChain chain{links, lower, upper, slides};
  switch (family) {
@CASES@
  }
  return nullptr;
}
PIEPER_EXPORT("solve") long w_solve(const Arm* arm, const double* T, long count, double* q, Bytes* valid, Bytes* inside,
                                    Bytes* flag) {
  return arm->solve(arm->solver, T, count, q, valid, inside, flag);
}
}
"""


def kernel() -> bytes:
    """Return the module: alloc, release, make an arm of a family, solve poses of it.

    Raises:
        InputError: There is no zig.
    """
    mark = f"pieper_{fingerprint()}"
    cases: list[str] = []
    headers: list[str] = []
    for number, family in enumerate(FAMILIES):
        own, header = header_of(family)
        headers.append(header)
        taken = f"lanes::Taken<{mark}::{own}, lanes::{own}Kernel>"
        cases.append(f"    case {number}: return made<{taken}>(numbers, general, chain);")
    source = joined("code/taken.hpp", *headers)
    unit = UNIT.replace("@KERNEL@", source).replace("@MARK@", mark).replace("@CASES@", "\n".join(cases))
    return compiled({"unit.cpp": unit}, "unit.cpp")


def prepared(arm: pieper.Arm) -> dict[str, Any]:
    """Return what the module and the page need to solve an arm, as plain lists.

    Raises:
        PlanError: It is snapped, or has a joint to hold in the middle.
    """
    plan = arm.plan
    if plan.snapped:
        raise pieper.PlanError(
            f"{plan.name}: its geometry was snapped, and the polishing that follows needs the library."
        )
    own = between(plan)
    if own.fixed:
        raise pieper.PlanError(
            f"{plan.name}: {', '.join(plan.redundancy)} would have to be held in the middle of the arm, which changes "
            "the numbers of the six that are left. Lock it (with_joints_locked) at the value that is wanted."
        )
    six = plan.reduction.six(plan.defaults)
    numbers, general = numbers_of(plan.spec.geometry)
    # a joint that stands still at its limit is inside
    limits = np.clip(plan.limits + [-LIMIT_SLACK, LIMIT_SLACK], -1e300, 1e300)
    return {
        "family": FAMILIES.index(plan.family),
        "slots": plan.spec.max_solutions,
        "numbers": numbers,
        "general": general,
        "links": six.links.ravel().tolist(),
        "sixSlides": [bool(s) for s in six.prismatic],
        "lower": limits[:, 0].tolist(),
        "upper": limits[:, 1].tolist(),
        "columns": list(own.columns),
        "filled": [[column, FILLED_STARTS * unit] for column, unit in own.filled],
        "tested": list(own.tested),
        "always": own.always,
        "plain": own.plain and own.held is None,
        "held": own.held,
        "atBase": own.at_base,
        "takenOff": None if own.taken_off is None else own.taken_off.ravel().tolist(),
        "gears": None if own.gears is None else own.gears.tolist(),
        "back": None if own.back is None else own.back.tolist(),
        "wraps": own.wraps,
        "tied": None if own.tied is None else [bool(t) for t in own.tied],
        "moves": [] if own.moves is None else own.moves.tolist(),
        "weight": [] if own.weight is None else own.weight.tolist(),
        "accepted": ROTATION_ACCEPTED,
        "verified": VERIFIED * max(1.0, plan.chain.length),
    }
