"""Trying remedies before they are offered: a fix removes its violation and adds none (spec §6.2)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from lanewright.core.comparison import Comparison
from lanewright.core.edits import Edit, edits_between
from lanewright.core.rules.rule import Remedy, Rule
from lanewright.core.violations import Fix, Violation

_MOST_TRIALS = 24
_MOST_WORK = 6_000
"""Elements that differ from the base, and violations found, over all trials: what trials cost by."""
Findings = Callable[[Comparison], tuple[Violation, ...]]


@dataclass(frozen=True, slots=True)
class _Verdict:
    """A remedy, the ids of the violations that are left after it, and whether any of these is new."""

    remedy: Remedy
    left: frozenset[str]
    adds: bool
    edits: tuple[Edit, ...]


class FixTrial:
    """Fixes for the violations of one comparison; each remedied map is judged once, however many it mends."""

    def __init__(
        self, comparison: Comparison, found: tuple[Violation, ...], rules: Mapping[str, Rule], findings: Findings
    ):
        self._comparison = comparison
        self._rules = rules
        self._findings = findings
        self._known = {violation.id for violation in found if not violation.inherited}
        self._judged: dict[int, _Verdict] = {}
        self._edits: dict[int, tuple[Edit, ...]] = {}
        self._remedies: list[Remedy] = []
        """Kept, so that no other remedy can have the identity of one that was looked at."""
        self._trials = 0
        self._work = 0

    def of(self, violation: Violation) -> tuple[Fix, ...]:
        """The first remedy that removes the violation and adds none; failing that, the first that removes it.

        In a map with very many violations the first remedy is offered untried: trying all would take too long.
        """
        second: tuple[Fix, ...] = ()
        for remedy in self._rules[violation.code].remedies(self._comparison, violation):
            if self._exhausted and id(remedy) not in self._judged:
                return second or (self._fix(remedy, self._edits_of(remedy)),)
            verdict = self._judge(remedy)
            if violation.id in verdict.left:
                continue
            fix = self._fix(verdict.remedy, verdict.edits)
            if not verdict.adds:
                return (fix,)
            second = second or (fix,)
        return second

    def _fix(self, remedy: Remedy, edits: tuple[Edit, ...]) -> Fix:
        declared = self._comparison.claims.declared
        if remedy.claims is None or remedy.claims.declared == declared:
            return Fix(remedy.title, edits)
        return Fix(remedy.title, edits, remedy.claims.declared)

    def _added(self, left: tuple[Violation, ...]) -> list[Violation]:
        return [violation for violation in left if not violation.inherited and violation.id not in self._known]

    def _judge(self, remedy: Remedy) -> _Verdict:
        """The remedy, completed where it lays bare another defect, and what is left after it."""
        if id(remedy) not in self._judged:
            completed, left = self._completed(remedy, self._left_after(remedy))
            edits = self._edits_of(completed)
            ids = frozenset(violation.id for violation in left)
            self._judged[id(remedy)] = _Verdict(completed, ids, bool(self._added(left)), edits)
            self._remedies.append(remedy)
        return self._judged[id(remedy)]

    def _edits_of(self, remedy: Remedy) -> tuple[Edit, ...]:
        """What a remedy changes, worked out once."""
        if id(remedy) not in self._edits:
            self._edits[id(remedy)] = edits_between(self._comparison.edited, remedy.edited)
            self._remedies.append(remedy)
        return self._edits[id(remedy)]

    @property
    def _exhausted(self) -> bool:
        return self._trials >= _MOST_TRIALS or self._work >= _MOST_WORK

    def _left_after(self, remedy: Remedy) -> tuple[Violation, ...]:
        comparison = self._after(remedy)
        left = self._findings(comparison)
        self._trials += 1
        self._work += len(comparison.apart) + len(left)
        return left

    def _after(self, remedy: Remedy) -> Comparison:
        return Comparison(self._comparison.uncut_base, remedy.edited, remedy.claims or self._comparison.claims)

    def _completed(self, remedy: Remedy, left: tuple[Violation, ...]) -> tuple[Remedy, tuple[Violation, ...]]:
        """A remedy together with those of what it lays bare, as far as each leaves less to do than before."""
        while (added := self._added(left)) and not self._exhausted:
            comparison = self._after(remedy)
            for further in (one for bare in added for one in self._rules[bare.code].remedies(comparison, bare)):
                if further.claims is not None:
                    continue  # what somebody says of it is not changed along with their map
                if self._exhausted:
                    break
                after = self._left_after(further)
                if len(self._added(after)) < len(added):
                    remedy, left = Remedy(f"{remedy.title}; {further.title.lower()}", further.edited), after
                    break
            else:
                break
        return remedy, left
