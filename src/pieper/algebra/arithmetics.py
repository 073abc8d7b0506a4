"""The arithmetics in which a formula can be evaluated: numpy arrays, many digits, sympy."""

from __future__ import annotations

import numpy as np


class NumpyField:
    """Double precision, over arrays of any shape; a negative square root is NaN (that branch is not real)."""

    pi = np.pi

    @staticmethod
    def rational(value):
        return value.numerator / value.denominator

    cos, sin, abs = np.cos, np.sin, np.abs
    atan2 = staticmethod(np.arctan2)

    @staticmethod
    def sqrt(x):
        with np.errstate(invalid="ignore"):
            return np.sqrt(x)

    @staticmethod
    def acos(x):
        with np.errstate(invalid="ignore"):
            return np.arccos(x)

    @staticmethod
    def asin(x):
        with np.errstate(invalid="ignore"):
            return np.arcsin(x)

    @staticmethod
    def sign(x):
        return np.where(np.asarray(x) < 0, -1.0, 1.0)

    @staticmethod
    def quartic(*arguments):
        """2 atan(t) for the k-th smallest real root t of e4 t^4 + .. + e0; NaN when there are fewer."""
        *coefficients, number = np.broadcast_arrays(*arguments)
        flat = np.array([c.ravel() for c in coefficients]).T
        found = np.full(number.size, np.nan)
        for place, (row, k) in enumerate(zip(flat, number.ravel(), strict=True)):
            if not np.all(np.isfinite(row)) or not row.any():
                continue
            roots = np.roots(row)
            slope = np.polyder(row)
            for _ in range(2):
                roots = roots - np.polyval(row, roots) / np.polyval(slope, roots)
            real = np.sort(roots[np.abs(roots.imag) < 1e-7 * (1 + np.abs(roots))].real)
            if len(real) >= k:
                found[place] = 2 * np.arctan(real[int(k) - 1])
        return found.reshape(number.shape)


class DigitsField:
    """Many-digit arithmetic by mpmath; the number of digits is that of the enclosing `mpmath.workdps`."""

    def __init__(self):
        import mpmath

        self._mp = mpmath.mp
        self.cos, self.sin, self.acos, self.asin, self.abs = (
            mpmath.cos,
            mpmath.sin,
            mpmath.acos,
            mpmath.asin,
            mpmath.fabs,
        )

    @property
    def pi(self):
        return +self._mp.pi

    def rational(self, value):
        return self._mp.mpf(value.numerator) / value.denominator

    def sqrt(self, x):
        return self._mp.sqrt(x) if x >= 0 else self._mp.nan

    def atan2(self, y, x):
        return self._mp.nan if y != y or x != x else self._mp.atan2(y, x)

    def sign(self, x):
        return self._mp.mpf(-1 if x < 0 else 1)

    def quartic(self, *arguments):
        *coefficients, number = arguments
        if any(c != c for c in coefficients):
            return self._mp.nan
        roots = self._mp.polyroots(coefficients, maxsteps=200, extraprec=200)
        real = sorted(r.real for r in roots if abs(r.imag) < self._mp.mpf(10) ** (-self._mp.dps // 2) * (1 + abs(r)))
        return 2 * self._mp.atan(real[int(number) - 1]) if len(real) >= number else self._mp.nan


class SympyField:
    """Exact symbols; each named quantity becomes a real sympy symbol of the same name."""

    def __init__(self):
        import sympy

        self._sympy = sympy
        self.pi = sympy.pi
        self.cos, self.sin, self.sqrt, self.acos, self.asin, self.atan2, self.sign, self.abs = (
            sympy.cos,
            sympy.sin,
            sympy.sqrt,
            sympy.acos,
            sympy.asin,
            sympy.atan2,
            sympy.sign,
            sympy.Abs,
        )

    def quartic(self, *arguments):
        """2 atan(t) with t as a named root; sympy has no closed form that is useful here."""
        root = self._sympy.Function("quartic_root")(*arguments)
        return 2 * self._sympy.atan(root)

    def rational(self, value):
        return self._sympy.Rational(value.numerator, value.denominator)

    class _Symbols(dict):
        """A mapping that makes a sympy symbol for every name it is asked for, but never stands in for c1 or s23."""

        def __missing__(self, symbol):
            import sympy

            return sympy.Symbol(symbol.name, real=True)

        def __contains__(self, symbol):
            return False

    symbols = _Symbols()
