"""Random walks of a person over the page: undone, redone, reloaded and shared, everything is the same."""

from __future__ import annotations

import random
from collections.abc import Callable

import pytest

from tests.browser.conftest import Workbench

#: What a state is, beside how it is looked at.
LOOKED = {"camera", "panel", "frames", "theme", "units", "look", "notation", "follow", "ghosts", "pieper"}
ARMS = ("abb-irb140", "unimation-puma-560", "kuka-kr5-arc", "denso-vp6242")


def said(bench: Workbench) -> object:
    return told({k: v for k, v in bench.value("workbench.said").items() if k not in LOOKED})


def told(value: object) -> object:
    """Return a value without what says nothing: nulls, and empty texts and objects."""
    if isinstance(value, list):
        return [told(v) for v in value]
    if isinstance(value, dict):
        return {k: t for k, v in value.items() if (t := told(v)) not in (None, "", {})}
    return value


def walker(bench: Workbench, rng: random.Random) -> dict[str, Callable[[], None]]:
    """Return what a person may do next, each a thing of its own."""
    page = bench.page
    number = lambda low, high: round(rng.uniform(low, high), rng.choice([0, 1, 3]))  # noqa: E731

    def joint() -> None:
        bench.tab("Move")
        bench.fill(f"q-{rng.randint(1, 6)}", number(-60, 60))

    def slider() -> None:
        bench.tab("Move")
        page.get_by_test_id(f"slider-{rng.randint(1, 6)}").press(rng.choice(["ArrowLeft", "PageUp", "Home"]))

    def cell() -> None:
        bench.tab("DH table")
        bench.fill(f"dh-{rng.randint(1, 6)}-{rng.choice(['a', 'd'])}", number(10, 400))

    def target() -> None:
        bench.tab("Inverse")
        bench.until("workbench.said.target !== null")
        bench.fill(f"target-{rng.randint(0, 5)}", number(-50, 200))

    def path() -> None:
        bench.tab("Path")
        bench.fill(f"path-{rng.choice(['from', 'to'])}-{rng.randint(0, 2)}", number(50, 300))

    def step() -> None:
        bench.tab("Program")
        page.get_by_test_id(f"step-add-{rng.choice(['joint', 'line', 'wait', 'gripper', 'frame', 'output'])}").click()

    def fewer() -> None:
        bench.tab("Program")
        rows = page.get_by_role("button", name="Remove step")
        if rows.count():
            rows.nth(rng.randrange(rows.count())).click()

    def limit() -> None:
        bench.tab("Program")
        bench.fill("limit-turn_speed", number(20, 200))

    def thing() -> None:
        bench.tab("World")
        page.get_by_test_id("add-object-box").click()
        bench.fill("world-1-0", number(-200, 200))

    def posture() -> None:
        bench.tab("Sequence")
        page.get_by_test_id("add-posture").click()

    def arm() -> None:
        bench.arm(rng.choice([a for a in ARMS if a != bench.value("workbench.table.name")]))

    return {f.__name__: f for f in (joint, slider, cell, target, path, step, fewer, limit, thing, posture, arm)}


def history(bench: Workbench, name: str) -> int:
    """Undo, or redo, everything and return how many steps that were."""
    button, steps = bench.page.get_by_role("button", name=name, exact=True), 0
    while not button.is_disabled():
        button.click()
        steps += 1
        assert steps < 200
    return steps


@pytest.mark.parametrize("seed", [1, 2])
def test_a_walk_undone_redone_reloaded_and_shared_is_the_same(people, seed):
    bench, rng = people().open(), random.Random(seed)
    bench.settle()
    # the panels say their first values when they are first seen; that is no step of a person
    for tab in ("Inverse", "Path", "Move"):
        bench.tab(tab)
    bench.until("workbench.settled")
    begun, states, done = said(bench), [], []
    for _ in range(14):
        able = walker(bench, rng)
        name = rng.choice(list(able))
        able[name]()
        bench.rest()  # what follows from it (the arm that goes to its target) is a part of it
        done.append(name)
        states.append(said(bench))
    ended = states[-1]
    undone = history(bench, "Undo")
    assert said(bench) == begun, done
    assert history(bench, "Redo") == undone
    assert said(bench) == ended, done
    bench.rest()  # the address follows
    bench.page.reload()
    bench.page.wait_for_selector("html[data-ready=yes]")
    bench.settle()
    assert said(bench) == ended, done
    other = people().open(bench.page.url.removeprefix(bench.url))
    other.settle()
    assert said(other) == ended, done
