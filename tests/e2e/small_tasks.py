"""Tasks on logs whose maps are given: imported by command, assigned to the annotator by the admin."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, expect
from tests.e2e.conftest import LiveServer, sign_in
from tests.services.log_folder import write_log


def tasks_on(
    server: LiveServer, chromium: Browser, folder: Path, prefix: str, maps: Mapping[str, dict[str, Any]]
) -> dict[str, int]:
    """A task per map, by its name; ``prefix``: what the names of these logs alone begin with (11 letters)."""
    logs = {name: f"{prefix}{position:02}{'x' * 19}__Spring_2020" for position, name in enumerate(maps)}
    for name, archive in maps.items():
        write_log(folder, logs[name], map_text=json.dumps(archive))
    imported = server.command("import", str(folder), "--split", "test", "--direction", "prior_to_current")
    assert imported.returncode == 0, imported.stdout + imported.stderr
    with chromium.new_context(base_url=server.address) as context:
        page = context.new_page()
        sign_in(page, "admin")
        page.goto(f"/logs?q={prefix}")
        for log_id in logs.values():
            page.get_by_role("checkbox", name=f"Log {log_id}").check()
        page.get_by_role("button", name="Create tasks…").click()
        dialog = page.get_by_role("dialog")
        dialog.get_by_label("Assignee").click()
        page.get_by_role("option", name="annotator").click()
        dialog.get_by_role("button", name="Create").click()
        dialog.wait_for(state="hidden")
        answer = page.request.get("/api/v1/tasks", params={"q": prefix, "page_size": 50})
        expect(answer).to_be_ok()
        numbers = {task["log_id"]: task["id"] for task in answer.json()["items"]}
    return {name: numbers[log_id] for name, log_id in logs.items()}
