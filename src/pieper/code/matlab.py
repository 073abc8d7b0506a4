"""The printer of MATLAB and Octave: a file a function, as these languages want it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from pieper.code.between import STEPS, held_words
from pieper.code.export import Export
from pieper.code.labels import Manner
from pieper.code.language import ENTRYWISE, USUAL, Language, filled, functions
from pieper.code.matlab_many import IK_MANY, INSIDE, MOVE, ROWS
from pieper.code.program import LoopWords
from pieper.tolerances import CLOSES, FILLED_STARTS, HOLDS_TO_ROUNDING


class Matlab(Language):
    """MATLAB's matrices are one list whose rows end with a semicolon."""

    def numbers(self, value: Any) -> str:
        """Return numbers as a row or a matrix."""
        inner = super().numbers(value)
        return inner if not inner.startswith("[[") else "[" + inner[2:-2].replace("], [", "; ...\n    ") + "]"


def _loop(loop: LoopWords) -> list[str]:
    return [
        *(f"  {name} = {start};" for name, start in zip(loop.names, loop.start, strict=True)),
        f"  for step = 1:{loop.steps}",
        *(f"  {line}" for line in loop.lines),
        *(f"    {name} = {text};" for name, text in zip(loop.names, loop.next, strict=True)),
        f"    if ~any({loop.moving}), break; end",
        "  end",
    ]


MATLAB = Matlab(
    words=USUAL
    | ENTRYWISE
    | functions("")
    | {"sqrt": "real_sqrt({0})", "angle": "angle_of({0}, {1})", "select": "pick({0}, {1}, {2})", "ne": "{0} ~= {1}"}
    | {"mul": "{0} .* {1}", "div": "{0} ./ {1}"},
    entry=lambda k: f"T(:, {k + 1})",
    assign=lambda name, _, expression: f"  {name} = {expression};",
    loop=_loop,
    infinity="Inf",
    truths=("0", "1"),
    header=lambda lines: "\n".join(f"% {line}" for line in lines),
    manner=Manner("sin({0})", "cos({0})", "q({0})", 1, "  {0} = {1};", "side({0}, {1})"),
    texts="{}'",
)


#: What a matrix means as a pose; the same in every file that asks.
RIGID = """function T = rigid(T)
  % a rotation that was rounded becomes the nearest one
  R = T(1:3, 1:3);
  off = max(max(max(abs(R' * R - eye(3)))), sum(abs(T(4, :) - [0 0 0 1])));
  if ~all(isfinite(T(:))) || ~(off <= @ACCEPTED@) || det(R) < 0
    error('T is no rigid motion: R^T R departs from I by %g, or R is a mirror; allowed is @ACCEPTED@.', off);
  end
  for k = 1:2, R = 1.5 * R - 0.5 * R * (R' * R); end
  T = [R, T(1:3, 4); 0 0 0 1];
end
"""
#: Of arms with filled joints: a row becomes the joint vector whose pose comes nearest to what was asked.
NEAREST = """
function [q, miss] = nearest(q, T)
  % least squares: the joint vector whose pose comes nearest to T; by how much it misses
  tested = @TESTED@;
  weights = @WEIGHTS@';
  for step = 0:@STEPS@
    [P, J] = NAME_fk(q@AS_AXES@);
    r = (T - P)';
    r = weights .* r(tested)';
    miss = norm(r);
    if step == @STEPS@ || (step > 0 && max(abs(move)) < @SETTLED@), break; end
    D = zeros(numel(tested), numel(q));
    for j = 1:numel(q)
      way = [cross(repmat(J(4:6, j), 1, 3), P(1:3, 1:3)), J(1:3, j); 0 0 0 0]';
      D(:, j) = weights .* way(tested)';
    end
@FIXED@    move = (pinv(D) * r)';
    q = q + move;
  end
  turns = ~logical(@JOINTS_SLIDE@);
  q(turns) = q(turns) - 2 * pi * ceil((q(turns) - pi) / (2 * pi));
end
"""
#: Of axes that a linkage moves: rows (m, axes) become joint vectors.
LINKED = """
function [q, kept] = linked(v)
  % the joint vectors that put the joints' own axes at v; which have the linkage put the others there too, nearly
  gears = GEARS;
  back = BACK;
  slides = logical(SLIDES);
  q = v * back';
  off = abs(v - q * gears');
  turned = abs(off - 2 * pi * round(off / (2 * pi)));
  off(:, ~slides) = turned(:, ~slides);
  kept = all(bsxfun(@lt, off, STARTS), 2);
end
"""
IK_ALL = """function [q, unclear] = NAME_ik_all(T@VALUE@)
% NAME_IK_ALL  Rows (m, N) of a pose before limits, and whether the pose is unclear: at and next to singular poses a row
% may stand for many and rows may be missing.@SAID@
%
@HEADER@
  T = rigid(T);
@MOVED@  [rows, valid, unclear] = NAME_rows(reshape(T', 1, 16));
  rows = reshape(rows, 6, 8)';
  slides = logical(@JOINTS_SLIDE@);
  q = zeros(0, N);
  for m = 1:8
    if ~valid(m), continue; end
@OWN_ROW@    gap = abs(bsxfun(@minus, q, own));
    turned = abs(gap - 2 * pi * round(gap / (2 * pi)));
    gap(:, ~slides) = turned(:, ~slides);
    if any(all(gap < 1e-9, 2)), continue; end
    if @DOUBT@
      away = abs(NAME_fk(own@AS_AXES@) - @POSE@)';
      if any(away(@TESTED@) >= @VERIFIED@), continue; end
    end
    q(end + 1, :) = own;
  end
@FROM_AXES@end

@RIGID@@LINKED@@NEAREST@"""

IK = """function q = NAME_ik(T@VALUE@)
% NAME_IK  Every joint vector (m, N) inside the limits that reaches a pose T (4, 4), base to tool; m and rad. A rotation
% that was rounded is taken as the nearest one; what is no rigid motion is an error.@SAID@
%
@HEADER@
  q = NAME_ik_all(T@VALUE@);
  [q, inside] = NAME_inside(q);
  q = q(inside, :);
end
"""

FK = """function [T, J] = NAME_fk(q@IN_AXES@)
% NAME_FK  The pose T (4, 4) of joint vector q, base to tool, and its Jacobian J (6, N), base frame, linear rows first.
%
@HEADER@
  links = @LINKS@;
  slides = logical(@SLIDES@);
@TO_AXES@  T = link(links, 1);
  z = zeros(3, AXES);
  p = zeros(3, AXES);
  for i = 1:AXES
    z(:, i) = T(1:3, 3);
    p(:, i) = T(1:3, 4);
    c = cos(q(i));
    s = sin(q(i));
    if slides(i)
      Z = [1 0 0 0; 0 1 0 0; 0 0 1 q(i); 0 0 0 1];
    else
      Z = [c -s 0 0; s c 0 0; 0 0 1 0; 0 0 0 1];
    end
    T = T * Z * link(links, i + 1);
  end
  J = zeros(6, AXES);
  for i = 1:AXES
    if slides(i)
      J(1:3, i) = z(:, i);
    else
      J(:, i) = [cross(z(:, i), T(1:3, 4) - p(:, i)); z(:, i)];
    end
  end
@GEARED@end

function L = link(links, i)
  L = [reshape(links(i, :), 4, 3)'; 0 0 0 1];
end
"""

LABEL = """function name = NAME_label(q)
% NAME_LABEL  The name of a posture q, such as 'front, elbow up, wrist flip'; '' where the postures of this arm have
% none.
%
@HEADER@
  names = @NAMES@;
@LABEL_AXES@@SUMS@
  name = names{1 + @PLACE@};
end

function k = side(v, facing)
  % 0 where v is positive, 1 where it is negative, 2 where it has no side; seen by somebody who faces that way
  if facing < 0, v = -v; end
  if v > @NO_SIDE@, k = 0; elseif v < -@NO_SIDE@, k = 1; else, k = 2; end
end
"""

SELF_TEST = """function failed = NAME_self_test()
% NAME_SELF_TEST  How many of @TESTS@ stored poses fail: 0.
%
@HEADER@
  Q = @TEST_Q@;
  T = @TEST_T@;
  counts = @COUNTS@;
  slides = logical(@SLIDES@);
  failed = 0;
  for i = 1:size(Q, 1)
    pose = reshape(T(i, :), 4, 4)';
    rows = NAME_ik(pose@TEST_VALUE@);
    gap = abs(bsxfun(@minus, rows, Q(i, :))@GEARED_T@);
    turned = abs(gap - 2 * pi * round(gap / (2 * pi)));
    gap(:, ~slides) = turned(:, ~slides);
    met = any(all(gap < 1e-7, 2));
    ok = all(all(abs(NAME_fk(Q(i, :)) - rigid(pose)) < @VERIFIED@));
    failed = failed + ~(ok && met && size(rows, 1) == counts(i));
  end
end

@RIGID@"""

ENTRY = """function s = STEM()
% The functions of this arm as one struct: s.ik(T), s.ik_all(T), s.ik_many(T), s.fk(q), s.label(q), s.self_test(); they
% stand beside this file.
%
@HEADER@
  s = struct('ik', @NAME_ik, 'ik_all', @NAME_ik_all, 'ik_many', @NAME_ik_many, 'fk', @NAME_fk, 'label', @NAME_label, ...
             'self_test', @NAME_self_test);
end
"""


def _own_parts(export: Export) -> dict[str, str]:
    """Return what is said of what lies between the arm's joints and the six that are solved."""
    own, numbers = export.between, MATLAB.numbers
    held, coupled, tied = own.held is not None, own.gears is not None, own.tied is not None
    gears, back = ("", "") if own.gears is None or own.back is None else (numbers(own.gears), numbers(own.back))
    columns = ", ".join(own.axes(lambda column: f"rows(m, {column + 1})"))
    # rows of a linkage are joint vectors at once, others become some when all of them are known
    as_axes = ", true" if coupled and not own.linked else ""
    slides = MATLAB.listed(MATLAB.truths[int(s)] for s in export.joints_slide)
    zero = "".join(
        f"    if abs(rows(m, {k + 1})) >= {FILLED_STARTS * unit!r}, continue; end\n" for k, unit in own.filled
    )
    wrap = "  q(:, ~slides) = q(:, ~slides) - 2 * pi * ceil((q(:, ~slides) - pi) / (2 * pi));\n" if own.wraps else ""
    return {
        "SAID": f"\n% value: where joint {own.held + 1} is held, rad or m; it has one to spare."
        if own.held is not None
        else f"\n% {held_words(own).rstrip()}" * bool(own.fixed),
        "VALUE": ", value" if held else "",
        "POSE": "given" if held else "T",
        "MOVED": _moved(export),
        "MOVED_MANY": _moved_many(export),
        "OWN_ROWS": _own_rows(export),
        "OWN_ROW": f"{zero}    own = [{columns}];\n"
        + ("    [own, kept] = linked(own);\n    if ~kept, continue; end\n" if own.linked else "")
        + (f"    [own, miss] = nearest(own, T);\n    if ~(miss < {CLOSES!r}), continue; end\n" if own.weights else ""),
        "NEAREST": NEAREST.replace("@TESTED@", str([k + 1 for k in own.tested]))
        .replace("@WEIGHTS@", str(list(own.weights)))
        .replace("@AS_AXES@", as_axes)
        .replace("@STEPS@", str(STEPS))
        .replace("@SETTLED@", repr(HOLDS_TO_ROUNDING))
        .replace("@JOINTS_SLIDE@", slides)
        .replace("@FIXED@", f"    D(:, {[j + 1 for j in own.fixed]}) = 0;\n" if own.fixed else "")
        if own.weights
        else "",
        "LINKED": LINKED.replace("GEARS", gears)
        .replace("BACK", back)
        .replace("STARTS", str(list(own.starts)))
        .replace("SLIDES", MATLAB.listed(MATLAB.truths[int(s)] for s in export.slides))
        if own.linked
        else "",
        "JOINTS_SLIDE": slides,
        "AT_AXES": f" * ({gears})'" if own.linked else "",
        "DOUBT": "true" if own.always else "unclear",
        "TESTED": "[" + " ".join(str(k + 1) for k in own.tested) + "]",
        "IN_AXES": ", in_axes" if as_axes else "",
        "AS_AXES": as_axes,
        "TO_AXES": (
            f"  gears = {gears};\n  "
            + ("if nargin < 2, q = (gears * q(:))'; end\n" if as_axes else "q = (gears * q(:))';\n")
        )
        if coupled
        else "",
        "GEARED": ("  if nargin < 2, J = J * gears; end\n" if as_axes else "  J = J * gears;\n") if coupled else "",
        "FROM_AXES": wrap if own.linked else f"  back = {back};\n  q = q * back';\n{wrap}" if coupled else "",
        "LABEL_AXES": f"  gears = {gears};\n  q = (gears * q(:))';\n" if coupled else "",
        "GEARED_T": f" * ({gears})'" if coupled else "",
        "TEST_VALUE": f", Q(i, {own.held + 1})" if own.held is not None else "",
        "ALONE": f" & ~logical({[int(t) for t in own.tied]})" if own.tied is not None else "",
        "TIED": "  q = move_inside(q, lower, upper);\n" if tied else "",
        "MOVE": MOVE.replace("TIED", str([int(t) for t in own.tied]))
        .replace("WEIGHT", numbers(own.weight))
        .replace("MOVES", numbers(own.moves))
        if own.tied is not None
        else "",
    }


def _own_rows(export: Export) -> str:
    """Return the lines that make joint vectors of a row of many poses."""
    own = export.between
    columns = ", ".join(
        text if text.startswith(("six", "value")) else f"repmat({text}, k, 1)"
        for text in own.axes(lambda column: f"six(:, {column + 1}, m)")
    )
    zero = "".join(
        f"    valid(:, m) = valid(:, m) & abs(six(:, {k + 1}, m)) < {FILLED_STARTS * unit!r};\n"
        for k, unit in own.filled
    )
    nearest = (
        "    for i = find(valid(:, m))'\n"
        "      [own(i, :), miss] = nearest(own(i, :), reshape(T(i, :), 4, 4)');\n"
        f"      valid(i, m) = miss < {CLOSES!r};\n    end\n"
    )
    linked = "    [own, kept] = linked(own);\n    valid(:, m) = valid(:, m) & kept;\n" if own.linked else ""
    own_rows = f"{zero}    own = [{columns}];\n    own(~valid(:, m), :) = 0;\n{linked}"
    return own_rows + (nearest if own.weights else "")


def _moved_many(export: Export) -> str:
    """Return the lines that take the held joint off many poses."""
    own = export.between
    if own.held is None or own.taken_off is None:
        return ""
    value = "  Z(:, 12) = -value;\n"
    turned = "  Z(:, [1 6]) = repmat(cos(value), 1, 2);\n  Z(:, 2) = sin(value);\n  Z(:, 5) = -Z(:, 2);\n"
    product = "times_all(Z, times_all(off, given))" if own.at_base else "times_all(times_all(given, off), Z)"
    return (
        "  value = value(:) + zeros(k, 1);\n  given = T;\n"
        f"  off = {MATLAB.numbers(own.taken_off.ravel())};\n"
        "  Z = zeros(k, 16);\n  Z(:, [1 6 11 16]) = 1;\n"
        f"{value if export.slides[own.held] else turned}  T = {product};\n"
    )


def _moved(export: Export) -> str:
    """Return the lines that take the held joint off a pose."""
    own = export.between
    if own.taken_off is None or own.held is None:
        return ""
    Z = (
        "[1 0 0 0; 0 1 0 0; 0 0 1 -value; 0 0 0 1]"
        if export.slides[own.held]
        else "[cos(value) sin(value) 0 0; -sin(value) cos(value) 0 0; 0 0 1 0; 0 0 0 1]"
    )
    product = f"{Z} * (off * given)" if own.at_base else f"(given * off) * {Z}"
    return f"  given = T;\n  off = {MATLAB.numbers(own.taken_off)};\n  T = {product};\n"


def texts(export: Export, path: Path) -> dict[Path, str]:
    """Return the files' texts: into a folder, or beside a .m file, which then hands out the functions."""
    parts = MATLAB.parts(export) | _own_parts(export)
    file = path.suffix == ".m"
    folder = path.parent if file else path
    frames = {
        "ik": IK,
        "ik_all": IK_ALL,
        "ik_many": IK_MANY,
        "rows": ROWS,
        "inside": INSIDE,
        "fk": FK,
        "label": LABEL,
        "self_test": SELF_TEST,
    }
    frames = {what: frame.replace("@RIGID@", RIGID) for what, frame in frames.items()}
    out = {
        folder / f"{export.name}_{what}.m": filled(frame.replace("@RIGID@", RIGID), parts, export)
        for what, frame in frames.items()
    }
    if file and path not in out:
        out[path] = filled(ENTRY.replace("STEM", path.stem), parts, export)
    return out
