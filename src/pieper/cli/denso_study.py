"""The tour: a whole study on the Denso VP-6242, from its table to a followed line, written up on one page."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

import pieper
from pieper import sections
from pieper.cli.denso_equations import LOST, PRINTED, claims
from pieper.cli.path import write_csv
from pieper.cli.units import Units
from pieper.tolerances import STUDY_SAME

ARM = "denso-vp6242"
MM = 1e3
#: The line of the study, m, and its number of points.
FIRST, LAST, POINTS = (0.35, 0.0, 0.4), (0.2, 0.1, 0.5), 50
#: Random postures on which the inverse is tried.
TRIED = 20_000
#: The limits of joint 3 as the study prints them, deg; they are the controller's, not this table's.
PRINTED_JOINT_3 = (20.0, 160.0)


def orientations() -> dict[str, npt.NDArray[np.float64]]:
    """Return the tool orientations (3, 3) with which the line is tried."""
    Rx = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])
    Ry = np.array([[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]])
    return {
        "tool up (+z), R = I": np.eye(3),
        "tool forward (+x)": Ry,
        "tool sideways (+y)": Rx.T,
        "tool down (−z)": np.diag([1.0, -1.0, -1.0]),
    }


def line_of_study(R: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
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
        raise pieper.InputError(f"cannot make the folder {out}: {error.strerror}.", path=out) from None
    arm = pieper.load(ARM)
    page = sections.Document(
        "The Denso VP-6242, from its table to a followed line",
        "Forward and inverse kinematics, every solution verified, one branch followed along fifty points",
    )
    say(f"The arm: {arm.name}, {arm.n} joints, {arm.plan.family.replace('_', ' ')}")
    sections.add_arm(page, arm)
    say("Forward kinematics: the twelve printed equations against the table")
    _forward(page, arm)
    sections.add_plan(page, arm)
    sections.add_derivation(page, arm)
    say("Inverse kinematics: one pose solved, then many")
    recall = _inverse(page, arm, say)
    say("The line: 50 points, four tool orientations")
    track = _line(page, arm, say)
    _joint_move(page, arm, track)
    say("The reach")
    sections.add_reach(page, arm)
    _again(page)
    count = recall["count"]
    page.summary = (
        "Of the twelve forward equations that the source paper prints, eleven hold and P_x has lost a factor C2. "
        f"Every one of {recall['poses']:,} random poses has {count} solutions, all of them found and put back to "
        f"within {sections.scientific(recall['metres'] * MM)} mm. The straight line from (350, 0, 400) to (200, 100, "
        f"500) mm is followed by one continuous branch over {track.points} of {len(track.path)} points, with no "
        f"joint step larger than {sections.fixed(np.degrees(track.largest_step.max()), 2)}°."
    )
    written = sections.write_figures(page, out / "figures")
    say(f"{len(written) // 2} figures, each as PNG and SVG, in {out / 'figures'}")
    write_csv(arm, track, str(out / "line.csv"), Units())
    target = sections.write_page(page, out / "index.html")
    say(f"Done in {time.perf_counter() - begun:z.1f} s.")
    return target, track.complete


def _forward(page: sections.Document, arm: pieper.Arm) -> None:
    sections.add_forward(page, arm)
    q = arm.postures["line-start"]
    T = arm.fk(q)
    values = ", ".join(f"{sections.joint_value(arm, i, v, 3)}°" for i, v in enumerate(q))
    rows = [
        [axis, *(sections.fixed(v, 6) for v in T[i, :3]), sections.fixed(T[i, 3] * MM, 3)]
        for i, axis in enumerate(("x", "y", "z"))
    ]
    page.table(["", "n", "o", "a", "p, mm"], rows, f"The tool's pose at q = ({values}), where the line will begin.")
    page.section("What was printed of it")
    page.add(
        "The source paper prints the twelve entries of the pose as its Eqs. (5) to (7), the position as P. Each was "
        "compared with the product of the matrices of the paper's own Table 1, at random joints and in 50-digit "
        "arithmetic."
    )
    sections.attempt(page, "The judgement of the printed equations", lambda: _judged(page))


def _judged(page: sections.Document) -> None:
    judged = {v.id: v for v in pieper.check(claims()).verdicts}
    rows = []
    for entry, (number, _) in PRINTED.items():
        v = judged[entry]
        words = "holds identically" if v.holds else "wrong"
        rows.append([entry, f"({number})", words, f"{v.right} of {v.tried}", str(v.digits or "none")])
    page.table(
        ["entry", "Eq.", "verdict", "right at joint vectors", "digits that agree"],
        rows,
        "The twelve printed entries of the pose, judged.",
        left=(0, 1, 2),
        strong=tuple(i for i, entry in enumerate(PRINTED) if not judged[entry].holds),
    )
    details = dict(judged[LOST["entry"]].details)
    page.add(
        sections.Heading(("The lost C2",), 2),
        sections.Paragraph(
            (
                "P_x is printed with the term ",
                sections.Code(LOST["printed"]),
                " where it must be ",
                sections.Code(LOST["right"]),
                ". The judge finds the slip by itself: ",
                sections.Emphasis(details.get("the slip", "a factor is missing")),
                ". The printed formula minus the right one is ",
                sections.Code(judged[LOST["entry"]].difference),
                ", so it is right only where joint 2 stands at zero or the term vanishes. "
                f"{_upper(details.get('counter-example', ''))} (m). With C2 restored, P_x "
                f"{_lower(judged[LOST['entry'] + ' mended'].sentence)}",
            )
        ),
        sections.Listing(f"P_x as printed:  {PRINTED['Px'][1]}\nP_x restored:    {_mended()}"),
    )


def _mended() -> str:
    return PRINTED[LOST["entry"]][1].replace(LOST["printed"] + " ", LOST["right"] + " ")


def _upper(text: str) -> str:
    return (text[:1].upper() + text[1:]).rstrip(".")


def _lower(text: str) -> str:
    return text[:1].lower() + text[1:]


def _inverse(page: sections.Document, arm: pieper.Arm, say: Callable[[str], None]) -> dict[str, Any]:
    page.section("Inverse kinematics: every solution, verified")
    T = line_of_study(np.eye(3))[0]
    sols = arm.ik(T)
    sections.add_solutions(page, arm, sols)
    found = _recall(arm)
    say(f"  {found['poses']:,} random poses: {found['missed']} missed, worst residual {found['metres'] * MM:.1e} mm")
    missed = "in none of them was it missing" if not found["missed"] else f"in {found['missed']} of them it was missing"
    page.add(
        sections.Heading(("Many poses",), 2),
        f"Then {found['poses']:,} joint vectors were drawn evenly over whole turns, their poses computed and solved "
        f"again. The joint vector that had made the pose was looked for among the solutions; {missed}. The number of "
        f"solutions was {found['count']}, and all {found['solutions']:,} of them lead back to their pose within "
        f"{sections.scientific(found['metres'] * MM)} mm and {sections.scientific(np.degrees(found['radians']))}°. "
        "With a₁ = 0 the distance of the wrist from the shoulder is the same for both ways of facing it, so that a "
        "pose has all eight solutions or none.",
    )
    return found


def _recall(arm: pieper.Arm, n: int = TRIED) -> dict[str, Any]:
    """Return how the inverse did on n random joint vectors."""
    rng = np.random.default_rng(6242)
    q = rng.uniform(-np.pi, np.pi, (n, arm.n))
    T = arm.fk(q)
    many = arm.ik_many(T)
    apart = arm.chain.joints.apart(many.q, q[:, None])
    hit = (np.where(many.valid, apart, np.inf) < STUDY_SAME).any(1)
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


def _line(page: sections.Document, arm: pieper.Arm, say: Callable[[str], None]) -> pieper.Track:
    page.section("The straight line")
    path = line_of_study(np.eye(3))
    track = arm.follow(path, start=arm.postures["line-start"])
    say(f"  R = I: {track.points} of {len(path)} points on one branch")
    sections.add_track(page, arm, track, prefix="line")
    page.add(sections.Heading(("Which way the tool may point",), 2))
    rows, remarks = [], []
    for name, R in orientations().items():
        way = line_of_study(R)
        reached = int(arm.ik_many(way).valid.any(1).sum())
        attempt_ = arm.follow(way, start=track.followed[0])
        stop = attempt_.stop
        swing = [e for e in attempt_.events if not e.stop]
        passing = sum(b.complete for b in attempt_.branches)
        biggest = sections.fixed(np.degrees(attempt_.largest_step.max()), 1) + "°" if attempt_.points > 1 else "none"
        rows.append(
            [name, str(reached), str(attempt_.points), str(passing), biggest, stop.cause if stop else "reaches the end"]
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
        "solution, limits aside; the third, how far the branch nearest to the start gets inside the limits.",
        left=(0, 5),
    )
    page.add(*remarks)
    page.add(sections.Heading(("The printed limits of joint 3",), 2), _literal_limits(arm, track))
    return track


def _literal_limits(arm: pieper.Arm, track: pieper.Track) -> str:
    """Return what would happen if the printed limits were those of the table's third angle."""
    d = arm.description
    limits = d.limits.copy()
    limits[2] = np.radians(PRINTED_JOINT_3)
    literal = pieper.Arm.from_dh(d.rows, convention=d.convention, limits=limits.tolist(), name=d.name)
    sols = literal.ik(track.path[0])
    least = np.degrees(d.limits[2])
    return (
        "The paper's table prints 20° to 160° for joint 3. Taken for the angle θ₃ of that table they would forbid "
        f"the paper's own line: at its first point {len(sols.q)} of {len(sols.all_q)} solutions would be left. "
        f"({sols.why}) The elbow is straight, and singular, at θ₃ = −109.654°, which is where a mechanical stop "
        "belongs; the printed numbers fit when they are read as the controller's angle J₃ with θ₃ = −90° − J₃. The "
        f"robot file therefore holds θ₃ between {sections.fixed(least[0], 0)}° and {sections.fixed(least[1], 0)}°. "
        "That mapping is inferred, not printed."
    )


def _joint_move(page: sections.Document, arm: pieper.Arm, track: pieper.Track) -> None:
    page.section("The same two postures, joint by joint")
    motion = pieper.move(track.followed[0], track.followed[-1], 3.0, rate=100)
    tool = arm.fk(motion.q)[:, :3, 3]
    p0, p1 = track.path[0, :3, 3], track.path[-1, :3, 3]
    along = (p1 - p0) / np.linalg.norm(p1 - p0)
    off = tool - p0
    off = np.linalg.norm(off - (off @ along)[:, None] * along, axis=1).max()
    sections.add_motion(
        page,
        arm,
        motion,
        "Instead of a straight line one may let all joints move together, here in 3 s. The tool then leaves the "
        f"line by up to {sections.fixed(off * MM, 2)} mm.",
        name="joint-move",
    )


def _again(page: sections.Document) -> None:
    page.section("Do it again")
    page.add("Everything on this page can be had from the command line or from Python:")
    page.add(
        sections.Listing(
            "pieper show denso-vp6242\npieper fk denso-vp6242 line-start\npieper ik denso-vp6242 350 0 400 --all\n"
            'pieper path denso-vp6242 --from "350 0 400" --to "200 100 500" --start line-start --figures figures\n'
            "pieper report denso-vp6242\n"
        ),
        sections.Listing(
            "import pieper\n\n"
            'arm = pieper.load("denso-vp6242")\n'
            "T = arm.fk(arm.postures['line-start'])\n"
            "sols = arm.ik(T)              # every solution: sols.q, sols.labels, sols.residual\n"
            "path = pieper.line(T, T_end, n=50)\ntrack = arm.follow(path, start=sols.q[0])\n"
        ),
    )
