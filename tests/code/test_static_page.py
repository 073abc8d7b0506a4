"""The page without a server opens from a file; its answers are the library's, whatever the family and joints."""

from __future__ import annotations

import gzip
import json
import subprocess
import time
from dataclasses import replace

import numpy as np
import pytest

import pieper
from pieper.kinematics.forward import fk
from static_page.build import add, build, identifier
from tests.code.test_export import poses
from tests.code.test_more_languages import needs_wasm

pytestmark = [pytest.mark.slow, needs_wasm]
NAMES = [
    "denso-vp6242",
    "universal-robots-ur5e",
    "stanford-arm",
    "fanuc-crx-10ia",
    "kinova-gen3-6dof",
    "franka-panda",
    "fanuc-lr-mate-200id-controller",
    "adept-cobra-600",
    "three-r",
    "dobot-magician",
    "dfrobot-rob0036-as-printed",
]
#: Arms that move on the page and are not solved there: a linkage, a joint held in the middle.
UNSOLVED = ("dobot-magician", "dfrobot-rob0036-as-printed")
#: Kilobytes that the kernels may take on the way.
MOST_KB = 175


#: Arms that are on the page as they were measured: general ones, one with a joint to spare, short ones.
AS_BUILT = ("universal-robots-ur5e", "franka-panda", "adept-cobra-600", "interbotix-viperx-300", "fanuc-crx-10ia")


def as_built(name, path):
    """Write the robot file of an arm whose links are a millimetre and a milliradian off, as a calibration keeps it."""
    arm, rng = pieper.load(name), np.random.default_rng(4)
    off = np.array([pieper.pose(*step[:3], rpy=step[3:]) for step in rng.normal(0, 7e-4, (arm.n + 1, 6))])
    real = replace(arm.chain, links=arm.chain.links @ off)
    limits = np.where(np.isfinite(arm.limits), arm.limits, [-3.0, 3.0])
    q = rng.uniform(limits[:, 0], limits[:, 1], (80, arm.n))
    arm.calibrate(q, fk(real, q), sigma=(1e-6, 1e-6)).save(path)
    return str(path)


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    folder = tmp_path_factory.mktemp("site")
    own = [as_built(name, folder / f"my-{name}.toml") for name in AS_BUILT]
    assert build(folder, NAMES, own=own[:1]) == len(NAMES) - len(UNSOLVED) + 1
    assert add(folder, own[1:]) == len(own) - 1
    return folder


def answers(site, arm, T, values):
    """Return what the page's solver says in Node: rows inside the limits, and how many there are before limits."""
    asked = site / "asked.json"
    asked.write_text(json.dumps({"T": T.reshape(-1, 16).tolist(), "values": values}))
    script = (
        "const fs = require('fs'), vm = require('vm'); globalThis.window = globalThis; let arm = null;\n"
        "const run = (name) => vm.runInThisContext(fs.readFileSync(name, 'utf8'));\n"
        "run('kernel.js'); run('solver.js');\n"
        "const page = fs.readFileSync('page.js', 'utf8');\n"
        "vm.runInThisContext(page.slice(page.indexOf('function frames'), page.indexOf('window.PIEPER.frames')));\n"
        "PIEPER.frames = frames; PIEPER.arrived = (data) => (arm = data);\n"
        f"run('arms/{identifier(arm.name)}.js');\n"
        "PIEPER.ready.then(() => { const { T, values } = JSON.parse(fs.readFileSync('asked.json'));\n"
        "  const rows = [], all = [];\n"
        "  T.forEach((t, i) => { const found = (PIEPER.ikAll(arm, t, values[i]) || { rows: [] }).rows;\n"
        "    all.push(found.length);\n"
        "    rows.push(found.map((row) => PIEPER.inside(arm, row)).filter((row) => row)); });\n"
        "  console.log(JSON.stringify({ rows, all })); });\n"
    )
    ran = subprocess.run(["node", "-e", script], cwd=site, capture_output=True, text=True, check=True)
    return json.loads(ran.stdout)


@pytest.mark.parametrize("name", [name for name in NAMES if name not in UNSOLVED])
def test_the_page_gives_the_native_rows(site, name):
    arm = pieper.load(name)
    q, T = poses(arm, 1000 if arm.plan.family != "general" else 200)
    spare = arm.plan.reduction.locked[0] if arm.plan.reduction.locked else None
    many = arm.ik_many(T, redundancy=None if spare is None else q[:, [spare]])
    said = answers(site, arm, T, [0.0] * len(T) if spare is None else q[:, spare].tolist())
    clear = (many.flag & 3) == 0
    assert clear.mean() > 0.99
    assert np.array_equal(np.array(said["all"])[clear], many.valid.sum(1)[clear])
    for i in np.flatnonzero(clear):
        wanted, rows = many.q[i][many.in_limits[i]], np.reshape(said["rows"][i], (-1, arm.n))
        assert len(rows) == len(wanted)
        if len(rows):
            assert np.abs(rows[:, None] - wanted[None]).max(-1).min(1).max() < 1e-7


@pytest.mark.parametrize("name", [name for name in NAMES if name not in UNSOLVED])
def test_a_pose_that_was_written_down_is_taken_as_the_nearest_one(site, name):
    arm = pieper.load(name)
    q, T = poses(arm, 60)
    T[::2], T[1::2] = np.round(T[::2], 6), np.float32(T[1::2])
    spare = arm.plan.reduction.locked[0] if arm.plan.reduction.locked else None
    many = arm.ik_many(T, redundancy=None if spare is None else q[:, [spare]])
    said = answers(site, arm, T, [0.0] * len(T) if spare is None else q[:, spare].tolist())
    for i in np.flatnonzero((many.flag & 3) == 0):
        wanted, rows = many.q[i][many.in_limits[i]], np.reshape(said["rows"][i], (-1, arm.n))
        assert len(rows) == len(wanted)
        if len(rows):
            assert np.abs(rows[:, None] - wanted[None]).max(-1).min(1).max() < 1e-7


def test_what_is_no_pose_has_no_rows_on_the_page(site):
    arm = pieper.load("franka-panda")
    T = arm.fk(np.full(7, 0.3))
    spoilt = np.array([T * [1, 1, -1, 1], np.diag([1.001, 1, 1, 1]) @ T, T])
    said = answers(site, arm, spoilt, [0.3] * 3)
    assert said["rows"][:2] == [[], []] and len(said["rows"][2]) > 0


def test_the_kernels_are_small_on_the_way(site):
    script = (site / "kernel.js").read_bytes()
    assert len(gzip.compress(script)) / 1e3 < MOST_KB
    # a host that packs nothing sends letters: four for three bytes of what is packed already
    assert len(script) / 1e3 < 4 / 3 * MOST_KB


def test_the_page_solves_what_the_library_solves(site, browser):
    page = browser.new_page()
    faults = []
    page.on("pageerror", lambda error: faults.append(str(error)))
    began = time.perf_counter()
    page.goto((site / "index.html").as_uri())
    page.wait_for_selector("#solutions tr.row")
    print(f"first answer after {time.perf_counter() - began:.2f} s")
    for name in NAMES:
        page.select_option("#arm", name)
        page.wait_for_function(f"state.arm && state.arm.name === {name!r}")
        arm = pieper.load(name)
        rng = np.random.default_rng(5)
        limits = np.where(np.isfinite(arm.limits), arm.limits, [-3.0, 3.0])
        for _ in range(5):
            q = rng.uniform(limits[:, 0], limits[:, 1])
            page.evaluate("(q) => move(q)", q.tolist())
            T = arm.fk(q)
            shown = page.locator("#pose td").all_inner_texts()
            assert np.abs(np.array(shown, float).reshape(4, 4) - T).max() < 1e-4
            J = np.array(page.locator("#jacobian td").all_inner_texts(), float).reshape(6, -1)
            assert np.abs(J - arm.jacobian(q)).max() < 1e-4
            if name not in UNSOLVED:
                spare = arm.plan.reduction.locked
                known = arm.ik(T, redundancy=None if not spare else float(q[spare[0]]))
                assert page.locator("#solutions tr.row").count() == len(known)
                assert page.locator("#solutions tr.here").count() == 1
        assert page.locator("#forward math").count() > 3
        assert page.locator("#inverse math").count() > 3 or "linkage" in page.locator("#inverse").inner_text()
    assert "library" in page.locator("#says").inner_text()
    assert not faults
    page.close()


@pytest.mark.parametrize("name", ["denso-vp6242", "franka-panda", "three-r"])
def test_the_tool_goes_where_it_is_dragged_and_stays_where_nothing_reaches(site, browser, name):
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    page.goto((site / "index.html").as_uri())
    page.wait_for_selector("#solutions tr.row")
    page.select_option("#arm", name)
    page.wait_for_function(f"state.arm && state.arm.name === {name!r}")
    box = page.locator("#view").bounding_box()
    (x, y), before = page.evaluate("state.lens.at"), page.evaluate("state.lens.pose")
    page.mouse.move(box["x"] + x, box["y"] + y)
    page.mouse.down()
    page.mouse.move(box["x"] + x + 8, box["y"] + y - 6, steps=3)
    assert np.abs(np.array(page.evaluate("state.lens.at")) - [x + 8, y - 6]).max() < 1e-6
    arm, q = pieper.load(name), page.evaluate("state.q")
    after = np.array(page.evaluate("state.lens.pose")).reshape(3, 4)
    assert np.abs(arm.fk(q)[:3] - after).max() < 1e-12
    assert (q >= arm.limits[:, 0]).all() and (q <= arm.limits[:, 1]).all()
    if arm.plan.task == "pose":
        assert np.abs(after[:, :3] - np.array(before).reshape(3, 4)[:, :3]).max() < 1e-9
    page.mouse.move(box["x"] + 4, box["y"] + 4)
    assert page.locator("#dragged").inner_text() == "Not reached there inside the limits."
    page.mouse.up()
    assert page.locator("#dragged").inner_text() == ""
    page.close()


@pytest.mark.parametrize("width", [360, 400, 820, 1440])
def test_the_page_is_as_wide_as_the_window(site, browser, width):
    page = browser.new_page(viewport={"width": width, "height": 850})
    page.goto((site / "index.html").as_uri())
    page.wait_for_selector("#solutions tr.row")
    for name in NAMES:
        page.select_option("#arm", name)
        page.wait_for_function(f"state.arm && state.arm.name === {name!r}")
        assert page.evaluate("document.documentElement.scrollWidth") <= width
        right = page.evaluate(
            "Math.max(...[...document.querySelectorAll('output')].map(e => e.getBoundingClientRect().right))"
        )
        assert right <= width
    page.close()


@pytest.mark.parametrize("name", AS_BUILT)
def test_a_robot_file_is_an_arm_of_the_page(site, name):
    arm = pieper.load(site / f"my-{name}.toml")
    assert arm.plan.family == "general"
    q, T = poses(arm, 60)
    spare = arm.plan.reduction.locked[0] if arm.plan.reduction.locked else None
    many = arm.ik_many(T, redundancy=None if spare is None else q[:, [spare]])
    said = answers(site, arm, T, [0.0] * len(T) if spare is None else q[:, spare].tolist())
    for i in np.flatnonzero((many.flag & 3) == 0):
        wanted, rows = many.q[i][many.in_limits[i]], np.reshape(said["rows"][i], (-1, arm.n))
        assert len(rows) == len(wanted) > 0
        assert np.abs(rows[:, None] - wanted[None]).max(-1).min(1).max() < 1e-7


def test_own_arms_stand_first(site, browser):
    page = browser.new_page()
    page.goto((site / "index.html").as_uri())
    page.wait_for_selector("#solutions tr.row")
    groups = page.locator("#arm optgroup").evaluate_all("all => all.map(g => [g.label, g.children.length])")
    assert groups == [["Own arms", len(AS_BUILT)], ["Catalogue", len(NAMES)]]
    assert page.evaluate("state.arm.name").endswith("-calibrated")
    page.close()
