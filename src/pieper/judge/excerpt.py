"""Claims guessed from a text or LaTeX excerpt, written as a claims file for its reader to confirm.

Every line with an equals sign is looked at: what stands on the left says what kind of claim it is. Nothing is judged
here; what could not be read stands in the file as a remark with its reason.
"""

from __future__ import annotations

import itertools
import json
import re
from dataclasses import dataclass, field

from pieper.algebra.parser import parse, parse_equation
from pieper.algebra.spelling import plain
from pieper.errors import InputError
from pieper.judge.evidence import SIGN
from pieper.judge.excerpt_matrices import PLACED, taken_out
from pieper.judge.letters import pick_letters
from pieper.judge.model import POSE_NAMES, ArmModel
from pieper.judge.products import parse_product

_BLOCK = re.compile(r"\\(?:begin|end)\{(?:equation|align|aligned|gather|split|eqnarray|cases|math|displaymath)\*?\}")
_WHEN = re.compile(
    r"(?:,|;|\(|\s)\s*(?:\\text\{\s*)?(?:for|if|when|where|provided)\b\s*\}?\s*(.*?[<>].*)$", re.IGNORECASE
)
_NUMBER = re.compile(r"\\(?:tag|label)\{([^}]*)\}|\((\d+[a-z]?)\)\s*[.,;]?\s*$")
_CONDITION = re.compile(r"^[A-Z][a-z]+(?:\s+[a-z]+){1,8}\s+where\s.*=")
_RELATION = re.compile(r"(?:theta|d)\d+\s*=\s*-?\s*q\d+(?:\s*[-+][^=]*)?")
_TAKEN_OFF = re.compile(r"with the constant (base|tool)(?: and (tool))? taken off")
SINGULAR = "§singular§"  # before an equation that says where an arm is singular
ROUNDS = 4  # definitions that stand below their use, several deep
_UNEQUAL = re.compile(r"(?:,|;|\s(?:if|when|where|for)\b)[^,;]*(?:≠|!=|\\neq?\b).*$", re.IGNORECASE)
_EQUALS = re.compile(r"(?<![<>!=])=(?!=)")
_BETWEEN = re.compile(r"\$|\\\(|\\\)|\b(?:when|if|where|for|at|or|and)\b|,")
_PROSE = re.compile(r"[A-Za-z]{3,}\s+[A-Za-z]{3,}")
_SPACE = re.compile(r"\\q?quad\b")
_OWN = re.compile(r"([sc])_?\{?(\d)\}?$")
_LOWER = {f"p{c}": f"P{c}" for c in "xyz"}


@dataclass
class Guess:
    """One line of an excerpt, read.

    Attributes:
        line: Its number.
        text: As it stands there.
        keys: The claim's keys; empty where it is a symbol or was not read.
        symbol: Name and formula of a symbol that it defines.
        why: Why it was not read.
        relation: Whether it says what an angle of the table is by the maker's coordinate.
    """

    line: int
    text: str
    keys: dict[str, object] = field(default_factory=dict)
    symbol: tuple[str, str] | None = None
    why: str = ""
    relation: bool = False


def guesses(text: str, model: ArmModel) -> list[Guess]:
    """Guess what every equation of an excerpt claims.

    Args:
        text: Plain text or LaTeX.
        model: The arm that it is about.
    """
    lines, found = _lines(text), list[Guess]()
    signs = set(SIGN.findall(_unmarked(text)))
    defined: dict[str, tuple[bool, int]] = {}
    known: set[str] = set()
    for _ in range(ROUNDS):  # a symbol may be defined below the line that uses it, by others that are too
        before = dict(defined)
        for number, line, matrices in lines:
            guess = _guess(number, line, matrices, model, signs | (known - _left(line)))
            if guess.symbol:
                # of two lines for one symbol the definition is the one made of the pose's letters
                name, formula = guess.symbol
                rank = (not _has_pose(formula, known - {name}), number)
                defined[name] = min(rank, defined.get(name, rank))
        known = set(defined)
        if defined == before:
            break
    flat = model.n < 6 and not _has_pose(re.sub(r"\bp[xyz]\b", "", _unmarked(text), flags=re.IGNORECASE), set())
    said: list[dict[str, object]] = []
    sines: dict[str, str] = {}
    for number, line, matrices in lines:
        own = {name for name, (_, at) in defined.items() if at == number} & _left(line)
        guess = _guess(number, line, matrices, model, signs | (known - own))
        _put_in(guess, sines)
        if flat and guess.keys.get("kind") == "joint":
            guess.keys["task"] = "position"
        what = {key: value for key, value in guess.keys.items() if key != "id"}
        if what and what in said:
            continue  # a summary says again what was derived
        if what:
            said.append(what)
        found.append(guess)
    return found


def _put_in(guess: Guess, sines: dict[str, str]) -> None:
    """Put what a page found s5 and c5 to be into its theta5 = atan2(s5, c5), which would be circular by itself."""
    kind, formula = guess.keys.get("kind"), str(guess.keys.get("is", ""))
    if kind == "equation":
        left, _, right = formula.partition("=")
        own = _OWN.fullmatch(_unmarked(left).strip().lower())
        if own:
            sines[own.group(1) + own.group(2)] = right.strip()
    elif kind == "joint" and "joint" in guess.keys:
        for letter in "sc":
            name = f"{letter}{guess.keys['joint']}"
            if name in sines:
                formula = re.sub(rf"\b{letter}_?\{{?{name[1:]}\}}?(?![\d(])", f"({sines[name]})", formula, flags=re.I)
        guess.keys["is"] = formula


def _unmarked(text: str) -> str:
    return re.sub(r"[_{}]", "", plain(text))


def _left(line: str) -> set[str]:
    return {re.sub(r"[\s_{}&]", "", plain(line.partition("=")[0]))}


def _has_pose(formula: str, symbols: set[str]) -> bool:
    marks = {"".join(pair) for pair in itertools.product("noap", "xyz")} | {f"r{i}{j}" for i in "123" for j in "1234"}
    used = set(re.findall(r"[A-Za-z]+\d*", _unmarked(formula)))
    return bool(used & symbols or marks & {name.lower() for name in used})


def _lines(text: str) -> list[tuple[int, str, list[list[list[str]]]]]:
    """Every equation with the number of its line; matrices are taken out and stand as §0§, §1§."""
    text, matrices = taken_out(re.sub(r"(?<!\\)%.*", "", text))
    text = _BLOCK.sub(" ", text)
    out = []
    for number, line in enumerate(text.split("\n"), 1):
        for sentence in re.split(r"(?<=[.;])\s", line):
            if re.search(r"\bsingular", sentence, re.IGNORECASE) and _EQUALS.search(sentence):
                out += [(number, f"{SINGULAR}{piece}", matrices) for piece in _singular(sentence)]
                line = line.replace(sentence, "")
        if "$" in line and _CONDITION.search(line):
            out.append((number, line.strip(), matrices))
            continue
        for piece in re.split(r"\\\\(?:\[[^\]]*\])?|\$\$|(?<!\\)\$|\\\[|\\\]|\\\(|\\\)|;", line):
            if _EQUALS.search(piece):
                out.append((number, piece.strip(" \t.,&"), matrices))
    return out


def _singular(sentence: str) -> list[str]:
    """The equations of a sentence about singular configurations, joined by or."""
    pieces = [piece.strip(" .,;") for piece in _BETWEEN.split(sentence)]
    equations = [piece for piece in pieces if _EQUALS.search(piece) and not _PROSE.search(piece)]
    return [" or ".join(equations)] if equations else []


def _guess(number: int, line: str, matrices: list[list[list[str]]], model: ArmModel, known: set[str]) -> Guess:
    guess = Guess(number, PLACED.sub("[a matrix]", line.removeprefix(SINGULAR)))
    if line.startswith(SINGULAR):
        text = plain(line.removeprefix(SINGULAR)).strip()
        try:
            for part in text.split(" or "):
                parse_equation(part, model.names() | known, model.n)
            guess.keys = {"id": f"line {number}", "kind": "singular", "is": re.sub(r"\s+", " ", text)}
        except InputError as error:
            guess.why = str(error).splitlines()[0]
        return guess
    tag = _NUMBER.search(line)
    body = _UNEQUAL.sub("", _NUMBER.sub("", line)).strip(" .,&")  # where nothing vanishes, as everywhere here
    condition = _WHEN.search(body)
    if _CONDITION.search(body):
        guess.why = "a condition in a sentence, not a claim"
        return guess
    if condition:
        body = _SPACE.sub(" ", body[: condition.start()]).strip(" .,&")
    left, _, right = body.partition("=")
    left, right = left.strip(" &"), right.strip(" &")
    if _RELATION.fullmatch(_unmarked(f"{left} = {right}").strip()):
        guess.relation, guess.why = True, "the maker's zero of a joint: theta is the table's angle on this page"
        return guess
    if SIGN.fullmatch(_unmarked(left).strip()) and re.fullmatch(r"\s*(?:\+-|[+-])?\s*1\s*", plain(right)):
        guess.why = "what a sign may be, not a claim"
        return guess
    words = left.split()
    for first in range(max(1, len(words))):  # a sentence may stand before the formula
        try:
            _read(guess, " ".join(words[first:]), right, matrices, model, known)
            guess.why = ""
            break
        except InputError as error:
            guess.keys, guess.symbol, guess.why = {}, None, guess.why or str(error).splitlines()[0]
    if guess.keys:
        head = next((group for group in tag.groups() if group), "") if tag else ""
        guess.keys = {"id": head or f"line {number}", **guess.keys}
        if condition and guess.keys["kind"] in ("entry", "equation", "joint"):
            guess.keys["when"] = plain(condition.group(1)).strip(" .,)}")
    return guess


def _read(guess: Guess, left: str, right: str, matrices: list, model: ArmModel, known: set[str]) -> None:
    names = model.names() | known
    bare = re.sub(r"[\s_{}\\]|mathbf|mathrm|boldsymbol|text", "", left)
    placed = PLACED.fullmatch(right)
    if placed:
        _matrix(guess, bare, matrices[int(placed.group(1))], model)
        return
    if PLACED.search(right) or PLACED.search(left):
        raise InputError("a matrix among other things; write it as a claim of its own")
    if re.fullmatch(r"(?:det\(?J\)?|\|J\||detJ)", bare):
        guess.keys = {"kind": "determinant", "is": plain(_formula(right, model, names)).strip()}
        return
    entry = next((name for name, _, _ in POSE_NAMES if bare in (name, _LOWER.get(name, name))), "")
    if entry:
        guess.keys = {"kind": "entry", "of": entry, "is": _formula(right, model, names)}
        return
    products = [_product(side) for side in (left, right)]
    if all(_is_product(side, model) for side in products):
        guess.keys = {"kind": "product", "is": " = ".join(products)}
        return
    joint = _joint(left, model)
    if joint:
        guess.keys = {"kind": "joint", **joint, "is": _formula(right, model, names)}
        return
    symbol = re.sub(r"[\s_{}]", "", plain(left))
    alone = not re.search(r"[A-Za-z\d]\s+[A-Za-z]", plain(left).strip())
    if (
        alone
        and re.fullmatch(r"[A-Za-z]+\d*[A-Za-z]*'*", symbol)
        and symbol not in model.names()
        and symbol not in known
    ):
        text = _formula(right, model, names)
        if not re.fullmatch(r"[cCsS]\d+", symbol):
            guess.symbol = (symbol, text)
            return
    made, _ = pick_letters(f"{left} = {right}", model.n, frozenset())
    parse_equation(made, names | _picked(made, model), model.n)
    guess.keys = {"kind": "equation", "is": f"{plain(left).strip()} = {plain(right).strip()}"}


def _picked(text: str, model: ArmModel) -> set[str]:
    return set(pick_letters(text, model.n, frozenset())[1])


def _formula(text: str, model: ArmModel, names: set[str]) -> str:
    """The formula in the plain notation, after it was read once."""
    text, letters = pick_letters(plain(text), model.n, frozenset())
    parse(text, names | set(letters), model.n)
    return re.sub(r"\s+", " ", text).strip()


def _joint(left: str, model: ArmModel) -> dict[str, object]:
    try:
        angle = str(model.parse(left))
    except InputError:
        return {}
    alone = re.fullmatch(r"theta(\d+)", angle)
    if alone:
        return {"joint": int(alone.group(1))}
    for name, to in model.aliases.items():
        if angle == name:
            return {"joint": int(to.removeprefix("theta"))}
    return {"for": angle} if re.fullmatch(r"theta\d+(?: [-+] theta\d+)+", angle) else {}


def _product(text: str) -> str:
    """A product of matrices without the marks of subscripts: A_{1}^{-1} T_6 as A1^-1 T6."""
    text = re.sub(r"\^\s*\{\s*(-1|T)\s*\}", r"^\1", plain(text))
    return re.sub(r"\s+", " ", re.sub(r"_\s*\{?\s*(\d+)\s*\}?", r"\1 ", text)).strip()


def _is_product(text: str, model: ArmModel) -> bool:
    try:
        parse_product(text, model.n)
    except InputError:
        return False
    return True


def _matrix(guess: Guess, name: str, rows: list[list[str]], model: ArmModel) -> None:
    cells = [[plain(cell).strip() or "" for cell in row] for row in rows]
    if name in ("J", "Jv"):
        guess.keys = {"kind": "jacobian", "is": cells}
        return
    numbers = re.fullmatch(r"\^?(\d)(A|T)(\d)|([AT])\^?(\d)(\d)", name)
    if numbers:
        first, last = numbers.group(1) or numbers.group(5), numbers.group(3) or numbers.group(6)
        name = f"T{first}{last}"
    parse_product(name, model.n)
    guess.keys = {"kind": "matrix", "of": name, "is": cells}


def of_the_page(text: str, found: list[Guess]) -> list[str]:
    """The lines of [arm] that say how a page means its letters: the table's angles, base or tool taken off."""
    lines: list[str] = []
    if any(guess.relation for guess in found):
        lines.append('angles = "table"')
    off = _TAKEN_OFF.search(text)
    if off:
        lines.append("taken_off = " + json.dumps([part for part in off.groups() if part]))
    return lines


def claims_file(found: list[Guess], arm: str, source: str) -> str:
    """The guesses as a claims file.

    Args:
        found: What was read.
        arm: The lines of its [arm] table.
        source: The excerpt's name.
    """
    lines = [
        f"# Guessed from {source}. Look at every claim: its kind, its joint or entry, and the formula beside its line.",
        "# Mend or delete what was misread, then judge it with: pieper check <this file>",
        f"title = {_quoted(f'Claims of {source}')}",
        "",
        "[arm]",
        arm,
        "",
    ]
    symbols = [guess for guess in found if guess.symbol]
    if symbols:
        lines.append("[symbols]")
        for guess in symbols:
            assert guess.symbol is not None
            lines += [f"# line {guess.line}: {guess.text}", f"{guess.symbol[0]} = {_quoted(guess.symbol[1])}"]
        lines.append("")
    used: set[str] = set()
    for guess in found:
        if guess.why:
            lines += [f"# line {guess.line}, not read: {guess.text}", f"#   {guess.why}", ""]
        if not guess.keys:
            continue
        name = str(guess.keys["id"])
        while name in used:
            name += "'"
        used.add(name)
        lines += [f"# line {guess.line}: {guess.text}", "[[claim]]"]
        lines += [f"{key} = {_quoted(value)}" for key, value in {**guess.keys, "id": name}.items()]
        lines.append("")
    return "\n".join(lines)


def _quoted(value: object) -> str:
    return json.dumps(value, ensure_ascii=False)
