"""A Chromium that can be killed like a crashed computer, and started again with the same profile."""

from __future__ import annotations

import contextlib
import os
import signal
from pathlib import Path

from playwright.sync_api import Page, Playwright


class Profile:
    """A browser profile on disk; cookies and IndexedDB in it outlive the browser."""

    def __init__(self, playwright: Playwright, executable: str, flags: list[str], folder: Path, address: str) -> None:
        self._playwright = playwright
        self._executable = executable
        self._flags = flags
        self._folder = folder
        self._address = address

    def start(self) -> Page:
        """A page of a newly started browser."""
        context = self._playwright.chromium.launch_persistent_context(
            self._folder,
            executable_path=self._executable,
            args=self._flags,
            base_url=self._address,
            viewport={"width": 1440, "height": 900},
        )
        return context.pages[0]

    def kill(self) -> None:
        """kill -9 of every process of the browser, in the middle of whatever it does."""
        mark = f"--user-data-dir={self._folder}".encode()
        for process in Path("/proc").glob("[0-9]*"):
            with contextlib.suppress(OSError):
                if mark in (process / "cmdline").read_bytes():
                    os.kill(int(process.name), signal.SIGKILL)
        (self._folder / "SingletonLock").unlink(missing_ok=True)
