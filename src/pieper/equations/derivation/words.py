"""The derivation in words: what a step starts from, why it has so many solutions, where it fails."""

from __future__ import annotations

import numpy as np

from pieper.algebra.expression import Add, Call, Num, Power, Sym, Trig, add, mul
from pieper.document.page import Page, Raw, comma_list, matrix_equation
from pieper.equations.derivation.closed_form import ClosedForm, Step

WHY = {
    "homogeneous": "Sine and cosine are in a known ratio, so there are two solutions half a turn apart, one for "
    "each sign of ",
    "one function": "One of sine and cosine is known, the other up to its sign ",
    "two functions": "An equation of this form has two solutions, one for each sign of ",
    "square of a slide": "Only the square is known; the sign is ",
    "quadratic of a slide": "This is a quadratic equation; its two roots go with the sign ",
}
QUARTIC = (
    "Both equations are linear in the cosine and sine of one joint; solved for the two expressions that hold "
    "them, squared and "
    "added, they lose that joint. What is left is a quartic in the half-angle tangent t, with at most four real "
    "roots, numbered "
    "from the smallest by "
)
ONCE = {
    "both functions": "Sine and cosine are both known up to one positive factor, so there is one solution:",
    "rotated pair": "These are two linear equations for cosine and sine, with one solution:",
    "linear pair": "These are two linear equations for cosine and sine, with one solution:",
    "slide": "The slide stands alone:",
}


def write_steps(page: Page, form: ClosedForm):
    """Write every step and the summary onto a page."""
    _opening(page, form)
    for step in form.steps:
        _step(page, form, step)
    _summary(page, form)


def _opening(page: Page, form: ClosedForm):
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
    parts: list = [said + "Each step uses entries of one matrix equation"]
    if sums:
        shown = min(sums, key=lambda t: t.order)
        parts += [
            "; ",
            shown,
            " stands for the cosine of ",
            add(*(mul(Num(k), symbol) for k, symbol in shown.argument())),
            ", and so on",
        ]
    page.paragraph(*parts, ".")
    relations = [
        (symbol, expr) for symbol, expr in form.table.relation.values() if expr.atoms() != {expr} and symbol.base != "q"
    ]
    if relations:
        page.paragraph("The angles and slides of the table belong to the joint coordinates as follows.")
        for symbol, expr in relations:
            page.display(symbol, expr)
    if form.chosen:
        names = comma_list([form.table.variable(j) for j in form.chosen])
        page.paragraph("The arm has a joint to spare: ", *names, " is chosen freely, and the rest follows.")


def _step(page: Page, form: ClosedForm, step: Step):
    page.heading(f"Step {step.number}: ", step.symbol)
    if step.kind == "sum":
        page.paragraph("The sum is known, and so are its other members:")
        page.display(step.symbol, step.formula)
        return
    page.paragraph(*_source(form, step))
    for left, right in step.equations:
        page.display(*_ordered(left, right))
    if step.names:
        page.paragraph("with" if len(step.names) > 1 or step.equations else "where")
        for symbol, expr in step.names:
            page.display(symbol, expr)
    if step.kind == "quartic":
        page.paragraph(
            QUARTIC, step.sigma, Raw(" = 1, 2, 3, 4", r" = 1, 2, 3, 4", "<mo>=</mo><mn>1, 2, 3, 4</mn>"), ":"
        )
    elif step.sigma is not None:
        page.paragraph(
            WHY[step.kind], step.sigma, Raw(" = +1 or -1", r" = \pm 1", "<mo>=</mo><mo>±</mo><mn>1</mn>"), ":"
        )
    else:
        page.paragraph(ONCE[step.kind])
    page.display(step.symbol, step.formula)
    _failures(page, form, step)


def _source(form: ClosedForm, step: Step) -> list:
    first = step.sources[0]
    same = all((s.i, s.j, s.kind) == (first.i, first.j, first.kind) for s in step.sources)
    sources = [first] if same else list(step.sources)
    parts: list = []
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


def _entries(places: list) -> str:
    named = [f"({r + 1},{c + 1})" for r, c in places]
    if len(named) == 1:
        return f"entry {named[0]}"
    return "entries " + ", ".join(named[:-1]) + " and " + named[-1]


def _ordered(left, right) -> tuple:
    """The side with the unknown first, unless the other is a plain number."""
    return left, right


def _failures(page: Page, form: ClosedForm, step: Step):
    if step.degenerate:
        conditions: list = []
        for place, condition in enumerate(step.degenerate):
            if place:
                conditions.append(" and ")
            bare = (
                mul(Num(-1), condition)
                if isinstance(condition, Sym) is False and _leads_negative(condition)
                else condition
            )
            conditions += [bare, Raw(" = 0", " = 0", "<mo>=</mo><mn>0</mn>")]
        page.paragraph(
            "It degenerates where ",
            *conditions,
            ": then ",
            step.symbol,
            " is free, any value may be chosen for it, and the steps after this one go on from that value.",
        )
    if step.merge is not None:
        inner = step.merge.args[0] if isinstance(step.merge, Call) and step.merge.name == "sqrt" else step.merge
        real = isinstance(inner, Add) and all(isinstance(t, Power) and t.power == 2 for t in inner.args)
        page.paragraph(
            "The two branches meet where ",
            inner,
            Raw(" = 0", " = 0", "<mo>=</mo><mn>0</mn>"),
            "." if real else "; where it is negative, these branches have no solution.",
        )


def _leads_negative(expr) -> bool:
    from pieper.algebra.notation import negative

    return negative(expr)


def _summary(page: Page, form: ClosedForm):
    page.heading("All joints together")
    signs = len(form.sigmas)
    if signs:
        page.paragraph(
            f"Evaluated in this order, with each of the {form.branches} combinations of the signs ",
            *comma_list(list(form.sigmas)),
            " held through all formulas:",
        )
    else:
        page.paragraph("Evaluated in this order:")
    for step in form.steps:
        page.display(step.symbol, step.formula)
    if form.free:
        free = comma_list([form.table.variable(j) for j in form.free])
        page.paragraph(
            *free, " is free: only its sum with the joints about the same line moves anything. Choose it first."
        )
    if form.conditions:
        page.paragraph("This arm cannot reach every pose. Of the combinations, keep those that also satisfy")
        for left, right, source in form.conditions:
            page.display(left, right)
            page.paragraph(f"({_entries(list(source.places))} of ", matrix_equation(source.i, source.j, form.n), ").")
    elif form.n - len(form.chosen) < 6 and form.given == "noap":
        page.paragraph(
            "An arm with fewer than six joints cannot reach every pose: the formulas answer for the "
            "poses that it "
            "can reach, and forward kinematics tells whether a given pose is one."
        )
