"""The files of MATLAB and Octave that take many poses at once, with the @WORDS@ that `matlab` fills in."""

from __future__ import annotations

#: The program itself, of as many poses as one likes.
ROWS = """function [rows, valid, unclear] = NAME_rows(T)
% NAME_ROWS  Rows (k, 6, 8) of poses T (k, 16), each written row by row, which of them hold (k, 8), and which poses are
% unclear (k, 1); the six joints are those that are solved. NAME_ik_all and NAME_ik_many make joint vectors of them.
%
@HEADER@
@PROGRAM@
  said = {@ROWS@};
  holds = {@VALID@};
  rows = zeros(size(T, 1), 6, 8);
  valid = false(size(T, 1), 8);
  for m = 1:8
    for j = 1:6, rows(:, j, m) = said{6 * m - 6 + j}; end
    valid(:, m) = holds{m};
  end
  unclear = false(size(T, 1), 1) | @UNCLEAR@;
end

function r = pick(yes, a, b)
  if isscalar(yes)
    if yes, r = a; else, r = b; end
    return
  end
  if isscalar(b), r = repmat(b, size(yes)); else, r = b; end
  if isscalar(a), r(yes) = a; else, r(yes) = a(yes); end
end

function r = real_sqrt(x)
  x(x < 0) = NaN;
  r = sqrt(x);
end

function r = angle_of(y, x)
  % an angle that rounds to -pi is said as pi
  r = atan2(y, x);
  r(r <= -pi) = pi;
end
"""

IK_MANY = """function [q, of, unclear] = NAME_ik_many(T@VALUE@)
% NAME_IK_MANY  Every joint vector q (m, N) inside the limits that reaches one of poses T (4, 4, k), the number of that
% pose (m, 1), and which poses are unclear (k, 1). Poses are solved together, some thousands at once fastest.@SAID@
%
@HEADER@
  T = rigid_all(reshape(permute(T, [2 1 3]), 16, [])');
  k = size(T, 1);
@MOVED_MANY@  [six, valid, unclear] = NAME_rows(T);
  slides = logical(@JOINTS_SLIDE@);
  rows = zeros(k, N, 8);
  for m = 1:8
@OWN_ROWS@    for j = 1:m - 1
      gap = abs(own - rows(:, :, j));
      turned = abs(gap - 2 * pi * round(gap / (2 * pi)));
      gap(:, ~slides) = turned(:, ~slides);
      valid(:, m) = valid(:, m) & ~(valid(:, j) & all(gap < 1e-9, 2));
    end
    look = valid(:, m) & @DOUBT@;
    if any(look)
      away = abs(walked(own(look, :)@AT_AXES@) - @POSE@(look, :));
      valid(look, m) = all(away(:, @TESTED@) < @VERIFIED@, 2);
    end
    rows(:, :, m) = own;
  end
  [m, of] = find(valid');
  q = zeros(numel(of), N);
  for j = 1:N, q(:, j) = rows(of + k * (j - 1) + k * N * (m - 1)); end
  of = of(:);
@FROM_AXES@  [q, inside] = NAME_inside(q);
  q = q(inside, :);
  of = of(inside);
end

function T = rigid_all(T)
  % rotations that were rounded become the nearest ones
  c = {T(:, [1 5 9]), T(:, [2 6 10]), T(:, [3 7 11])};
  off = sum(abs(bsxfun(@minus, T(:, 13:16), [0 0 0 1])), 2);
  for i = 1:3
    for j = 1:3, off = max(off, abs(sum(c{i} .* c{j}, 2) - (i == j))); end
  end
  turn = sum(c{1} .* cross(c{2}, c{3}, 2), 2);
  bad = find(~all(isfinite(T), 2) | ~(off <= @ACCEPTED@) | ~(turn > 0), 1);
  if ~isempty(bad)
    error('T(:, :, %d) is no rigid motion: R^T R departs from I by more than @ACCEPTED@, or R is a mirror.', bad);
  end
  for step = 1:2
    d = c;
    for j = 1:3
      c{j} = 1.5 * d{j};
      for i = 1:3, c{j} = c{j} - bsxfun(@times, d{i}, 0.5 * sum(d{i} .* d{j}, 2)); end
    end
  end
  T(:, [1 5 9]) = c{1};
  T(:, [2 6 10]) = c{2};
  T(:, [3 7 11]) = c{3};
  T(:, 13:16) = repmat([0 0 0 1], size(T, 1), 1);
end

function T = walked(q)
  % the tool's poses (k, 16) where the axes are at q
  links = [@LINKS@, repmat([0 0 0 1], AXES1, 1)];
  slides = logical(@SLIDES@);
  T = links(1, :);
  for i = 1:AXES
    Z = zeros(size(q, 1), 16);
    Z(:, [1 6 11 16]) = 1;
    if slides(i)
      Z(:, 12) = q(:, i);
    else
      Z(:, [1 6]) = repmat(cos(q(:, i)), 1, 2);
      Z(:, 5) = sin(q(:, i));
      Z(:, 2) = -Z(:, 5);
    end
    T = times_all(times_all(T, Z), links(i + 1, :));
  end
end

function C = times_all(A, B)
  C = zeros(max(size(A, 1), size(B, 1)), 16);
  for i = 0:4:12
    for j = 1:4
      for n = 1:4, C(:, i + j) = C(:, i + j) + A(:, i + n) .* B(:, 4 * n - 4 + j); end
    end
  end
end
@LINKED@@NEAREST@"""

INSIDE = """function [q, inside] = NAME_inside(q)
% NAME_INSIDE  Joint vectors q (m, N) moved inside the limits by whole turns where that can be, and which lie there.
%
@HEADER@
  lower = @LOWER@;
  upper = @UPPER@;
  alone = ~logical(@JOINTS_SLIDE@)@ALONE@;
  turn = 2 * pi;
@TIED@  inside = true(size(q, 1), 1);
  for j = 1:N
    v = q(:, j);
    if alone(j)
      low = v < lower(j);
      v(low) = v(low) + turn * ceil((lower(j) - v(low)) / turn);
      high = v > upper(j);
      v(high) = v(high) - turn * ceil((v(high) - upper(j)) / turn);
    end
    inside = inside & v >= lower(j) & v <= upper(j);
    q(:, j) = v;
  end
end
@MOVE@"""

MOVE = """
function q = move_inside(q, lower, upper)
  % joints whose numbers whole turns of the axes move together: the shortest move that brings them inside
  free = ~logical(TIED);
  moves = MOVES;
  within = @(v) all(bsxfun(@or, free, bsxfun(@ge, v, lower) & bsxfun(@le, v, upper)), 2);
  least = Inf(size(q, 1), 1);
  least(within(q)) = 0;
  now = q;
  for k = 1:size(moves, 1)
    there = bsxfun(@plus, now, moves(k, :));
    away = sum(WEIGHT .* moves(k, :) .^ 2);
    better = away < least & within(there);
    least(better) = away;
    q(better, :) = there(better, :);
  end
end
"""
