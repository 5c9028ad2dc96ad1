"""``lanewright import`` and ``lanewright verify`` as people run them."""

from __future__ import annotations

import json
from pathlib import Path

from tests.cli.command import Lanewright
from tests.services.log_folder import LOG_ID, OTHER_LOG_ID, write_log, write_map


def test_a_log_that_fails_does_not_stop_the_rest(command: Lanewright, tmp_path: Path) -> None:
    logs = tmp_path / "logs"
    good, bad = write_log(logs, LOG_ID), write_log(logs, OTHER_LOG_ID)
    write_map(bad, "{")
    splits = tmp_path / "splits.json"
    splits.write_text(json.dumps({"train": [LOG_ID], "val": [OTHER_LOG_ID]}))
    first = command.run("import", str(logs), str(tmp_path / "nowhere"), "--splits", str(splits))
    assert first.returncode == 1, first.stderr
    assert f"{LOG_ID}: imported. 2 lane segments, 1 crossings" in first.stdout
    assert f"{OTHER_LOG_ID}: failed. log_map_archive_{OTHER_LOG_ID}" in first.stdout
    assert "nowhere: failed" in first.stdout
    assert "1 imported, 0 unchanged, 2 failed." in first.stdout
    assert "Traceback" not in first.stdout + first.stderr
    again = command.run("import", str(good), "--splits", str(splits))
    assert again.returncode == 0
    assert f"{LOG_ID}: unchanged." in again.stdout
    verified = command.run("verify")
    assert (verified.returncode, verified.stdout) == (0, "1 revisions verified: nothing differs.\n")


def test_bad_options_are_told_in_a_sentence(command: Lanewright, tmp_path: Path) -> None:
    broken = tmp_path / "splits.json"
    broken.write_text("[]")
    refused = command.run("import", str(tmp_path), "--splits", str(broken))
    assert refused.returncode == 2
    assert refused.stderr.startswith("lanewright: splits.json")
    unknown = command.run("import", str(tmp_path), "--split", "holdout")
    assert unknown.returncode == 2
