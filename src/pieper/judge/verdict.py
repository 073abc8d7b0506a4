"""A verdict on one claim and a judgement of many, with their forms for people and machines."""

from __future__ import annotations

import html
import json
from dataclasses import asdict, dataclass

from pieper.words_by_number import plural

HOLDS, PARTLY, WRONG = "holds", "holds only in part", "wrong"
_MARK = {HOLDS: "holds", PARTLY: "PARTLY", WRONG: "WRONG"}


@dataclass(frozen=True)
class Verdict:
    """What the judge says of one claim.

    Attributes:
        id: the claim's name in its file.
        claim: the claim as it reads.
        says: what the claim is about, in the file's words.
        status: "holds", "holds only in part" or "wrong".
        sentence: the verdict in one sentence, with its number.
        details: further lines, (heading, text): counter-example, difference, nearest right reading, slip, what was
            tried.
        slip: the kind of the one slip that explains a wrong claim, "" when there is none.
        reading: the nearest right reading as a formula, "" when none was found.
        digits: number of digits to which the claim holds, None where that means nothing.
        right, tried: at how many of how many joint vectors a formula was right, 0 of 0 where that means nothing.
        difference: printed minus right as a formula, "" when there is none or it takes too long to find.
    """

    id: str
    claim: str
    status: str
    sentence: str
    says: str = ""
    details: tuple[tuple[str, str], ...] = ()
    slip: str = ""
    reading: str = ""
    digits: int | None = None
    right: int = 0
    tried: int = 0
    difference: str = ""

    @property
    def about(self) -> str:
        """What the claim is about; a remark in brackets stands behind the claim itself."""
        return f"{self.claim} {self.says}" if self.says.startswith("(") else self.says or self.claim

    @property
    def holds(self) -> bool:
        """Say whether the claim holds without reserve."""
        return self.status == HOLDS

    @property
    def partly(self) -> bool:
        """Say whether the claim holds only in part."""
        return self.status == PARTLY

    @property
    def wrong(self) -> bool:
        """Say whether the claim is wrong."""
        return self.status == WRONG


@dataclass(frozen=True)
class Judgement:
    """The verdicts of one claims file, in its order.

    Attributes:
        title: title of the file.
        source: where the claims come from.
        arms: what each arm is, in words.
        verdicts: one `Verdict` per claim.
        notes: the file's own remarks.
    """

    title: str
    source: str
    arms: tuple[str, ...]
    verdicts: tuple[Verdict, ...]
    notes: str = ""

    @property
    def ok(self) -> bool:
        """Say whether every claim holds."""
        return all(v.holds for v in self.verdicts)

    def counts(self) -> dict[str, int]:
        """Count the verdicts by status."""
        return {s: sum(v.status == s for v in self.verdicts) for s in (HOLDS, PARTLY, WRONG)}

    def __getitem__(self, claim_id: str) -> Verdict:
        for verdict in self.verdicts:
            if verdict.id == claim_id:
                return verdict
        raise KeyError(f"no claim is called {claim_id!r}; there are {', '.join(v.id for v in self.verdicts)}")

    def summary(self) -> str:
        """Return the count of verdicts as a sentence."""
        verbs = {
            HOLDS: ("holds", "hold"),
            PARTLY: ("holds only in part", "hold only in part"),
            WRONG: ("is wrong", "are wrong"),
        }
        told = (plural(count, *verbs[status]) for status, count in self.counts().items())
        return f"{plural(len(self.verdicts), 'claim')}: {', '.join(told)}."

    def text(self) -> str:
        """Return the judgement as plain text."""
        lines = [
            self.title,
            "=" * len(self.title),
            *([self.source] if self.source else []),
            *self.arms,
            "",
            self.summary(),
            "",
        ]
        for v in self.verdicts:
            lines.append(f"[{_MARK[v.status]}] {v.id}: {v.about}")
            if v.says:
                lines.append(f"    claim: {v.claim}")
            lines.append(f"    {v.sentence}")
            lines += [f"    {head}: {_indent(body)}" for head, body in v.details]
            lines.append("")
        return "\n".join(lines)

    def markdown(self) -> str:
        """Return the judgement as Markdown, a table of verdicts first and every claim after it."""
        lines = [f"# {self.title}", ""]
        lines += [self.source, ""] if self.source else []
        lines += [f"- {a}" for a in self.arms] + [""]
        lines += [self.notes, ""] if self.notes else []
        lines += [f"**{self.summary()}**", "", "| claim | what | verdict |", "|---|---|---|"]
        lines += [
            f"| {v.id} | {_cell(v.about)} | {v.status if v.holds else '**' + v.status + '**'} |" for v in self.verdicts
        ]
        for v in self.verdicts:
            lines += ["", f"## {v.id}" + (f": {v.says}" if v.says else ""), ""]
            lines += ["```text", v.claim, "```", "", f"**{v.status}.** {v.sentence}", ""]
            for head, body in v.details:
                lines += [
                    f"- {head}: `{body}`" if "\n" not in body and _is_formula(head) else f"- {head}: {_block(body)}"
                ]
        return "\n".join(lines).rstrip() + "\n"

    def html(self) -> str:
        """Return the judgement as an HTML fragment."""
        e = html.escape
        rows = "".join(
            f'<tr class="{v.status.split()[0]}"><td>{e(v.id)}</td><td>{e(v.about)}</td><td>{e(v.status)}</td></tr>'
            for v in self.verdicts
        )
        parts = [
            f"<section class='judged'><h2>{e(self.title)}</h2><p>{e(self.source)}</p><p>{e(self.summary())}</p>",
            f"<table><thead><tr><th>claim</th><th>what</th><th>verdict</th></tr></thead><tbody>{rows}</tbody></table>",
        ]
        for v in self.verdicts:
            details = "".join(f"<dt>{e(h)}</dt><dd><pre>{e(b)}</pre></dd>" for h, b in v.details)
            parts.append(
                f"<article class='{v.status.split()[0]}'><h3>{e(v.id)} {e(v.says)}</h3><pre>{e(v.claim)}</pre>"
                f"<p><b>{e(v.status)}.</b> {e(v.sentence)}</p><dl>{details}</dl></article>"
            )
        return "".join(parts) + "</section>"

    def json(self) -> str:
        """Return the judgement as JSON."""
        return json.dumps(
            {
                "title": self.title,
                "source": self.source,
                "arms": list(self.arms),
                "ok": self.ok,
                "counts": self.counts(),
                "verdicts": [{**asdict(v), "details": [list(d) for d in v.details]} for v in self.verdicts],
            },
            indent=1,
        )


def _is_formula(head: str) -> bool:
    return head in ("nearest right reading", "difference")


def _indent(body: str) -> str:
    return body.replace("\n", "\n        ")


def _cell(text: str) -> str:
    text = text.replace("|", "\\|").replace("\n", " ")
    return text if len(text) <= 110 else text[:107] + "..."


def _block(body: str) -> str:
    return body if "\n" not in body else "\n\n  ```text\n  " + body.replace("\n", "\n  ") + "\n  ```"
