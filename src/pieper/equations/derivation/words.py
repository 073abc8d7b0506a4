"""The derivation in words: what a step starts from, why it has so many solutions, where it fails."""

from __future__ import annotations

import numpy as np

from pieper.algebra.expression import Add, Call, Num, Power, Sym, Trig, add, mul
from pieper.algebra.notation import negative
from pieper.document.blocks import Document, Piece, listed
from pieper.document.blocks import Step as StepHeading
from pieper.document.formulas import ZERO, Written, equals
from pieper.equations.derivation.closed_form import ClosedForm
from pieper.equations.derivation.degenerate import FREE, IMPOSSIBLE, MIXED, UNREACHED, Case
from pieper.equations.derivation.loop import matrix_equation
from pieper.equations.derivation.step import Step

WHY = {
    "homogeneous": "Sine and cosine are in a known ratio, so there are two solutions half a turn apart, one for "
    "each sign of ",
    "one function": "One of sine and cosine is known, the other up to its sign ",
    "two functions": "An equation of this form has two solutions, one for each sign of ",
    "square of a slide": "Only the square is known; the sign is ",
    "quadratic of a slide": "This is a quadratic equation; its two roots go with the sign ",
}
QUARTIC = (
    "Both equations are linear in the cosine and sine of one joint; solved for the two expressions that hold them, "
    "squared and added, they lose that joint. What is left is a quartic in the half-angle tangent t, with at most "
    "four real roots, numbered from the smallest by "
)
ONCE = {
    "both functions": "Sine and cosine are both known up to one positive factor, so there is one solution:",
    "rotated pair": "These are two linear equations for cosine and sine, with one solution:",
    "linear pair": "These are two linear equations for cosine and sine, with one solution:",
    "slide": "The slide stands alone:",
}


def write_steps(page: Document, form: ClosedForm) -> None:
    """Write every step and the summary onto a page."""
    _opening(page, form)
    for step in form.steps:
        _step(page, form, step)
    _joints(page, form)
    _summary(page, form)


def _opening(page: Document, form: ClosedForm) -> None:
    d = form.description
    plain_base, plain_tool = (np.array_equal(M, np.eye(4)) for M in (d.base, d.tool))
    columns = {
        "noap": "with the columns n, o, a and p",
        "p": "of which the task gives the position p",
        "ap": "of which the task gives the approach a and the position p",
    }[form.given]
    said = f"The wanted pose is T, {columns}. "
    if not plain_base or not (plain_tool or form.fold_tool):
        known = " and ".join(
            w for w, plain in (("base", plain_base), ("tool", plain_tool or form.fold_tool)) if not plain
        )
        said += f"Here T stands for the pose with the constant {known} taken off. "
    if form.fold_tool and not plain_tool:
        said += "The constant tool is counted to the last link. "
    sums = [
        t
        for step in form.steps
        for left, right in step.equations
        for t in (left.atoms() | right.atoms())
        if isinstance(t, Trig) and len(t.angle) == 2 and t.kind == "c"
    ]
    parts: list[Piece] = [said + "Each step uses entries of one matrix equation"]
    if sums:
        shown = min(sums, key=lambda t: t.order)
        parts += [
            "; ",
            shown,
            " stands for the cosine of ",
            add(*(mul(Num(k), symbol) for k, symbol in shown.argument())),
            ", and so on",
        ]
    page.say(*parts, ".")
    relations = [
        (symbol, expr) for symbol, expr in form.table.relation.values() if expr.atoms() != {expr} and symbol.base != "q"
    ]
    if relations:
        numbers = any(isinstance(n, Num) and n.value not in (1, -1) for _, expr in relations for n in expr.walk())
        units = ", in radians and metres" if numbers else ""
        page.say(f"The angles and slides of the table belong to the joint coordinates as follows{units}.")
        for symbol, expr in relations:
            page.show(symbol, expr)
    twists = [(s, x) for s, x in form.table.meaning.items() if isinstance(x, Call)]
    if twists:
        page.say("Turns of the table that are no quarter turns have names for their cosines and sines.")
        for symbol, expr in twists:
            page.show(symbol, expr)
    if form.chosen:
        names = listed([form.table.variable(j) for j in form.chosen])
        one = len(form.chosen) == 1
        head = "The arm has a joint to spare: " if one else "The arm has joints to spare: "
        page.say(head, *names, f" {'is' if one else 'are'} chosen freely, and the rest follows.")


def _step(page: Document, form: ClosedForm, step: Step) -> None:
    page.add(StepHeading(step.number, step.symbol, step.branches))
    if step.kind == "sum":
        page.say("The sum is known, and so are its other members:")
        page.show(step.symbol, step.formula, number=step.number)
        return
    page.say(*_source(form, step))
    for left, right in step.equations:
        page.show(left, right)
    if step.names:
        page.say("with" if len(step.names) > 1 or step.equations else "where")
        for symbol, expr in step.names:
            page.show(symbol, expr)
    if step.sigma is None:
        page.say(ONCE[step.kind])
    elif step.kind == "quartic":
        page.say(QUARTIC, equals(step.sigma, Written("1, 2, 3, 4", "1, 2, 3, 4", "<mn>1, 2, 3, 4</mn>")), ":")
    else:
        page.say(WHY[step.kind], equals(step.sigma, Written("+1 or -1", r"\pm 1", "<mo>±</mo><mn>1</mn>")), ":")
    page.show(step.symbol, step.formula, number=step.number)
    _failures(page, form, step)


def _source(form: ClosedForm, step: Step) -> list[Piece]:
    first = step.sources[0]
    same = all((s.i, s.j, s.kind) == (first.i, first.j, first.kind) for s in step.sources)
    sources = [first] if same else list(step.sources)
    parts: list[Piece] = []
    for place, source in enumerate(sources):
        places = [p for s in (step.sources if same else [source]) for p in s.places]
        entries = _entries(places)
        equation = matrix_equation(source.i, source.j, form.n, inverse=source.kind.startswith("inverse"))
        if source.kind.endswith("squares"):
            parts += [
                ("and the" if place else "The") + f" squares of {entries} of ",
                equation,
                ", added up, " + ("leave one unknown" if step.kind != "quartic" else "leave two unknowns"),
            ]
        else:
            verb = "hold" if len(places) > 1 else "holds"
            word = entries[0].upper() + entries[1:] if not place else "and " + entries
            parts += [
                f"{word} of ",
                equation,
                f" {verb} " + ("two unknowns" if step.kind == "quartic" else "no other unknown"),
            ]
        parts.append(":" if place == len(sources) - 1 else ", ")
    return parts


def _entries(places: list[tuple[int, int]]) -> str:
    named = [f"({r + 1},{c + 1})" for r, c in places]
    if len(named) == 1:
        return f"entry {named[0]}"
    return "entries " + ", ".join(named[:-1]) + " and " + named[-1]


def _failures(page: Document, form: ClosedForm, step: Step) -> None:
    if step.degenerate:
        _degenerate(page, form, step)
    if step.merge is not None:
        inner = step.merge.args[0] if isinstance(step.merge, Call) and step.merge.name == "sqrt" else step.merge
        real = isinstance(inner, Add) and all(isinstance(t, Power) and t.power == 2 for t in inner.args)
        page.say(
            "The two branches meet where ",
            equals(inner, ZERO),
            "." if real else "; where it is negative, these branches have no solution.",
        )


def _degenerate(page: Document, form: ClosedForm, step: Step) -> None:
    bare = [mul(Num(-1), c) if not isinstance(c, Sym) and negative(c) else c for c in step.degenerate]
    conditions: list[Piece] = []
    for condition in bare:
        conditions += [" and "] * bool(conditions) + [equals(condition, ZERO)]
    case = form.case(step)
    if case.kind == IMPOSSIBLE:
        page.say("It would degenerate where ", *conditions, ", which cannot be with these lengths.")
    elif case.kind == UNREACHED and case.rest is not None:
        said = ": the equation then reads ", equals(ZERO, case.rest), ", which is not so. Such a pose is out of reach."
        page.say("It has no solution where ", *conditions, *said)
    elif case.kind == UNREACHED:
        page.say("It would degenerate where ", *conditions, ", which is so at no pose that the arm reaches.")
    elif case.kind == FREE:
        page.say(
            "It degenerates where ",
            *conditions,
            ": then ",
            step.symbol,
            " is free. Any value may be chosen for it with which the steps after this one have a solution, and they go "
            "on from that value.",
        )
        _told_apart(page, form, case)
    else:
        _decided(page, form, step, case, conditions)


def _decided(page: Document, form: ClosedForm, step: Step, case: Case, conditions: list[Piece]) -> None:
    page.say("It degenerates where ", *conditions, ": then it says nothing of ", step.symbol, ".")
    others = form.instead(step)
    if case.kind == MIXED:
        page.say("At some of these poses ", step.symbol, " is free, and any value may be chosen for it; at others not.")
    if not others:
        if case.kind != MIXED:
            page.say("What decides it there is that all other equations hold too; no single one of them gives it.")
        _told_apart(page, form, case)
        return
    last = others[-1]
    lead = "Another equation decides it there. " if len(others) == 1 else "Another order of steps decides it there. "
    for other in others:
        page.say(lead, *_source(form, other))
        lead = ""
        for left, right in other.equations:
            page.show(left, right)
        if other.names:
            page.say("with")
            for symbol, expr in other.names:
                page.show(symbol, expr)
        page.say("from which, where the step degenerates," if other is last else "from which there")
        page.show(other.symbol, other.formula)
    if any(other.sigma is not None and other.sigma in form.sigmas for other in others):
        met = next(other.sigma for other in others if other.sigma is not None)
        page.say("The two branches of ", met, ", which meet in the step that brought it, are told apart here.")
    if len(others) > 1:
        page.say("The steps after this one go on from ", step.symbol, " as they stand.")
    _told_apart(page, form, case)


def _told_apart(page: Document, form: ClosedForm, case: Case) -> None:
    """Say which combinations of signs, and which chosen values, are solutions where a step degenerates."""
    if case.conditions is None:
        if form.chosen:
            page.say("A value that was chosen may have no solution there: forward kinematics tells.")
        return
    chosen = " and of the values that were chosen" if form.chosen else ""
    if not case.conditions:
        page.say(
            f"Not every combination of the signs{chosen} has a solution there: keep those that forward kinematics "
            "leads back to the pose."
        )
        return
    page.say(f"Not every combination of the signs{chosen} has a solution there: keep those that also satisfy")
    for left, right, source in case.conditions:
        page.show(left, right)
        page.say(f"({_entries(list(source.places))} of ", matrix_equation(source.i, source.j, form.n), ").")


def _joints(page: Document, form: ClosedForm) -> None:
    """Say how the joints' own numbers follow, where joints are coupled."""
    if not form.joint_formulas:
        return
    page.say("These joints are coupled: their own numbers follow from the angles and slides above.")
    for symbol, expr in form.joint_formulas.items():
        page.show(symbol, expr)
    page.say("A whole turn of an angle above leads to the same posture of the arm with other numbers of these joints.")


def _summary(page: Document, form: ClosedForm) -> None:
    page.heading("All joints together")
    signs = len(form.sigmas)
    quartic = signs == 1 and any(step.kind == "quartic" for step in form.steps)
    if signs:
        page.say(
            f"Evaluated in this order, with each of the {form.branches} "
            + ("combinations of the signs " if signs > 1 else "values of " if quartic else "values of the sign "),
            *listed(form.sigmas),
            " held through all formulas:",
        )
    else:
        page.say("Evaluated in this order:")
    for step in form.steps:
        page.show(step.symbol, step.formula, number=step.number)
    if form.free:
        free = listed([form.table.variable(j) for j in form.free])
        if len(form.free) == 1:
            said = " is free: only its sum with the joints about the same line moves anything. Choose it first."
        else:
            said = " are free: only their sums with the joints about the same line move anything. Choose them first."
        page.say(*free, said)
    if form.conditions:
        page.say("This arm cannot reach every pose. Of the combinations, keep those that also satisfy")
        for left, right, source in form.conditions:
            page.show(left, right)
            page.say(f"({_entries(list(source.places))} of ", matrix_equation(source.i, source.j, form.n), ").")
    elif form.n - len(form.chosen) < 6 and form.given == "noap":
        page.say(
            "An arm with fewer than six joints cannot reach every pose: the formulas answer for the poses that it "
            "can reach, and forward kinematics tells whether a given pose is one."
        )
