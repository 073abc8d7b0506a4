"""The curves of a motion: their limits, where one binds and which, told as the motion plays."""

from __future__ import annotations

import numpy as np
import pytest

#: A joint move that its joints bind, a line that the tool's speed binds.
POSTURES = ((10, 90, -150, 10, 60, 30), (-15, 80, -140, 0, 60, 30))


@pytest.fixture
def ran(bench):
    """A page on which a program of two moves was planned."""
    for kind, posture in zip(("joint", "line"), POSTURES, strict=True):
        bench.joints(posture)
        bench.tab("Program")
        bench.page.get_by_test_id(f"step-add-{kind}").click()
        if kind == "joint":
            bench.button("Start here")
            bench.joints([-22, 71, -184, -5, -34, 5])
            bench.tab("Program")
            bench.button("Start here")
    bench.page.get_by_test_id("run-program").click()
    bench.until("workbench.motion && workbench.motion.tight.length > 1")
    return bench


def test_what_binds_is_told_and_is_at_its_limit_there(ran):
    motion = ran.value("workbench.motion")
    t, limits = np.array(motion["seconds"]), motion["limits"]
    values = {"speed": np.abs(motion["speeds"]), "acceleration": np.abs(motion["accelerations"])}
    names = [j["name"] for j in ran.value("workbench.table")["joints"]]
    assert {x["limit"] for x in motion["tight"]} >= {"acceleration", "tool speed"}
    for stretch in motion["tight"]:
        middle = int(np.argmin(np.abs(t - (stretch["start"] + stretch["end"]) / 2)))
        if not stretch["start"] <= t[middle] <= stretch["end"]:
            continue  # between two samples
        ran.value(f"workbench.go({middle})")
        told, named = ran.text("binds"), stretch["limit"] + (f" of {stretch['joint']}" if stretch["joint"] else "")
        assert named in told, "the sentence names what binds at the point that is shown"
        if stretch["joint"] and stretch["end"] - stretch["start"] > 0.02:
            i = names.index(stretch["joint"])
            assert values[stretch["limit"]][middle, i] > 0.99 * limits[stretch["limit"]][i], "and it is at its limit"
        elif stretch["limit"] == "tool speed" and stretch["end"] - stretch["start"] > 0.02:
            assert motion["toolspeeds"][middle] > 0.99 * limits["tool_speed"]


def test_limits_are_dashed_lines_within_the_scale_or_out_of_it(ran):
    page = ran.page
    ran.page.locator("[data-testid=curves] [data-value=speeds]").click()
    toggle = page.get_by_test_id("limits-shown")
    assert toggle.get_attribute("aria-pressed") == "true", "speeds are shown up to their limits"

    def dark_pixels() -> int:
        return ran.value(
            "(() => { const c = document.querySelector('[data-testid=chart] canvas'); "
            "const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data; let n = 0; "
            "for (let i = 0; i < d.length; i += 4) n += d[i + 3] > 200 && d[i] < 60 && d[i + 1] < 60; return n; })()"
        )

    with_limits = dark_pixels()
    ran.shot("limits-of-speeds", both=True)
    toggle.click()
    assert toggle.get_attribute("aria-pressed") == "false"
    assert dark_pixels() < with_limits / 2, "at the scale of the curves the limits lie outside"
    page.locator("[data-testid=curves] [data-value=singularity]").click()
    assert toggle.is_hidden(), "nothing must be kept there"
