"""The printer of MATLAB and Octave: a file a function, as these languages want it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from pieper.code.export import Export
from pieper.code.labels import Manner
from pieper.code.language import ENTRYWISE, USUAL, Language, filled, functions


class Matlab(Language):
    """MATLAB's matrices are one list whose rows end with a semicolon."""

    def numbers(self, value: Any) -> str:
        """Return numbers as a row or a matrix."""
        inner = super().numbers(value)
        return inner if not inner.startswith("[[") else "[" + inner[2:-2].replace("], [", "; ...\n    ") + "]"


MATLAB = Matlab(
    words=USUAL
    | ENTRYWISE
    | functions("")
    | {"sqrt": "real_sqrt({0})", "angle": "angle_of({0}, {1})", "select": "pick({0}, {1}, {2})", "ne": "{0} ~= {1}"},
    entry=lambda k: f"T({k // 4 + 1}, {k % 4 + 1})",
    assign=lambda name, _, expression: f"  {name} = {expression};",
    infinity="Inf",
    truths=("0", "1"),
    header=lambda lines: "\n".join(f"% {line}" for line in lines),
    manner=Manner("sin({0})", "cos({0})", "q({0})", 1, "  {0} = {1};", "side({0}, {1})"),
    texts="{}'",
    per_row=("{}", "; "),
)


IK_ALL = """function [q, unclear] = NAME_ik_all(T)
% NAME_IK_ALL  Rows (m, N) of a pose before limits, and whether the pose is unclear: at and next to singular poses a row
% may stand for many and rows may be missing.
%
@HEADER@
@PROGRAM@
  rows = [@ROWS@];
  valid = [@VALID@];
  unclear = @UNCLEAR@;
  slides = logical(@SLIDES@);
  q = zeros(0, N);
  for m = 1:8
    if ~valid(m), continue; end
    gap = abs(bsxfun(@minus, q, rows(m, :)));
    turned = abs(gap - 2 * pi * round(gap / (2 * pi)));
    gap(:, ~slides) = turned(:, ~slides);
    if any(all(gap < 1e-9, 2)), continue; end
    if unclear && any(any(abs(NAME_fk(rows(m, :)) - T) >= @VERIFIED@)), continue; end
    q(end + 1, :) = rows(m, :);
  end
end

function r = pick(yes, a, b)
  if yes, r = a; else, r = b; end
end

function r = real_sqrt(x)
  if x < 0, r = NaN; else, r = sqrt(x); end
end

function r = angle_of(y, x)
  % an angle that rounds to -pi is said as pi
  r = atan2(y, x);
  if r <= -pi, r = pi; end
end
"""

IK = """function q = NAME_ik(T)
% NAME_IK  Every joint vector (m, N) inside the limits that reaches a pose T (4, 4), base to tool; m and rad.
%
@HEADER@
  lower = @LOWER@;
  upper = @UPPER@;
  slides = logical(@SLIDES@);
  q = NAME_ik_all(T);
  turn = 2 * pi;
  inside = true(size(q, 1), 1);
  for j = 1:N
    v = q(:, j);
    if ~slides(j)
      low = v < lower(j);
      v(low) = v(low) + turn * ceil((lower(j) - v(low)) / turn);
      high = v > upper(j);
      v(high) = v(high) - turn * ceil((v(high) - upper(j)) / turn);
    end
    inside = inside & v >= lower(j) & v <= upper(j);
    q(:, j) = v;
  end
  q = q(inside, :);
end
"""

FK = """function [T, J] = NAME_fk(q)
% NAME_FK  The pose T (4, 4) of joint vector q, base to tool, and its Jacobian J (6, N), base frame, linear rows first.
%
@HEADER@
  links = @LINKS@;
  slides = logical(@SLIDES@);
  T = link(links, 1);
  z = zeros(3, N);
  p = zeros(3, N);
  for i = 1:N
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
  J = zeros(6, N);
  for i = 1:N
    if slides(i)
      J(1:3, i) = z(:, i);
    else
      J(:, i) = [cross(z(:, i), T(1:3, 4) - p(:, i)); z(:, i)];
    end
  end
end

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
@SUMS@
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
    rows = NAME_ik(pose);
    gap = abs(bsxfun(@minus, rows, Q(i, :)));
    turned = abs(gap - 2 * pi * round(gap / (2 * pi)));
    gap(:, ~slides) = turned(:, ~slides);
    met = any(all(gap < 1e-7, 2));
    ok = all(all(abs(NAME_fk(Q(i, :)) - pose) < @VERIFIED@));
    failed = failed + ~(ok && met && size(rows, 1) == counts(i));
  end
end
"""

ENTRY = """function s = STEM()
% The functions of this arm as one struct: s.ik(T), s.ik_all(T), s.fk(q), s.label(q), s.self_test(); they stand beside
% this file.
%
@HEADER@
  s = struct('ik', @NAME_ik, 'ik_all', @NAME_ik_all, 'fk', @NAME_fk, 'label', @NAME_label, ...
             'self_test', @NAME_self_test);
end
"""


def texts(export: Export, path: Path) -> dict[Path, str]:
    """Return the files' texts: into a folder, or beside a .m file, which then hands out the functions."""
    parts = MATLAB.parts(export)
    file = path.suffix == ".m"
    folder = path.parent if file else path
    frames = {"ik": IK, "ik_all": IK_ALL, "fk": FK, "label": LABEL, "self_test": SELF_TEST}
    out = {folder / f"{export.name}_{what}.m": filled(frame, parts, export) for what, frame in frames.items()}
    if file and path not in out:
        out[path] = filled(ENTRY.replace("STEM", path.stem), parts, export)
    return out
