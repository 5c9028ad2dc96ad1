"""Trying remedies before they are offered: a fix removes its violation and adds none (spec §6.2)."""

from __future__ import annotations

from collections.abc import Callable

from lanewright.core.comparison import Comparison
from lanewright.core.edits import Edit, edits_between
from lanewright.core.rules.rule import Remedy, Rule
from lanewright.core.violations import Fix, Violation

_MOST_TRIALS = 24
Findings = Callable[[Comparison], tuple[Violation, ...]]


class FixTrial:
    """Fixes for the violations of one comparison; each remedied map is judged once, however many it mends."""

    def __init__(self, comparison: Comparison, found: tuple[Violation, ...], findings: Findings):
        self._comparison = comparison
        self._findings = findings
        self._known = {violation.id for violation in found if not violation.inherited}
        self._judged: dict[int, tuple[Remedy, frozenset[str], bool, tuple[Edit, ...]]] = {}

    def of(self, violation: Violation, rule: Rule) -> tuple[Fix, ...]:
        """The first remedy that removes the violation and adds none; failing that, the first that removes it.

        In a map with very many violations the first remedy is offered untried: trying all would take too long.
        """
        second: tuple[Fix, ...] = ()
        for remedy in rule.remedies(self._comparison, violation):
            if len(self._judged) >= _MOST_TRIALS and id(remedy) not in self._judged:
                return second or (Fix(remedy.title, edits_between(self._comparison.edited, remedy.edited)),)
            left, adds_none, edits = self._judge(remedy)
            if violation.id in left:
                continue
            fix = Fix(remedy.title, edits)
            if adds_none:
                return (fix,)
            second = second or (fix,)
        return second

    def _judge(self, remedy: Remedy) -> tuple[frozenset[str], bool, tuple[Edit, ...]]:
        """What is left after the remedy, whether all of that was there before, and the remedy as edits."""
        if id(remedy) not in self._judged:
            comparison = self._comparison
            left = self._findings(Comparison(comparison.base, remedy.edited, comparison.claims))
            adds_none = all(violation.inherited or violation.id in self._known for violation in left)
            # The remedy is kept beside its verdict, so that no other can have its identity.
            self._judged[id(remedy)] = (
                remedy,
                frozenset(violation.id for violation in left),
                adds_none,
                edits_between(comparison.edited, remedy.edited),
            )
        return self._judged[id(remedy)][1:]
