"""Claims guessed from a text or LaTeX excerpt, written as a claims file for its reader to confirm.

Every line with an equals sign is looked at: what stands on the left says what kind of claim it is. Nothing is judged
here; what could not be read stands in the file as a remark with its reason.
"""

from __future__ import annotations

import itertools
import re
from dataclasses import dataclass, field

from pieper.algebra.parser import parse, parse_equation
from pieper.algebra.spelling import plain
from pieper.errors import InputError
from pieper.judge.conditions import read_conditions
from pieper.judge.evidence import SIGN
from pieper.judge.excerpt_counts import Counted, counted
from pieper.judge.excerpt_lengths import lengths_meant
from pieper.judge.excerpt_lines import BRANCH, CONDITION, SINGULAR, Line, bare, equations
from pieper.judge.excerpt_matrices import PLACED
from pieper.judge.letters import pick_letters
from pieper.judge.model import POSE_NAMES, ArmModel
from pieper.judge.products import parse_product

_WHEN = re.compile(
    r"(?:,|;|\(|\s)\s*(?:\\text\{\s*)?(?:for|if|when|where|provided)\b\s*\}?\s*(.*?[<>].*)$", re.IGNORECASE
)
_RELATION = re.compile(r"(?:theta|d)\d+\s*=\s*-?\s*q\d+(?:\s*[-+][^=]*)?")
ROUNDS = 64  # definitions that stand below their use, many deep; it ends as soon as nothing is new
_UNEQUAL = re.compile(r"(?:,|;|\s(?:if|when|where|for)\b)[^,;]*(?:≠|!=|\\neq?\b).*$", re.IGNORECASE)
_SQUARE = re.compile(r"([A-Za-z]+\d*)\^\(?2\)?")
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
    text = bare(text)
    lines, found = equations(text), list[Guess]()
    stands = _undefined(lines, model)
    signs = set(SIGN.findall(_unmarked(text))) | set(stands)
    defined: dict[str, tuple[bool, int]] = {}
    known: set[str] = set()
    for _ in range(ROUNDS):  # a symbol may be defined below the line that uses it, by others that are too
        before = dict(defined)
        for line in lines:
            guess = _guess(line, model, signs | (known - _left(line.text)), stands)
            if guess.symbol:
                # of two lines for one symbol the definition is the one made of the pose's letters
                name, formula = guess.symbol
                # (a symbol that is itself made of them counts as one, a twist's cosine does not)
                posed = {other for other, (lacks, _) in defined.items() if not lacks}
                rank = (not _has_pose(formula, posed - {name}), line.number)
                defined[name] = min(rank, defined.get(name, rank))
        known = set(defined)
        if defined == before:
            break
    flat = model.n < 6 and not _has_pose(re.sub(r"\bp[xyz]\b", "", _unmarked(text), flags=re.IGNORECASE), set())
    said: list[dict[str, object]] = []
    sines: dict[str, str] = {}
    for line in lines:
        own = {name for name, (_, at) in defined.items() if at == line.number} & _left(line.text)
        guess = _guess(line, model, signs | (known - own), stands)
        _put_in(guess, sines)
        if flat and guess.keys.get("kind") == "joint":
            guess.keys["task"] = "position"
        what = {key: value for key, value in guess.keys.items() if key != "id"}
        if what and what in said:
            continue  # a summary says again what was derived
        if what:
            said.append(what)
        found.append(guess)
    found += [_counting(said, model, signs | known) for said in counted(text)]
    return _of_letters(sorted(found, key=lambda guess: guess.line), stands, model)


def _counting(said: Counted, model: ArmModel, known: set[str]) -> Guess:
    """A sentence that says how many solutions there are; its condition must be one that can be read."""
    guess = Guess(said.line, said.text, {"id": f"line {said.line}", **said.keys} if said.keys else {}, why=said.why)
    if "when" in guess.keys:
        try:
            read_conditions(str(guess.keys["when"]), lambda text: parse(text, model.names() | known, model.n))
        except InputError as error:
            guess.keys, guess.why = {}, str(error).splitlines()[0]
    return guess


def _of_letters(found: list[Guess], stands: dict[str, str], model: ArmModel) -> list[Guess]:
    """The guesses with what letters of the page stand for; what uses one that stands for nothing known is not read."""
    own = [name for name, meaning in stands.items() if meaning == "?"]
    meant = lengths_meant(model, own, [guess.keys for guess in found if guess.keys]) if own else {}
    first: list[Guess] = []
    for name, meaning in stands.items():
        if meaning != "?":
            first.append(Guess(0, f"{name}, for the tool's place", symbol=(name, meaning)))
        elif name in meant:
            told = f"{name}: with {meant[name]} for it the lines come out right; is that what the page means by it?"
            first.append(Guess(0, told, symbol=(name, meant[name])))
    lost = {name: "no length of this arm; write the arm's own name for it" for name in own if name not in meant}
    again = bool(lost)
    while again:  # what uses a symbol that was lost is lost too
        again = False
        for guess in found:
            text = f"{guess.keys.get('is', '')} {guess.keys.get('when', '')} {guess.symbol[1] if guess.symbol else ''}"
            used = sorted(set(lost) & set(re.findall(r"[A-Za-z]+\d*", _unmarked(text))))
            if used and (guess.keys or guess.symbol):
                if guess.symbol:
                    lost[guess.symbol[0]], again = "not read above", True
                guess.keys, guess.symbol = {}, None
                guess.why = f"{', '.join(used)}: {lost[used[0]]}"
    return first + found


def _put_in(guess: Guess, sines: dict[str, str]) -> None:
    """Put what a page found s5 and c5 to be into its theta5 = atan2(s5, c5), which would be circular by itself."""
    kind, formula = guess.keys.get("kind"), guess.keys.get("is", "")
    if not isinstance(formula, str):
        return
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
    name = re.sub(r"[\s_{}&]", "", plain(line.partition("=")[0]))
    return {name, re.sub(r"\^\(?2\)?$", "", name)}


def _undefined(lines: list[Line], model: ArmModel) -> dict[str, str]:
    """Letters that the page uses and never defines: x, y, z for the tool's place, and lengths of its own naming."""
    given, used, lefts = model.names(), list[tuple[str, str]](), dict[str, list[str]]()
    cells = [" ".join(itertools.chain(*rows)) for rows in (lines[0].matrices if lines else [])]
    for text in [*(line.text.removeprefix(SINGULAR) for line in lines), *cells]:
        left, _, right = _unmarked(text).partition("=")
        lefts.setdefault(left.strip(), []).append(right)
        used += re.findall(r"(?<![A-Za-z\d.])([A-Za-z])(\d*)(?![\w(\[])", _unmarked(text))
    stands: dict[str, str] = {}
    place = {letter for letter, digits in used if not digits and letter.lower() in "xyz"} - given
    if len(place) > 1:
        own = {name for name in place if any(_has_pose(right, set()) for right in lefts.get(name, []))}
        stands |= {name: f"p{name.lower()}" for name in sorted(place - own)}
    for letter, digits in used:
        name = letter + digits
        if digits and letter in "lLhHedab" and name not in given and name not in lefts:
            stands[name] = "?"
    return stands


def _has_pose(formula: str, symbols: set[str]) -> bool:
    marks = {"".join(pair) for pair in itertools.product("noap", "xyz")} | {f"r{i}{j}" for i in "123" for j in "1234"}
    used = set(re.findall(r"[A-Za-z]+\d*", _unmarked(formula)))
    return bool(used & symbols or marks & {name.lower() for name in used})


#: What stands between the parts of a formula.
_SIGNS = "+-*/^=("
#: The Jacobian's determinant as pages write it, marks taken off: det J_v, |J(q)|, det(J).
_DETERMINANT = re.compile(r"(?:det|\|)[(\[]?J[vpLl]?(?:\((?:q|theta|θ)\))?[)\]]?\|?")


def _guess(line: Line, model: ArmModel, known: set[str], stands: dict[str, str]) -> Guess:
    guess = Guess(line.number, PLACED.sub("[a matrix]", line.text.removeprefix(SINGULAR)).replace(BRANCH, "or"))
    if line.text.startswith(SINGULAR):
        text = plain(line.text.removeprefix(SINGULAR)).strip()
        try:
            for part in text.split(" or "):
                parse_equation(part, model.names() | known, model.n)
            guess.keys = {"id": f"line {line.number}", "kind": "singular", "is": re.sub(r"\s+", " ", text)}
        except InputError as error:
            guess.why = str(error).splitlines()[0]
        return guess
    body = _UNEQUAL.sub("", line.text).strip(" .,&")  # where nothing vanishes, as everywhere here
    condition = _WHEN.search(body)
    if CONDITION.search(body):
        guess.why = "a condition in a sentence, not a claim"
        return guess
    if condition:
        body = body[: condition.start()]
    body = re.sub(r"(?:\s|[.,&]|\\q?quad\b)+$", "", body)
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
        if first and (words[first][0] in _SIGNS or words[first - 1][-1] in _SIGNS):
            continue  # the end of a sum is none of its own
        try:
            first_words = " ".join(words[first:])
            _read(guess, stands.get(first_words, first_words), right, line.matrices, model, known)
            guess.why = ""
            break
        except InputError as error:
            guess.keys, guess.symbol, guess.why = {}, None, guess.why or str(error).splitlines()[0]
    if guess.keys:
        guess.keys = {"id": line.tag or f"line {line.number}", **guess.keys}
        if condition and guess.keys["kind"] in ("entry", "equation", "joint"):
            guess.keys["when"] = plain(condition.group(1)).strip(" .,)}")
    return guess


def _read(guess: Guess, left: str, right: str, matrices: list, model: ArmModel, known: set[str]) -> None:
    names = model.names() | known
    name = re.sub(r"[\s_{}\\]|mathbf|mathrm|boldsymbol|text", "", left)
    placed = PLACED.fullmatch(right)
    if placed:
        _matrix(guess, name, matrices[int(placed.group(1))], model, names)
        return
    if PLACED.search(right) or PLACED.search(left):
        raise InputError("a matrix among other things; write it as a claim of its own")
    if _DETERMINANT.fullmatch(name):
        guess.keys = {"kind": "determinant", "is": plain(_formula(right, model, names)).strip()}
        return
    if BRANCH in right:
        joint, parts = _joint(left, model), right.split(BRANCH)
        if not joint or len(parts) != 2:
            raise InputError("two branches are read of a joint's formula; write a claim for each")
        guess.keys = {"kind": "joint", **joint, "is": [_formula(part, model, names) for part in parts]}
        return
    entry = next((e for e, _, _ in POSE_NAMES if name in (e, _LOWER.get(e, e))), "")
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
    square = _SQUARE.fullmatch(symbol)
    if square and square.group(1) not in names and not re.fullmatch(r"[cCsS]\d*", square.group(1)):
        guess.symbol = (square.group(1), f"sqrt({_formula(right, model, names)})")
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


def _matrix(guess: Guess, name: str, rows: list[list[str]], model: ArmModel, names: set[str]) -> None:
    cells = [[plain(cell).strip() or "" for cell in row] for row in rows]
    for cell in (cell for row in cells for cell in row if cell not in ("", "*")):
        _formula(cell, model, names)
    if name in ("J", "Jv"):
        guess.keys = {"kind": "jacobian", "is": cells}
        return
    numbers = re.fullmatch(r"\^?(\d)(A|T)(\d)|([AT])\^?(\d)(\d)", name)
    if numbers:
        first, last = numbers.group(1) or numbers.group(5), numbers.group(3) or numbers.group(6)
        name = f"T{first}{last}"
    parse_product(name, model.n)
    guess.keys = {"kind": "matrix", "of": name, "is": cells}
