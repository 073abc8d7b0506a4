"""One claim of a claims file: its keys read with messages that name it, and the three verdicts it can get."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any, TypedDict, Unpack

from pieper.errors import InputError
from pieper.judge.verdict import HOLDS, PARTLY, WRONG, Verdict

Details = Iterable[tuple[str, str]]


class Numbers(TypedDict, total=False):
    """What a verdict says in numbers, see `Verdict`."""

    digits: int | None
    right: int
    tried: int
    difference: str


@dataclass(frozen=True, eq=False)
class Claim:
    """One claim on its way to a verdict.

    Attributes:
        id: its name in the file.
        keys: everything the file says of it.
        text: the claim as it reads, set by its judge with `reads`.
    """

    id: str
    keys: Mapping[str, Any]
    text: str = ""

    @property
    def says(self) -> str:
        """What the claim is about, in the file's words."""
        return self.keys.get("says", "")

    @property
    def where(self) -> dict[str, Any]:
        """Definitions that belong to this claim alone."""
        return self.keys.get("where") or {}

    def __getitem__(self, key: str) -> Any:
        return self.keys[key]

    def __contains__(self, key: str) -> bool:
        return key in self.keys

    def get(self, key: str, default: Any = None) -> Any:
        """The value of a key, `default` where the file has none."""
        return self.keys.get(key, default)

    def part(self, name: str, keys: Mapping[str, Any]) -> Claim:
        """A claim of its own made of one row, step or entry of this one."""
        return Claim(name, keys)

    def reads(self, text: str) -> Claim:
        """The same claim with its text."""
        return replace(self, text=text)

    def error(self, message: str, key: str = "") -> InputError:
        """The error for a claim that cannot be judged as it stands; `key` is where the cause stands."""
        return InputError(f"claim {self.id}: {message}", claim=self.id, **({"key": key} if key else {}))

    def joint(self, n: int) -> int:
        """The joint (1-based) that the claim names, of an arm with n."""
        joint = self.keys["joint"]
        if not isinstance(joint, int) or not 1 <= joint <= n:
            raise self.error(f"joint {joint!r} does not exist; the arm has joints 1 to {n}", "joint")
        return joint

    def whole(self, key: str) -> int:
        """The whole number under a key."""
        value = self.keys.get(key)
        if not isinstance(value, int):
            raise self.error(f"{key} must be a whole number", key)
        return value

    def holds(self, sentence: str, details: Details = (), **numbers: Unpack[Numbers]) -> Verdict:
        """The claim holds."""
        return self._verdict(HOLDS, sentence, details, "", "", numbers)

    def partly(
        self, sentence: str, details: Details = (), slip: str = "", reading: str = "", **numbers: Unpack[Numbers]
    ) -> Verdict:
        """The claim holds only in part."""
        return self._verdict(PARTLY, sentence, details, slip, reading, numbers)

    def wrong(
        self, sentence: str, details: Details = (), slip: str = "", reading: str = "", **numbers: Unpack[Numbers]
    ) -> Verdict:
        """The claim is wrong."""
        return self._verdict(WRONG, sentence, details, slip, reading, numbers)

    def _verdict(
        self, status: str, sentence: str, details: Details, slip: str, reading: str, numbers: Numbers
    ) -> Verdict:
        return Verdict(self.id, self.text, status, sentence, self.says, tuple(details), slip, reading, **numbers)
