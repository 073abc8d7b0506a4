"""`pieper route`: the best continuous route along poses that leave a turn free, or why there is none."""

from __future__ import annotations

from typing import Any

import click
import numpy as np
import numpy.typing as npt

import pieper
from pieper.cli.arguments import joints, numbers
from pieper.cli.layout import Column
from pieper.cli.options import TakesNumbers, as_csv, as_json, order, takes_arm, takes_units
from pieper.cli.output import as_json as print_json
from pieper.cli.output import joint_cells, joint_columns, number, print_table, say, si_units
from pieper.cli.path import DECIMALS, FEW
from pieper.cli.pose_file import PoseFile
from pieper.cli.status import DONE, NO_SOLUTION
from pieper.cli.straight import Straight, takes_straight
from pieper.cli.units import Units
from pieper.tolerances import WHOLE_TURN


@click.command("route", cls=TakesNumbers, short_help="The best way along a path that leaves something free.")
@takes_arm
@takes_straight
@click.option("--poses", default="", metavar="FILE", help="A table of poses (.csv) instead of --from and --to.")
@click.option("--free", is_flag=True, help="The tool may turn about its axis as it likes.")
@click.option("--turn", default="", metavar="'LO HI'", help="The tool may turn between two angles.")
@click.option("--cone", default="0", metavar="ANGLE", help="The tool's axis may tilt by this much.")
@click.option("--axis", default="z", show_default=True, type=click.Choice(["x", "y", "z"]), help="The axis meant.")
@click.option("--start", default="", metavar="JOINTS", help="Joints to begin with (quoted), or a posture's name.")
@click.option(
    "--cost", default="motion", show_default=True, type=click.Choice(["motion", "time"]), help="What is small."
)
@click.option("--relax", is_flag=True, help="Where there is no route, seek the smallest change that lets one through.")
@click.option("--plot", default="", metavar="FILE", help="Draw the map of path and turn into this .png, .svg or .pdf.")
@as_csv
@order
@as_json
@takes_units
def command(
    arm: pieper.Arm,
    straight: Straight,
    poses: str,
    free: bool,
    turn: str,
    cone: str,
    axis: str,
    start: str,
    cost: str,
    relax: bool,
    plot: str,
    csv: str,
    order: str,
    json: bool,
    units: Units,
) -> int:
    """Find the cheapest continuous route over all branches, whole turns and what is free; or say what closes the way.

    Example: pieper route abb-irb2400 --from "900 -300 900 0 180 0" --to "900 300 900 0 180 0" --free
    """
    freedom = _freedom(free, turn, cone, axis, units)
    if plot and (freedom is None or not freedom.turns):
        raise pieper.InputError("--plot draws path and turn: say --free, or --turn for two angles.", given=plot)
    path = _path(straight, poses, units, order)
    route = arm.route(path, free=freedom, start=joints(arm, [start], units, "--start") if start else None, cost=cost)
    if csv and route.found:
        _write_csv(arm, route, csv, units)
    if plot:
        pieper.plot.save_figure(pieper.plot.route_figure(route), plot)
    status = DONE if route.found else NO_SOLUTION
    if json:
        print_json(_as_data(arm, route, relax))
        return status
    if route.found:
        _print_points(arm, route, units)
    if relax and route.blocked is not None:
        _ = route.blocked.relaxations  # told once they were asked for
    say(route.explain())
    if csv and route.found:
        say(f"joints and turns: {csv}")
    if plot:
        say(f"figure: {plot}")
    return status


def _freedom(free: bool, turn: str, cone: str, axis: str, units: Units) -> pieper.Freedom | None:
    if free and turn:
        raise pieper.InputError("say --free or --turn, not both.")
    tilt = numbers([cone], "--cone")
    if len(tilt) != 1:
        raise pieper.InputError(f"--cone must be one angle, got {len(tilt)} numbers.", given=cone)
    right = np.pi / 2 / units.radians
    if not 0 <= tilt[0] < right:
        raise pieper.InputError(
            f"--cone must be at least 0 and less than {right:.6g} {units.angle}, got {tilt[0]:g} {units.angle}.",
            given=tilt[0],
        )
    if not (free or turn):
        if tilt[0] == 0:
            return None
        return pieper.Freedom(turn=(0.0, 0.0), cone=tilt[0] * units.radians, axis=axis)
    typed = numbers([turn], "--turn", pairs=True) if turn else []
    if turn and len(typed) != 2:
        raise pieper.InputError(f"--turn must be two angles, got {len(typed)}.", given=turn)
    if turn and typed[0] > typed[1]:
        raise pieper.InputError(
            f'--turn must have its lower end first, got "{typed[0]:g} {typed[1]:g}" {units.angle}; did you mean '
            f'"{typed[1]:g} {typed[0]:g}"?',
            given=turn,
        )
    if turn and (typed[1] - typed[0]) * units.radians > 2 * np.pi + WHOLE_TURN:
        raise pieper.InputError(
            f"--turn goes over {typed[1] - typed[0]:g} {units.angle}, more than a whole turn; say --free, which has no "
            "ends.",
            given=turn,
        )
    ends = [v * units.radians for v in typed]
    return pieper.Freedom(turn=(ends[0], ends[1]) if turn else "free", cone=tilt[0] * units.radians, axis=axis)


def _path(straight: Straight, poses: str, units: Units, order: str) -> npt.NDArray[np.float64]:
    if poses:
        if straight.typed:
            raise pieper.InputError("say --poses or --from and --to, not both.", given=poses)
        return np.concatenate(list(PoseFile(poses, units, order).blocks()))
    missing = 'a route needs --from and --to, for example --from "900 -300 900 0 180 0" --to "900 300 900 0 180 0", or '
    return straight.through([t.T for t in straight.targets(units, order, missing + "--poses file.csv.")])


def _print_points(arm: pieper.Arm, route: pieper.Route, units: Units) -> None:
    few = sorted(set(np.linspace(0, len(route.q) - 1, min(len(route.q), FEW)).round().astype(int).tolist()))
    columns = [Column("point"), Column("s"), *joint_columns(arm, units), Column(f"turn, {units.angle}")]
    rows = [
        [
            str(k + 1),
            number(float(route.s[k]), 4),
            *joint_cells(arm, route.q[k], units),
            number(float(route.turn[k]) / units.radians, 3),
        ]
        for k in few
    ]
    print_table(f"{arm.name}: {len(few)} of {len(route.q)} points", columns, rows)


def _write_csv(arm: pieper.Arm, route: pieper.Route, file: str, units: Units) -> None:
    """Write a route as CSV, whole or not at all: point, s, joints, turn, tilt."""
    names = [f"{name}_{unit}" for name, unit in zip(arm.joint_names, units.names_of_joints(arm), strict=True)]
    head = ["point", "s", *names, f"turn_{units.angle}", f"tilt_{units.angle}"]
    with pieper.whole_file(file) as out:
        out.write((",".join(head) + "\n").encode())
        for k, q in enumerate(route.q):
            angles = np.array([route.turn[k], route.tilt[k]]) / units.radians
            values = [route.s[k], *(q / units.of_joints(arm)), *angles]
            text = ",".join([str(k + 1), *(repr(round(float(v), DECIMALS) + 0.0) for v in values)])
            out.write((text + "\n").encode())


def _as_data(arm: pieper.Arm, route: pieper.Route, relax: bool) -> dict[str, Any]:
    blocked = route.blocked
    return {
        "arm": arm.name,
        "joint_names": arm.joint_names,
        "units": si_units(arm),
        "verdict": route.verdict.name,
        "reason": route.reason,
        "s": route.s,
        "q": route.q,
        "turn": route.turn,
        "tilt": route.tilt,
        "cost": route.cost if route.found else None,
        "bound": route.bound,
        "blocked": None
        if blocked is None
        else {
            "s": blocked.s,
            "why": blocked.why,
            "closed": [
                {"branch": c.branch, "joint": c.joint, "side": c.side, "limit": c.limit, "excess": c.excess}
                for c in blocked.closed
            ],
            "relaxations": [
                {"kind": r.kind, "amount": r.amount, "what": r.what, "opens": r.opens}
                for r in (blocked.relaxations if relax else ())
            ],
        },
    }
