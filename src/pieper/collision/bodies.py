"""What an arm is made of: its bodies, where they come from, and which pairs of them may touch."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from pieper import arguments
from pieper.collision.guess import guessed
from pieper.description.bodyfield import BASE, TOOL
from pieper.description.dh import Description
from pieper.description.shapes import KINDS, Body, Shape, unique_names
from pieper.description.tree_bodies import known_bodies
from pieper.errors import InputError
from pieper.words_by_number import plural

Said = Shape | Sequence[Shape]


@dataclass(frozen=True, eq=False)
class Bodies(Sequence[Body]):
    """The bodies of an arm.

    Args:
        bodies: In the order of the links.
        allowed: Pairs of names that may touch: neighbours, what overlaps in every posture, and what was said.
        arm: The arm's name.
        notes: What of its file was left out, in sentences.
    """

    bodies: tuple[Body, ...]
    allowed: frozenset[frozenset[str]]
    arm: str = "arm"
    notes: tuple[str, ...] = ()

    def __len__(self) -> int:
        return len(self.bodies)

    def __getitem__(self, index: int) -> Body:  # type: ignore[override]
        return self.bodies[index]

    def __iter__(self) -> Iterator[Body]:
        return iter(self.bodies)

    @property
    def names(self) -> tuple[str, ...]:
        """One name a body."""
        return tuple(body.name for body in self.bodies)

    @property
    def guessed(self) -> bool:
        """Whether any of them was guessed from the arm's table."""
        return any(body.source.startswith("guessed") for body in self.bodies)

    def explain(self) -> str:
        """Return a line a body: its name, what it is, where it comes from; then the pairs that may touch."""
        lines = [f"{self.arm} has {plural(len(self), 'body', 'bodies')}:"]
        for body in self.bodies:
            lines.append(f"  {body.name}: {KINDS[type(body.shape)]}, {body.source or 'as it was said'}")
        pairs = sorted(" and ".join(sorted(pair)) for pair in self.allowed)
        lines.append(f"These may touch: {'; '.join(pairs) if pairs else 'none'}.")
        return "\n".join([*lines, *self.notes])

    def __repr__(self) -> str:
        kind = "guessed from the table" if self.guessed else "as described"
        return f"<Bodies of {self.arm}: {plural(len(self), 'body', 'bodies')}, {kind}>"


def bodies_of(arm: Description) -> Bodies:
    """Return the bodies of an arm: what its description has of links, guessed from the table where it has none.

    Bodies on the tool alone say nothing of the links, which are guessed beside them.
    """
    (said, notes), always = known_bodies(arm), set()
    if not any(1 <= body.on <= arm.n for body in said):
        own, always = guessed(arm)
        if any(body.on > arm.n for body in said):
            own = tuple(body for body in own if body.on <= arm.n)
        taken = [body.name for body in said]
        names = dict(
            zip((b.name for b in own), unique_names([*taken, *(b.name for b in own)])[len(taken) :], strict=True)
        )
        said = (*(replace(body, name=names[body.name]) for body in own), *said)
        always = {frozenset(names[name] for name in pair) for pair in always if pair <= set(names)}
    ordered = tuple(sorted(said, key=lambda body: body.on))
    pairs = {frozenset(pair) for pair in arm.allowed} | _neighbours(arm, ordered) | always
    return Bodies(ordered, frozenset(pairs), arm.name, notes)


def _place(arm: Description, body: Body) -> int:
    """Return the link a body moves with: the tool moves with the last one."""
    return min(body.on, arm.n)


def _neighbours(arm: Description, bodies: tuple[Body, ...]) -> set[frozenset[str]]:
    """Return pairs on one link, and on links between which no other has a body."""
    links = sorted({_place(arm, body) for body in bodies})
    next_to = dict(zip(links, links[1:], strict=False))
    return {
        frozenset((a.name, b.name))
        for i, a in enumerate(bodies)
        for b in bodies[i + 1 :]
        if _place(arm, b) in (_place(arm, a), next_to.get(_place(arm, a)))
    }


def with_bodies(
    arm: Description,
    where: Mapping[str, Said],
    *,
    allowed: Sequence[tuple[str, str]] = (),
    instead: bool = False,
) -> Description:
    """Return the arm with bodies added: "base", a joint's name (the link it moves) or "tool" -> shapes in that frame.

    Args:
        arm: The arm.
        where: What is carried where; a shape's own name is its body's, else the place's.
        allowed: Further pairs of names that may touch.
        instead: Whether they take the place of all bodies the arm had.

    Raises:
        InputError: No such place, something that is no shape, a name that is taken, a pair of unknown names.
    """
    places = [BASE, *arm.joint_names, TOOL]
    new: list[Body] = []
    for place, shapes in arguments.by_name(where, "where", '{"tool": pieper.Box(...)}').items():
        if place not in places:
            raise InputError(
                f"{arm.name} has no {place!r} to carry a body: say {', '.join(places)}.", given=place, allowed=places
            )
        for shape in shapes if isinstance(shapes, Sequence) else [shapes]:
            if not isinstance(shape, tuple(KINDS)):
                raise InputError(
                    f"a body on {place} must be a Box, Capsule, Cylinder or Convex, got {type(shape).__name__}.",
                    given=shape,
                )
            new.append(Body(shape.name or place, places.index(place), shape))
    kept = () if arguments.flag(instead, "instead") else known_bodies(arm)[0]
    taken = [body.name for body in kept]
    for body in new:
        if body.shape.name and (taken + [b.name for b in new if b is not body]).count(body.name):
            raise InputError(f"the name {body.name!r} is used twice; names of bodies must differ.", given=body.name)
    names = unique_names([*taken, *(body.name for body in new)])[len(taken) :]
    out = replace(arm, unmeasured=None, bodies=(*kept, *(replace(b, name=n) for b, n in zip(new, names, strict=True))))
    known = bodies_of(out).names
    touching = arguments.pairs(allowed, "allowed", "names of bodies")
    for name in (name for pair in touching for name in pair):
        if name not in known:
            raise InputError(
                f"there is no body {name!r} to allow a touch; there is {', '.join(known)}.", given=name, allowed=known
            )
    pairs = () if instead else arm.allowed
    return replace(out, allowed=(*pairs, *touching))
