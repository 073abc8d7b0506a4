"""A program as C has it: values in blocks under the truths they are asked for under, and rows where they hold."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from pieper.code.folded import folded
from pieper.code.homes import Path, homes_of
from pieper.code.program import TRUTHS, LoopWords, Program, Words, loop_words


@dataclass(eq=False)
class Block:
    """What stands under truths: lines, and blocks under more of them.

    Args:
        path: The truths, nodes, in the order in which they are found.
        parent: The block that it stands in.
        parts: (kind, name, text), or a block. Kinds: const, truth, value (changed later), line.
        before: Names that are told in front of a block since they are used behind it too.
    """

    path: Path
    parent: Block | None = None
    parts: list[tuple[str, str, str] | Block] = field(default_factory=list)
    before: dict[int, list[tuple[str, bool]]] = field(default_factory=lambda: defaultdict(list))


class Stager:
    """Puts a program's values into blocks, in an order in which each is there when it is asked for."""

    def __init__(self, program: Program, words: Mapping[str, str], entry: Callable[[int], str]) -> None:
        self.program, self.homes = program, homes_of(program)
        homes = self.homes
        used: Counter[int] = Counter()
        for i in homes.home:
            used.update([homes.alike[i]] if i in homes.alike else homes.arguments(i))
        for path, (kind, what) in homes.ends:
            used.update([what] if kind == "doubt" else program.q[6 * what : 6 * what + 6])
            used.update(path * 2)
        for i, path in homes.guarded.items():
            used.update(path * 2)
            used[i] += 2
        self.words = Words(program, words, entry, used)
        self.said: set[int] = set()
        self.defined: dict[int, Block] = {}
        self.asked: dict[int, list[Block]] = defaultdict(list)
        self.refers: dict[int, set[int]] = {}
        self.waiting: dict[Path, list[tuple[str, int]]] = defaultdict(list)
        order: list[int] = []
        for i in program.order:
            loop = homes.loop_behind(i)
            order += [loop] if loop is not None and loop not in order else []
            order += [i] if i not in homes.bodies else []
        for i in order:
            if i in homes.home:
                self.waiting[homes.home[i]].append(("node", i))
            if i in homes.guarded:
                self.waiting[homes.guarded[i]].append(("then", i))
        for path, end in homes.ends:
            self.waiting[path].append(end)
        self.children: dict[Path, list[Path]] = defaultdict(list)
        for path in list(self.waiting):
            for k in range(len(path)):
                if path[: k + 1] not in self.children[path[:k]]:
                    self.children[path[:k]].append(path[: k + 1])
        self.top = Block(())
        while any(self.waiting.values()):
            left = sum(map(len, self.waiting.values()))
            self._fill(self.top)
            assert sum(map(len, self.waiting.values())) < left, "a value waits for itself"
        self._tell_early()

    def needs(self, kind: str, what: int) -> list[int]:
        """Return the nodes that must be there before something is said."""
        homes, program = self.homes, self.program
        if kind == "row":
            given: Sequence[int] = program.q[6 * what : 6 * what + 6]
        elif kind == "doubt":
            given = [what]
        elif kind == "then":
            # its other value is there once the choice has a name
            given = [program.nodes[what][2], -what - 2]
        elif what in homes.alike:
            given = [homes.alike[what]]
        elif what in homes.guarded:
            given = [program.nodes[what][3]]
        else:
            given = homes.arguments(what)
        return [a for a in given if a < 0 or a in homes.home]

    def _ready(self, item: tuple[str, int]) -> bool:
        return self.said.issuperset(self.needs(*item))

    def _complete(self, path: Path) -> bool:
        inside = [item for p, items in self.waiting.items() if p[: len(path)] == path for item in items]
        own = {i for kind, i in inside if kind in ("node", "then")} | {-i - 2 for _, i in inside}
        return all(self.said.issuperset(set(self.needs(*item)) - own) for item in inside)

    def _open(self, path: Path) -> bool:
        return self.said.issuperset(path) and any(
            self._ready(item) for p, items in self.waiting.items() if p[: len(path)] == path for item in items
        )

    def _fill(self, block: Block) -> None:
        moved = True
        while moved:
            moved = self._say_ready(block)
            open_ones = [p for p in self.children[block.path] if self._open(p)]
            for path in [p for p in open_ones if self._complete(p)] or open_ones[:1]:
                child = Block(path, block)
                self._note(block, path[-1])
                block.parts.append(child)
                self._fill(child)
                moved = True

    def _say_ready(self, block: Block) -> bool:
        waiting, some = self.waiting[block.path], False
        again = True
        while again:
            again, left = False, []
            for item in waiting:
                if self._ready(item):
                    self._say(block, *item)
                    again = some = True
                else:
                    left.append(item)
            waiting[:] = left
        return some

    def _names_in(self, i: int) -> set[int]:
        if i in self.defined:
            return {i}
        return self.refers.get(i, set())

    def _note(self, block: Block, *nodes: int) -> None:
        for i in nodes:
            for name in self._names_in(i):
                self.asked[name].append(block)

    def _say(self, block: Block, kind: str, what: int) -> None:
        program, homes, words = self.program, self.homes, self.words
        needed = [a for a in self.needs(kind, what) if a >= 0]
        if kind == "row":
            self._note(block, *needed)
            texts = [words.text(i) for i in program.q[6 * what : 6 * what + 6]]
            lines = [f"rows[{what}][{j}] = {text};" for j, text in enumerate(texts)]
            block.parts += [("line", "", line) for line in [*lines, f"valid[{what}] = 1;"]]
        elif kind == "doubt":
            self._note(block, *needed)
            block.parts.append(("line", "", f"doubt |= {words.text(what)};"))
        elif kind == "then":
            self._note(block, what, *needed)
            block.parts.append(("line", "", f"{words.names[what]} = {words.text(program.nodes[what][2])};"))
            self.said.add(what)
        elif what >= homes.loops:
            self._note(block, *needed)
            loop = loop_words(words, what - homes.loops, assign)
            block.parts += [("value", name, start) for name, start in zip(loop.names, loop.start, strict=True)]
            block.parts += [("line", "", line) for line in loop_lines(loop)]
            self.said.add(what)
        elif what in homes.alike:
            words.put_as(what, homes.alike[what])
            self.refers[what] = self._names_in(homes.alike[what])
            self.said.add(what)
        elif what in homes.guarded:
            self._note(block, *needed)
            name = words.name(what)
            self.defined[what] = block
            block.parts.append(("value", name, words.text(program.nodes[what][3])))
            self.said.add(-what - 2)
        else:
            said = words.put(what)
            self.said.add(what)
            if said is None:
                self.refers[what] = set().union(*(self._names_in(a) for a in needed))
            else:
                self._note(block, *needed)
                self.defined[what] = block
                block.parts.append(("truth" if said[1] else "const", said[0], said[2]))

    def _tell_early(self) -> None:
        """Names that are used outside the block they are found in are told in front of it."""
        for i, block in self.defined.items():
            where = block
            for user in self.asked[i]:
                while where.path != user.path[: len(where.path)] or not _within(user, where):
                    assert where.parent is not None
                    where = where.parent
            if where is not block:
                inside = block
                while inside.parent is not where:
                    assert inside.parent is not None
                    inside = inside.parent
                name = self.words.names[i]
                where.before[id(inside)].append((name, self.program.nodes[i][0] in TRUTHS))
                block.parts = [
                    ("line", "", f"{name} = {part[2]};") if isinstance(part, tuple) and part[1] == name else part
                    for part in block.parts
                ]


def _within(block: Block | None, around: Block) -> bool:
    while block is not None and block is not around:
        block = block.parent
    return block is around


def assign(name: str, truth: bool, expression: str) -> str:
    """Return a definition in C."""
    return f"const {'int' if truth else 'double'} {name} = {expression};"


def loop_lines(loop: LoopWords) -> list[str]:
    """Return a loop in C, behind what it carries."""
    return [
        f"for (step = 0; step < {loop.steps}; ++step) {{",
        *(f"  {line}" for line in loop.lines),
        *(f"  {name} = {text};" for name, text in zip(loop.names, loop.next, strict=True)),
        f"  if (!({loop.moving})) break;",
        "}",
    ]


_KINDS = ("const double ", "const int ", "double ")


def packed(lines: Sequence[str], width: int = 112) -> list[str]:
    """Return definitions, one a line, as lists of those that share their type; other lines as they are."""
    out: list[str] = []
    kind = ""
    for line in lines:
        said = line.lstrip()
        margin = line[: len(line) - len(said)]
        own = next((margin + k for k in _KINDS if said.startswith(k) and "[" not in said.split("=")[0]), "")
        rest = line[len(own) :]
        if not own or own != kind:
            out.append(line)
        elif len(out[-1]) + len(rest) + 1 < width:
            out[-1] = f"{out[-1][:-1]}, {rest}"
        else:
            out[-1] = out[-1][:-1] + ","
            out.append(f"{margin}  {rest}")
        kind = own
    return out


def _lines(block: Block, text: Callable[[int], str], margin: str) -> list[str]:
    """Return a block's lines, one definition a line."""
    out: list[str] = []
    run: list[list[str]] = []

    def end_of_run() -> None:
        if len(run) > 1 and (loop := folded(run, margin)) is not None:
            out.extend(loop)
        else:
            out.extend(line for lines in run for line in lines)
        run.clear()

    for part in block.parts:
        if isinstance(part, Block):
            before = block.before[id(part)]
            if before:
                end_of_run()
                out.extend(f"{margin}{'int' if truth else 'double'} {name} = 0;" for name, truth in before)
            truths = [part.path[-1]]
            while len(part.parts) == 1 and isinstance(part.parts[0], Block) and not part.before[id(part.parts[0])]:
                part = part.parts[0]
                truths.append(part.path[-1])
            head = f"{margin}if ({' && '.join(map(text, truths))}) {{"
            run.append([head, *_lines(part, text, margin + " "), f"{margin}}}"])
            if before:
                end_of_run()
        else:
            end_of_run()
            kind, name, said = part
            if kind != "line":
                said = f"double {name} = {said};" if kind == "value" else assign(name, kind == "truth", said)
            out.append(margin + said)
    end_of_run()
    return out


def staged(program: Program, words: Mapping[str, str], entry: Callable[[int], str]) -> str:
    """Return the lines of C that fill `rows` and `valid` where rows hold, and set `doubt` where none vouches."""
    stager = Stager(program, words, entry)
    lines = _lines(stager.top, stager.words.text, "  ")
    counters = [name for name in ("step", "each") if any(f"({name} = 0;" in line for line in lines)]
    return "\n".join(([f"  int {', '.join(counters)};"] if counters else []) + packed(lines))
