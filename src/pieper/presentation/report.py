"""The report of an arm: everything that can be said about it on one page that reads like a paper."""

from __future__ import annotations

import datetime
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from pieper import arguments
from pieper.document.blocks import Document, listed
from pieper.document.html import page as html_page
from pieper.document.latex import source as latex_source
from pieper.document.markdown import source as markdown_source
from pieper.document.writing import write_beside, write_whole
from pieper.drawing.style import MM
from pieper.equations.lettering import checked_letters
from pieper.errors import PieperError, PlanError
from pieper.kinematics.pose import checked_pose
from pieper.made_by import installed_version
from pieper.presentation import sections_arm
from pieper.presentation.plot_reach import joint_range
from pieper.presentation.sections_lesson import add_dh_steps, add_jacobian, add_triangle
from pieper.presentation.sections_motion import add_route, add_solutions, add_track, scientific
from pieper.presentation.sections_scale import add_fit, add_map
from pieper.tolerances import WHOLE_TURN
from pieper.words_by_number import plural

if TYPE_CHECKING:
    from pieper.calibration.fit import Fit
    from pieper.maps.reach_map import ReachMap
    from pieper.motion.route.result import Route
    from pieper.motion.track import Track
    from pieper.presentation.arm import Arm
    from pieper.solver.results import Solutions
    from pieper.verify.comparison import Comparison

#: Joint vectors from which the pose of the report is chosen.
CANDIDATES = 200


def report(
    arm: Arm,
    *,
    pose: np.ndarray | None = None,
    track: Track | None = None,
    route: Route | None = None,
    comparison: Comparison | None = None,
    reach_map: ReachMap | None = None,
    fit: Fit | None = None,
    letters: str = "noap",
) -> Document:
    """Return the report of an arm as a document.

    Args:
        arm: The arm.
        pose: (4, 4) the pose to solve, m; one with many solutions is chosen when left out.
        track: A path study to include.
        route: A route along poses that leave something free, found or refused, to include.
        comparison: What `arm.verify` found, to include.
        reach_map: A map of it to include.
        fit: A calibration of it to include.
        letters: "noap" (Paul) or "r" (r11 .. r33, Craig): the entries of a pose in the equations.

    Returns:
        The document, to be written by `document.html.page`, `document.latex.source` or `document.markdown.source`.

    Raises:
        InputError: pose is not a pose.
    """
    arm.description.not_linked("a report is written for arms of which every axis has a joint")
    given = pose is not None
    checked_letters(letters)
    today = datetime.date.today().isoformat()
    page = Document(
        f"Kinematics of the {arm.name}",
        _subtitle(arm),
        edition=f"pieper {installed_version() or '(not installed)'}, {today}",
    )
    sections_arm.add_arm(page, arm)
    add_dh_steps(page, arm)
    sections_arm.add_plan(page, arm)
    add_peculiarities(page, arm)
    sections_arm.add_forward(page, arm, letters)
    sections_arm.add_derivation(page, arm, letters)
    add_triangle(page, arm)
    T = checked_pose(pose, "pose") if given else _good_pose(arm)
    if T is not None:
        sections_arm.add_worked(page, arm, T, letters)
    solved = _solved(page, arm, T, given=given)
    add_jacobian(page, arm)
    sections_arm.add_singularities(page, arm)
    sections_arm.add_reach(page, arm)
    if track is not None:
        page.section("A path")
        add_track(page, arm, track)
    if route is not None:
        page.section("A route")
        add_route(page, route)
    if comparison is not None:
        add_comparison(page, comparison)
    if reach_map is not None:
        add_map(page, reach_map)
    if fit is not None:
        add_fit(page, fit)
    page.summary = _summary(arm, solved, track)
    return page


def write_report(
    arm: Arm,
    out: Path,
    *,
    latex: Path | None = None,
    markdown: Path | None = None,
    pose: np.ndarray | None = None,
    track: Track | None = None,
    route: Route | None = None,
    comparison: Comparison | None = None,
    reach_map: ReachMap | None = None,
    fit: Fit | None = None,
    letters: str = "noap",
) -> list[Path]:
    """Write the report of an arm, each file whole or not at all.

    Args:
        arm: The arm.
        out: The HTML page.
        latex: Where to write the same as LaTeX source, its figures in a folder beside it; not written when left out.
        markdown: Where to write the same as Markdown, its figures in a folder beside it; not written when left out.
        pose: As in `report`.
        track: As in `report`.
        route: As in `report`.
        comparison: As in `report`.
        reach_map: As in `report`.
        fit: As in `report`.
        letters: As in `report`.

    Returns:
        The files that were written, the page first.

    Raises:
        InputError: Another ending than .html, .tex and .md, or a place that cannot be written.
    """
    out = arguments.file_ending(out, (".html", ".htm"), "a report's page")
    latex = None if latex is None else arguments.file_ending(latex, (".tex",), "a report's LaTeX source")
    markdown = None if markdown is None else arguments.file_ending(markdown, (".md", ".markdown"), "its Markdown")
    page = report(
        arm,
        pose=pose,
        track=track,
        route=route,
        comparison=comparison,
        reach_map=reach_map,
        fit=fit,
        letters=letters,
    )
    written = [write_whole(out, html_page(page))]
    for path, source in ((latex, latex_source), (markdown, markdown_source)):
        if path is not None:
            text, figures = source(page, folder=f"{path.stem}-figures")
            written += [*write_beside(path, figures), write_whole(path, text)]
    return written


def add_comparison(page: Document, comparison: Comparison) -> None:
    """Add how far an arm and an independent toolbox are apart, and in which conventions that was asked."""
    page.section(f"Compared with {comparison.toolbox}")
    caption = f"Worst differences between {comparison.arm} and {comparison.toolbox}."
    page.table(["compared", "number", "worst difference"], comparison.cells(), caption)
    page.add(*comparison.explain().splitlines())


def _subtitle(arm: Arm) -> str:
    d = arm.description
    kinds = "".join(arm.joint_types)
    return f"{kinds}, {d.manufacturer}" if d.manufacturer else kinds


def good_pose(arm: Arm) -> np.ndarray:
    """Return the pose (4, 4) of a posture inside the limits that is far from singular and has many solutions there."""
    low, high = joint_range(arm)
    rng = np.random.default_rng(11)
    q = low + (high - low) * (0.08 + 0.84 * rng.random((CANDIDATES, arm.n)))
    T = arm.fk(q)
    many = arm.ik_many(T)
    rows = 3 if arm.plan.task == "position" else 6
    J = (arm.jacobian(q) * np.array([1 / arm.chain.length] * 3 + [1.0] * 3)[:, None])[:, :rows]
    sigma = np.linalg.svd(J, compute_uv=False)
    stiff = sigma[:, -1] / sigma[:, 0]
    # far from singularities, and a little for each solution that can be used
    return T[int(np.argmax(stiff * (1 + 0.15 * many.in_limits.sum(1))))]


def _good_pose(arm: Arm) -> np.ndarray | None:
    try:
        return good_pose(arm)
    except PlanError:
        return None


def _solved(page: Document, arm: Arm, T: np.ndarray | None, *, given: bool) -> Solutions | None:
    page.section("A pose and all its solutions")
    try:
        sols = arm.ik(good_pose(arm) if T is None else T)
    except PlanError as error:
        page.add(f"No pose is solved here: {error}")
        return None
    if not given:
        page.add(f"Of {CANDIDATES} random postures inside the limits, this pose's is among the farthest from singular.")
    add_solutions(page, arm, sols)
    return sols


def add_peculiarities(page: Document, arm: Arm) -> None:
    """Add what is peculiar about an arm, in words; nothing when nothing is."""
    d, notes = arm.description, []
    wide = [
        d.joint_names[i]
        for i, (a, b) in enumerate(d.limits)
        if arm.joint_types[i] == "R" and b - a > 2 * np.pi + WHOLE_TURN
    ]
    finite = [name for name in wide if np.isfinite(d.limits[d.joint_names.index(name)]).all()]
    if finite:
        notes.append(
            f"The range of {_and(finite)} is wider than one turn, so that one solution may be reached in several turns."
        )
    endless = [d.joint_names[i] for i, limits in enumerate(d.limits) if not np.isfinite(limits).any()]
    if endless:
        notes.append(f"No limit is known for {_and(endless)}.")
    try:
        plan = arm.plan
    except PieperError:
        plan = None
    if plan is not None:
        if arm.n < 6 and plan.task == "pose":
            notes.append(
                f"With {plural(arm.n, 'joint')} the arm cannot take an arbitrary pose: a pose is solved when it lies "
                "in what the arm can do."
            )
        if plan.task != "pose":
            notes.append(
                f"What is asked of this arm is not a full pose but the {plan.task.replace('+', ' and the tool ')}."
            )
        if plan.rank < min(arm.n, 6):
            notes.append(
                f"Although it has {arm.n} joints it can do only {plural(plan.rank, 'thing')} at once: some joints "
                "repeat one another."
            )
        if plan.redundancy:
            notes.append(f"It has more joints than the task needs; {_and(plan.redundancy)} may be chosen freely.")
        if plan.snapped:
            notes.append(f"Its geometry was taken as special where it is nearly so: {'; '.join(plan.snapped)}.")
        if plan.direct and plan.max_solutions > 8:  # more than three pairs of words can tell apart
            notes.append(
                f"Can it pass from one solution to another without meeting a singularity? It is {plan.cuspidal}."
            )
    if notes:
        page.section("What is peculiar about it", *notes)


def _and(words: Sequence[str]) -> str:
    return "".join(listed(words))


def _summary(arm: Arm, sols: Solutions | None, track: Track | None) -> str:
    text = f"The {arm.name} has {plural(arm.n, 'joint')} ({arm.joint_types})."
    try:
        counts = [arm.plan.count.most, sections_arm.by_formulas(arm)]
        text += f" A pose has at most {plural(min(c for c in counts if c is not None), 'solution')}."
    except PieperError:
        text += " It is beyond the solver; its geometry and forward kinematics are given."
    if sols is not None:
        text += f" The pose solved here has {len(sols.all_q)}, {len(sols.q)} of them inside the joint limits"
        if len(sols.q):
            text += f", put back to within {scientific(sols.residual[:, 0].max() * MM)} mm"
        text += "."
    if track is not None:
        text += f" The path is followed over {track.points} of its {plural(len(track.path), 'point')}."
    return text
