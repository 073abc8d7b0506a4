"""The tour: a whole study on the Denso VP-6242, from its table to a followed line, written up on one page."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

import pieper
from pieper.document.blocks import Code, Document, Emphasis, Heading, Listing, Paragraph, Picture
from pieper.document.html import page as html_page
from pieper.document.writing import write_whole
from pieper.errors import InputError
from pieper.motion.sequence import move
from pieper.presentation.sections_arm import (
    add_arm,
    add_derivation,
    add_forward,
    add_plan,
    add_reach,
    attempt,
    fixed,
    joint_value,
)
from pieper.presentation.sections_motion import add_motion, add_solutions, add_track, scientific
from pieper.presentation.style import MM

if TYPE_CHECKING:
    from pieper.arm import Arm
    from pieper.motion.track import Track

ARM = "denso-vp6242"
#: The line of the study, m, and its number of points.
FIRST, LAST, POINTS = (0.35, 0.0, 0.4), (0.2, 0.1, 0.5), 50
#: Random postures on which the inverse is tried.
TRIED = 20_000
#: The limits of joint 3 as the study prints them, deg; they are the controller's, not this table's.
PRINTED_JOINT_3 = (20.0, 160.0)


def orientations() -> dict[str, np.ndarray]:
    """Return the tool orientations (3, 3) with which the line is tried."""
    Rx = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])
    Ry = np.array([[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]])
    return {
        "tool up (+z), R = I": np.eye(3),
        "tool forward (+x)": Ry,
        "tool sideways (+y)": Rx.T,
        "tool down (−z)": np.diag([1.0, -1.0, -1.0]),
    }


def line_of_study(R: np.ndarray) -> np.ndarray:
    """Return the study's line (50, 4, 4) with the tool held at the orientation R (3, 3)."""
    T0, T1 = np.eye(4), np.eye(4)
    T0[:3, :3] = T1[:3, :3] = R
    T0[:3, 3], T1[:3, 3] = FIRST, LAST
    return pieper.line(T0, T1, POINTS)


def run(out: Path, *, say: Callable[[str], None] = print) -> tuple[Path, bool]:
    """Run the tour.

    Args:
        out: Folder for the page and the figures; made when missing.
        say: What is told of the progress, line by line.

    Returns:
        The page, and whether the line was followed to its end.

    Raises:
        InputError: The folder cannot be made or written.
    """
    begun = time.perf_counter()
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"cannot make the folder {out}: {error.strerror}.", path=out) from None
    arm = pieper.load(ARM)
    page = Document(
        "The Denso VP-6242, from its table to a followed line",
        "Forward and inverse kinematics, every solution verified, one branch followed along fifty points",
    )
    say(f"The arm: {arm.name}, {arm.n} joints, {arm.plan.family.replace('_', ' ')}")
    add_arm(page, arm)
    say("Forward kinematics: the twelve printed equations against the table")
    _forward(page, arm)
    add_plan(page, arm)
    add_derivation(page, arm)
    say("Inverse kinematics: one pose solved, then many")
    recall = _inverse(page, arm, say)
    say("The line: 50 points, four tool orientations")
    track = _line(page, arm, say)
    _joint_move(page, arm, track)
    say("The reach")
    add_reach(page, arm)
    _again(page)
    count = recall["count"]
    page.summary = (
        "Of the twelve forward equations that the source paper prints, eleven hold and P_x has lost a factor C2. "
        "Every one of "
        f"{recall['poses']:,} random poses has {count} solutions, all of them found and put back to within "
        f"{scientific(recall['metres'] * MM)} mm. The straight line from (350, 0, 400) to (200, 100, 500) mm is "
        "followed by one "
        f"continuous branch over {len(track.q)} of {len(track.path)} points, with no joint step larger than "
        f"{fixed(np.degrees(track.largest_step.max()), 2)}°."
    )
    _figures(page, out, say)
    from pieper.cli.follow import write_csv

    write_csv(arm, track, str(out / "line.csv"))
    target = write_whole(out / "index.html", html_page(page))
    say(f"Done in {time.perf_counter() - begun:.1f} s.")
    return target, track.complete


def _forward(page: Document, arm: Arm) -> None:
    add_forward(page, arm)
    q = arm.description.postures.get("line-start", np.zeros(arm.n))
    T = arm.fk(q)
    values = ", ".join(f"{joint_value(arm, i, v, 3)}°" for i, v in enumerate(q))
    rows = [[axis, *(fixed(v, 6) for v in T[i, :3]), fixed(T[i, 3] * MM, 3)] for i, axis in enumerate(("x", "y", "z"))]
    page.table(["", "n", "o", "a", "p, mm"], rows, f"The tool's pose at q = ({values}), where the line will begin.")
    page.section("What was printed of it")
    page.add(
        "The source paper prints the twelve entries of the pose as its Eqs. (5) to (7), the position as P. Each was "
        "compared with "
        "the product of the matrices of the paper's own Table 1, at random joints and in 50-digit arithmetic."
    )
    attempt(page, "The judgement of the printed equations", lambda: _judged(page))


def _judged(page: Document) -> None:
    from pieper.cli.denso_equations import LOST, PRINTED, claims
    from pieper.judge.claims import check

    verdicts = {v.id: v for v in check(claims()).verdicts}
    rows = []
    for entry, (number, _) in PRINTED.items():
        v = verdicts[entry]
        words = "holds identically" if v.holds else "wrong"
        rows.append([entry, f"({number})", words, f"{v.right} of {v.tried}", str(v.digits or "none")])
    page.table(
        ["entry", "Eq.", "verdict", "right at joint vectors", "digits that agree"],
        rows,
        "The twelve printed entries of the pose, judged.",
        left=(0, 1, 2),
        strong=tuple(i for i, entry in enumerate(PRINTED) if not verdicts[entry].holds),
    )
    lost = verdicts[LOST["entry"]]
    details = dict(lost.details)
    page.add(
        Heading(("The lost C2",), 2),
        Paragraph(
            (
                "P_x is printed with the term ",
                Code(LOST["printed"]),
                " where it must be ",
                Code(LOST["right"]),
                ". The judge finds the slip by itself: ",
                Emphasis(details.get("the slip", "a factor is missing")),
                ". The printed formula minus the right one is ",
                Code(lost.difference),
                ", so it is right only where joint 2 stands at zero or the term vanishes. "
                f"{_upper(details.get('counter-example', ''))} (m). With C2 restored, P_x "
                f"{_lower(verdicts[LOST['entry'] + ' mended'].sentence)}",
            )
        ),
        Listing(f"P_x as printed:  {PRINTED['Px'][1]}\nP_x restored:    {_mended(PRINTED, LOST)}"),
    )


def _mended(printed: dict, lost: dict) -> str:
    return printed[lost["entry"]][1].replace(lost["printed"] + " ", lost["right"] + " ")


def _upper(text: str) -> str:
    return (text[:1].upper() + text[1:]).rstrip(".")


def _lower(text: str) -> str:
    return text[:1].lower() + text[1:]


def _inverse(page: Document, arm: Arm, say: Callable[[str], None]) -> dict:
    page.section("Inverse kinematics: every solution, verified")
    T = line_of_study(np.eye(3))[0]
    sols = arm.ik(T)
    add_solutions(page, arm, sols)
    found = _recall(arm)
    say(f"  {found['poses']:,} random poses: {found['missed']} missed, worst residual {found['metres'] * MM:.1e} mm")
    missed = "in none of them was it missing" if not found["missed"] else f"in {found['missed']} of them it was missing"
    page.add(
        Heading(("Many poses",), 2),
        f"Then {found['poses']:,} joint vectors were drawn evenly over whole turns, their poses computed and solved "
        "again. The "
        f"joint vector that had made the pose was looked for among the solutions; {missed}. The number of solutions "
        "was "
        f"{found['count']}, and all {found['solutions']:,} of them lead back to their pose within "
        f"{scientific(found['metres'] * MM)} mm and {scientific(np.degrees(found['radians']))}°. With a₁ = 0 the "
        "distance of the "
        "wrist from the shoulder is the same for both ways of facing it, so that a pose has all eight solutions or "
        "none.",
    )
    return found


def _recall(arm: Arm, n: int = TRIED) -> dict:
    """Return how the inverse did on n random joint vectors."""
    rng = np.random.default_rng(6242)
    q = rng.uniform(-np.pi, np.pi, (n, arm.n))
    T = arm.fk(q)
    many = arm.ik_many(T)
    apart = many.q - q[:, None]
    apart = np.abs(apart - 2 * np.pi * np.round(apart / (2 * np.pi))).max(-1)
    hit = (np.where(many.valid, apart, np.inf) < 1e-6).any(1)
    rows, which = many.q[many.valid], np.nonzero(many.valid)[0]
    residual = arm.plan.residual(rows, T[which])
    counts = np.unique(many.count)
    return {
        "poses": n,
        "missed": int(np.count_nonzero(~hit)),
        "solutions": len(rows),
        "metres": float(residual[:, 0].max()),
        "radians": float(residual[:, 1].max()),
        "count": " or ".join(str(c) for c in counts),
    }


def _line(page: Document, arm: Arm, say: Callable[[str], None]) -> Track:
    page.section("The straight line")
    path = line_of_study(np.eye(3))
    track = arm.follow(path, start=arm.description.postures.get("line-start", np.zeros(arm.n)))
    say(f"  R = I: {len(track.q)} of {len(path)} points on one branch")
    add_track(page, arm, track, prefix="line")
    page.add(Heading(("Which way the tool may point",), 2))
    rows, remarks = [], []
    for name, R in orientations().items():
        way = line_of_study(R)
        reached = int(arm.ik_many(way).valid.any(1).sum())
        attempt_ = arm.follow(way, start=track.q[0])
        stop = attempt_.stop
        swing = [e for e in attempt_.events if not e.stop]
        passing = sum(b.complete for b in attempt_.branches)
        biggest = fixed(np.degrees(attempt_.largest_step.max()), 1) + "°" if len(attempt_.q) > 1 else "none"
        rows.append(
            [name, str(reached), str(len(attempt_.q)), str(passing), biggest, stop.cause if stop else "reaches the end"]
        )
        remarks += [f"With the {name}: {e.detail}" for e in swing[:1]]
        if stop and stop.cause == "out of reach":
            remarks.append(f"With the {name}: {stop.detail}")
        say(f"  {name}: {reached} of {len(way)} points have a solution")
    page.table(
        [
            "orientation",
            "points with a solution",
            "followed inside the limits",
            "branches that pass",
            "largest step",
            "end",
        ],
        rows,
        "The same line with the tool held in four directions. The second column counts points that have any "
        "solution, limits "
        "aside; the third, how far the branch nearest to the start gets inside the limits.",
        left=(0, 5),
    )
    page.add(*remarks)
    page.add(Heading(("The printed limits of joint 3",), 2), _literal_limits(arm, track))
    return track


def _literal_limits(arm: Arm, track: Track) -> str:
    """Return what would happen if the printed limits were those of the table's third angle."""
    d = arm.description
    limits = d.limits.copy()
    limits[2] = np.radians(PRINTED_JOINT_3)
    literal = pieper.Arm.from_dh(d.rows, convention=d.convention, limits=limits, name=d.name)
    sols = literal.ik(track.path[0])
    least = np.degrees(d.limits[2])
    return (
        "The paper's table prints 20° to 160° for joint 3. Taken for the angle θ₃ of that table they would forbid "
        "the paper's own "
        f"line: at its first point {len(sols.q)} of {len(sols.all_q)} solutions would be left. ({sols.why}) The "
        "elbow is "
        "straight, and singular, at θ₃ = −109.654°, which is where a mechanical stop belongs; the printed numbers "
        "fit when they "
        "are read as the controller's angle J₃ with θ₃ = −90° − J₃. The robot file therefore holds θ₃ between "
        f"{fixed(least[0], 0)}° "
        f"and {fixed(least[1], 0)}°. That mapping is inferred, not printed."
    )


def _joint_move(page: Document, arm: Arm, track: Track) -> None:
    page.section("The same two postures, joint by joint")
    motion = move(track.q[0], track.q[-1], 3.0, rate=100)
    tool = arm.fk(motion.q)[:, :3, 3]
    p0, p1 = track.path[0, :3, 3], track.path[-1, :3, 3]
    along = (p1 - p0) / np.linalg.norm(p1 - p0)
    off = tool - p0
    off = np.linalg.norm(off - (off @ along)[:, None] * along, axis=1).max()
    add_motion(
        page,
        arm,
        motion,
        "Instead of a straight line one may let all joints move together, here in 3 s. The tool then leaves the "
        "line by up to "
        f"{fixed(off * MM, 2)} mm.",
        name="joint-move",
    )


def _again(page: Document) -> None:
    page.section("Do it again")
    page.add("Everything on this page can be had from the command line or from Python:")
    page.add(
        Listing(
            "pieper show denso-vp6242\n"
            "pieper fk denso-vp6242 line-start\n"
            "pieper ik denso-vp6242 350 0 400 --all\n"
            'pieper path denso-vp6242 --from "350 0 400" --to "200 100 500" --start line-start --figures figures\n'
            "pieper report denso-vp6242\n"
        ),
        Listing(
            "import pieper\n\n"
            'arm = pieper.load("denso-vp6242")\n'
            "T = arm.fk(arm.description.postures['line-start'])\n"
            "sols = arm.ik(T)              # every solution: sols.q, sols.labels, sols.residual\n"
            "path = pieper.line(T, T_end, n=50)\n"
            "track = arm.follow(path, start=sols.q[0])\n"
        ),
    )


def _figures(page: Document, out: Path, say: Callable[[str], None]) -> None:
    folder = out / "figures"
    folder.mkdir(exist_ok=True)
    pictures = [block for block in page.blocks if isinstance(block, Picture)]
    for picture in pictures:
        write_whole(folder / f"{picture.name}.png", picture.drawing.png())
        write_whole(folder / f"{picture.name}.svg", picture.drawing.svg())
    say(f"{len(pictures)} figures, each as PNG and SVG, in {folder}")
