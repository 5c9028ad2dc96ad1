"""Every rule has its page, and the pages are those of the sources."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from lanewright.core.rules import RULES

ROOT = Path(__file__).resolve().parents[2]


def test_pages_are_those_of_the_rules():
    command = [sys.executable, "scripts/rules_pages.py", "--check"]
    checked = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert checked.returncode == 0, checked.stdout + checked.stderr


def test_each_rule_has_one_name_for_its_code_file_page_and_test():
    for rule in RULES:
        name = rule.code.replace(".", "_")
        assert (ROOT / "backend/lanewright/core/rules" / f"{name}.py").exists()
        assert (ROOT / "tests/core/rules" / f"test_{name}.py").exists()
        assert (ROOT / "docs/rules" / f"{rule.code}.md").exists()
