"""`pieper clear`: whether a path keeps an arm clear of itself and of what stands around it, proved."""

from __future__ import annotations

import click
import numpy as np
import numpy.typing as npt

import pieper
from pieper.cli.arguments import joints
from pieper.cli.joint_file import JointFile
from pieper.cli.options import TakesNumbers, as_json, takes_arm, takes_units
from pieper.cli.output import as_json as print_json
from pieper.cli.output import number, say
from pieper.cli.status import DONE, NO_SOLUTION
from pieper.cli.units import Units
from pieper.tolerances import LIMIT_SLACK


@click.command("clear", cls=TakesNumbers, short_help="Prove that a path touches nothing.")
@takes_arm
@click.option("--scene", default="", metavar="FILE", help="What stands around the arm; without it the arm alone.")
@click.option("--from", "first", default="", metavar="JOINTS", help="Joints at the beginning (quoted), or a posture.")
@click.option("--via", multiple=True, metavar="JOINTS", help="Joints on the way; may be repeated.")
@click.option(
    "--to", "last", default="", metavar="JOINTS", help="Joints at the end; without it one posture is looked at."
)
@click.option("--path", "file", default="", metavar="FILE", help="A .csv with a column a joint, by name or in order.")
@click.option("--margin", default=0.0, show_default=True, help="Distance to keep, in --length.")
@click.option("--bodies", is_flag=True, help="Say what the arm's bodies are and which may touch.")
@click.option(
    "--plot", default="", metavar="FILE", help="Draw what is kept, and what of it is proved: .png, .svg, .pdf."
)
@as_json
@takes_units
def command(
    arm: pieper.Arm,
    scene: str,
    first: str,
    via: tuple[str, ...],
    last: str,
    file: str,
    margin: float,
    bodies: bool,
    plot: str,
    json: bool,
    units: Units,
) -> int:
    """Prove that a path keeps an arm clear, everywhere between its points too; status 1 where it is not proved.

    Every joint moves evenly from point to point. A scene file has a table [[bodies]] an obstacle: docs/collision.md.

    Example: pieper clear denso-vp6242 --from home --to "60 90 -180 0 0 0" --margin 5
    """
    if not (np.isfinite(margin) and margin >= 0):
        raise pieper.InputError(
            f"--margin must be a length of at least 0 {units.length}, got {margin:g}.", given=margin
        )
    around = pieper.Scene.load(scene) if scene else pieper.Scene()
    if bodies and not (first or last or file):
        say(arm.bodies.explain())
        return DONE
    path = _path(arm, first, via, last, file, units)
    if plot:
        profile = arm.clearance(path, around, margin * units.metres)
        pieper.plot.save_figure(pieper.plot.clearance_figure(profile), plot)
        found = profile.swept
    else:
        found = arm.clear(path, around, margin * units.metres)
    apart = arm.distance(path, around)
    at = int(np.argmin(apart))
    status = DONE if found.verdict is pieper.Clearance.CLEAR else NO_SOLUTION
    if json:
        print_json(
            {
                "arm": arm.name,
                "verdict": found.verdict.name,
                "s": found.s,
                "q": found.q,
                "pair": list(found.pair),
                "depth_m": found.depth,
                "margin_m": found.margin,
                "gap_m": found.gap,
                "nearest_point": at,
                "nearest_m": float(apart[at]),
                "nearest_pair": [str(name) for name in apart.pair[at]],
                "guessed": arm.bodies.guessed,
            }
        )
        return status
    if bodies:
        say(arm.bodies.explain() + "\n")
    say(found.explain())
    if len(arm.bodies) and any(apart.pair[at]):
        one, other = apart.pair[at]
        metres = float(apart[at])
        size = f"{number(abs(metres) / units.metres, 3 if units.length == 'mm' else 6)} {units.length}"
        if metres < 0:
            where = f"Of its {len(path)} points, number {at + 1} is the worst" if len(path) > 1 else "There"
            say(f"{where}{':' if len(path) > 1 else ''} {one} and {other} overlap by {size}.")
        else:
            where = f"Of its {len(path)} points, number {at + 1} is" if len(path) > 1 else "The posture is"
            say(f"{where} {size} from touching, the nearest: {one} and {other}.")
    if arm.bodies.guessed:
        say("The arm's bodies are guessed from its table: --bodies lists them.")
    for sentence in _outside(arm, path, units):
        say(sentence)
    return status


def _outside(arm: pieper.Arm, path: npt.NDArray[np.float64], units: Units) -> list[str]:
    """Return where a path (N, n) leaves the limits of joints, which clearances do not ask about, a sentence a joint."""
    out: list[str] = []
    scale, names = units.of_joints(arm), units.names_of_joints(arm)
    for j, (low, high) in enumerate(arm.limits):
        beyond = np.maximum(path[:, j] - high, low - path[:, j])
        k = int(np.argmax(beyond))
        if beyond[k] > LIMIT_SLACK:
            out.append(
                f"{arm.joint_names[j]} is at {path[k, j] / scale[j]:.6g} {names[j]} at point {k + 1}, outside its "
                f"limits of {low / scale[j]:.6g} to {high / scale[j]:.6g} {names[j]}: the arm cannot go there."
            )
    return out


def _path(
    arm: pieper.Arm, first: str, via: tuple[str, ...], last: str, file: str, units: Units
) -> npt.NDArray[np.float64]:
    if bool(first) == bool(file):
        raise pieper.InputError('give the path as --from and --to, as --from home --to "60 90 0 0 0 0", or --path.')
    if file:
        return np.concatenate(list(JointFile(file, units, arm=arm).blocks()))
    words = [("--from", first), *(("--via", v) for v in via), *([("--to", last)] if last else [])]
    return np.array([joints(arm, [text], units, what) for what, text in words])
