"""The arithmetics in which a formula can be evaluated: numpy arrays, many digits, sympy.

All three mean the same by every function. A root or an arc of a number that has none is NaN (that branch is not real);
an arc's argument that rounding pushed past 1 is taken as 1. `sgn` is a branch's choice and never zero, `sign` is.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import numpy.typing as npt

from pieper.tolerances import DOUBLE_ROOT_APART, DOUBLE_ROOT_VANISHES, LEADING_NONE, REAL_ROOT, SINE_SETTLED


class NumpyField:
    """Double precision, over arrays of any shape."""

    pi = np.pi
    undefined = np.nan  # a quotient of plain numbers by zero
    cos, sin, tan, atan, abs, sign = np.cos, np.sin, np.tan, np.arctan, np.abs, np.sign
    atan2, hypot, mod, fmod = np.arctan2, np.hypot, np.mod, np.fmod

    @staticmethod
    def rational(value: Fraction) -> Any:
        """The nearest double."""
        return np.float64(value.numerator / value.denominator)

    @staticmethod
    def power(x: Any, y: Any) -> Any:
        """x^y, of whole numbers as of others."""
        return np.asarray(x, dtype=float) ** y

    @staticmethod
    def sqrt(x: Any) -> Any:
        """Square root."""
        with np.errstate(invalid="ignore"):
            return np.sqrt(x)

    @staticmethod
    def acos(x: Any) -> Any:
        """Arc cosine."""
        with np.errstate(invalid="ignore"):
            return np.arccos(_settled(x))

    @staticmethod
    def asin(x: Any) -> Any:
        """Arc sine."""
        with np.errstate(invalid="ignore"):
            return np.arcsin(_settled(x))

    @staticmethod
    def sgn(x: Any) -> Any:
        """-1 for negative numbers, else 1."""
        return np.where(np.asarray(x) < 0, -1.0, 1.0)

    @staticmethod
    def quartic(*arguments: Any) -> np.ndarray:
        """2 atan(t) for the k-th smallest real root t of e4 t^4 + .. + e0; NaN when there are fewer."""
        *coefficients, number = np.broadcast_arrays(*arguments)
        flat = np.array([c.ravel() for c in coefficients]).T
        found = np.full(number.size, np.nan)
        for place, (row, k) in enumerate(zip(flat, number.ravel(), strict=True)):
            if not np.all(np.isfinite(row)) or not row.any():
                continue
            real = _real_roots(row)
            if len(real) >= k:
                found[place] = 2 * np.arctan(real[int(k) - 1])
        return found.reshape(number.shape)


def _real_roots(coefficients: np.ndarray) -> np.ndarray:
    """Return the real roots of a polynomial, ascending, after two steps of Newton's method on all of them.

    Two that meet may come out as a pair beside the axis: they are real where the polynomial vanishes there to its last
    digit. Or they come out apart, each with half its digits, and their middle has them all. Where leading coefficients
    vanish the roots are infinite, the angle half a turn.
    """
    leading = int(np.argmax(np.abs(coefficients) > LEADING_NONE * np.abs(coefficients).max()))
    coefficients = coefficients[leading:]
    roots: npt.NDArray[np.complex128] = np.asarray(np.roots(coefficients), complex)
    slope, size = np.polyder(coefficients), np.abs(coefficients)
    with np.errstate(all="ignore"):
        for _ in range(2):
            moved = roots - np.polyval(coefficients, roots) / np.polyval(slope, roots)
            roots = np.where(np.isfinite(moved) & (np.abs(moved - roots) < 1 + np.abs(roots)), moved, roots)
    off, far = np.abs(roots.imag), 1 + np.abs(roots)

    def vanishes(x: np.ndarray) -> np.ndarray:
        return np.abs(np.polyval(coefficients, x)) < DOUBLE_ROOT_VANISHES * np.polyval(size, np.abs(x))

    real = (off < REAL_ROOT * far) | ((off < DOUBLE_ROOT_APART * far) & vanishes(roots.real))
    found = np.sort(roots[real].real)
    apart = np.diff(found)
    middle = _level((found[1:] + found[:-1]) / 2, slope)
    for k in np.flatnonzero((apart < DOUBLE_ROOT_APART * (1 + np.abs(middle))) & vanishes(middle)):
        found[k : k + 2] = middle[k]
    return np.concatenate([found, np.full(leading, np.inf)])


def _level(middle: np.ndarray, slope: np.ndarray) -> np.ndarray:
    """Return where the slope vanishes near the middle of two roots, by Newton's method; the middle if nowhere."""
    bend, at = np.polyder(slope), middle
    with np.errstate(all="ignore"):
        for _ in range(3):
            at = at - np.polyval(slope, at) / np.polyval(bend, at)
    return np.where(np.abs(at - middle) < DOUBLE_ROOT_APART * (1 + np.abs(middle)), at, middle)


def _settled(x: Any) -> Any:
    x = np.asarray(x, dtype=float)
    size = np.abs(x)
    return np.where((size > 1) & (size < 1 + SINE_SETTLED), np.sign(x), x)


class DigitsField:
    """Many-digit arithmetic by mpmath; the number of digits is that of the enclosing `mpmath.workdps`."""

    def __init__(self) -> None:
        import mpmath

        self._mp = mpmath.mp
        self.undefined = mpmath.mp.nan
        self.cos, self.sin, self.tan, self.atan = mpmath.cos, mpmath.sin, mpmath.tan, mpmath.atan
        self.hypot, self.abs, self.sign = mpmath.hypot, mpmath.fabs, mpmath.sign

    @property
    def pi(self) -> Any:
        """Pi to the digits that are in force."""
        return +self._mp.pi

    def rational(self, value: Fraction) -> Any:
        """The number."""
        return self._mp.mpf(value.numerator) / value.denominator

    def power(self, x: Any, y: Any) -> Any:
        """x^y; NaN for a fractional power of a negative number, and for a negative one of zero."""
        if self._mp.isint(y):
            return x ** int(y) if x or y >= 0 else self._mp.nan
        return x**y if x > 0 or (x == 0 and y > 0) else self._mp.nan

    def sqrt(self, x: Any) -> Any:
        """Square root."""
        return self._mp.sqrt(x) if x >= 0 else self._mp.nan

    def acos(self, x: Any) -> Any:
        """Arc cosine."""
        return self._arc(self._mp.acos, x)

    def asin(self, x: Any) -> Any:
        """Arc sine."""
        return self._arc(self._mp.asin, x)

    def _arc(self, function: Any, x: Any) -> Any:
        beyond = abs(x) - 1
        if beyond > 0:
            x = self._mp.sign(x) if beyond < self._mp.mpf(10) ** (5 - self._mp.dps) else self._mp.nan
        return function(x)

    def atan2(self, y: Any, x: Any) -> Any:
        """Angle of the point (x, y)."""
        return self._mp.nan if y != y or x != x else self._mp.atan2(y, x)

    def mod(self, x: Any, y: Any) -> Any:
        """The remainder with the divisor's sign."""
        return x - y * self._mp.floor(x / y) if y else self._mp.nan

    def fmod(self, x: Any, y: Any) -> Any:
        """The remainder with the dividend's sign."""
        return x - y * self._mp.sign(x / y) * self._mp.floor(abs(x / y)) if y else self._mp.nan

    def sgn(self, x: Any) -> Any:
        """-1 for negative numbers, else 1."""
        return self._mp.mpf(-1 if x < 0 else 1)

    def quartic(self, *arguments: Any) -> Any:
        """See `NumpyField.quartic`."""
        *coefficients, number = arguments
        if any(c != c for c in coefficients):
            return self._mp.nan
        roots = self._mp.polyroots(coefficients, maxsteps=200, extraprec=200)
        real = sorted(r.real for r in roots if abs(r.imag) < self._mp.mpf(10) ** (-self._mp.dps // 2) * (1 + abs(r)))
        return 2 * self._mp.atan(real[int(number) - 1]) if len(real) >= number else self._mp.nan


class SympyField:
    """Exact symbols; each named quantity becomes a real sympy symbol of the same name."""

    def __init__(self) -> None:
        import sympy

        self.sympy: Any = sympy
        self.pi: Any = sympy.pi
        self.undefined: Any = sympy.nan
        for name in ("cos", "sin", "tan", "sqrt", "acos", "asin", "atan", "atan2", "sign"):
            setattr(self, name, getattr(sympy, name))
        self.sgn, self.abs = sympy.sign, sympy.Abs

    def hypot(self, x: Any, y: Any) -> Any:
        """Length of (x, y)."""
        return self.sympy.sqrt(x**2 + y**2)

    def power(self, x: Any, y: Any) -> Any:
        """x^y."""
        return x**y

    def mod(self, x: Any, y: Any) -> Any:
        """The remainder with the divisor's sign."""
        return self.sympy.Mod(x, y)

    def fmod(self, x: Any, y: Any) -> Any:
        """The remainder with the dividend's sign."""
        return x - y * self.sympy.sign(x / y) * self.sympy.floor(self.sympy.Abs(x / y))

    def quartic(self, *arguments: Any) -> Any:
        """2 atan(t) with t as a named root; sympy has no closed form that is useful here."""
        return 2 * self.sympy.atan(self.sympy.Function("quartic_root")(*arguments))

    def rational(self, value: Fraction) -> Any:
        """The exact number."""
        return self.sympy.Rational(value.numerator, value.denominator)

    class _Symbols(dict):
        """A mapping that makes a sympy symbol for every name it is asked for, but never stands in for c1 or s23."""

        def __missing__(self, symbol: Any) -> Any:
            import sympy

            return sympy.Symbol(symbol if isinstance(symbol, str) else symbol.name, real=True)

        def __contains__(self, symbol: Any) -> bool:
            return False

    symbols = _Symbols()
