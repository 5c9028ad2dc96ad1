"""A real Lanewright (private cluster, API, worker, built frontend) and a real Chromium for the browser tests."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, Playwright, sync_playwright

LANEWRIGHT = Path(sys.executable).with_name("lanewright")
CHROMIUM_FLAGS = [
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--ignore-gpu-blocklist",
    "--font-render-hinting=none",
    "--force-color-profile=srgb",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
]


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    here = Path(__file__).parent
    for item in items:
        if here in item.path.parents:
            item.add_marker(pytest.mark.browser)


@dataclass(frozen=True)
class LiveServer:
    """A running `lanewright serve` with the demo loaded, in a home of its own."""

    address: str
    home: Path

    def command(self, *words: str) -> subprocess.CompletedProcess[str]:
        """Runs the `lanewright` command beside the server."""
        return subprocess.run(
            [LANEWRIGHT, *words], env=_environment(self.home), capture_output=True, text=True, check=False, timeout=300
        )


def _environment(home: Path) -> dict[str, str]:
    inherited = {name: value for name, value in os.environ.items() if name != "DATABASE_URL"}
    return {**inherited, "LANEWRIGHT_HOME": str(home)}


@pytest.fixture(scope="session")
def server() -> Iterator[LiveServer]:
    """One server for all browser tests; each test works on a task of its own."""
    home = Path(tempfile.mkdtemp(prefix="lanewright-e2e-"))
    home.chmod(0o711)
    with subprocess.Popen(
        [LANEWRIGHT, "serve", "--port", "0"], env=_environment(home), stdout=subprocess.PIPE, text=True
    ) as process:
        try:
            said = []
            for line in process.stdout or ():
                said.append(line)
                if line.startswith("Lanewright runs at "):
                    yield LiveServer(line.split()[3], home)
                    break
            else:
                pytest.fail(f"The server did not start: {''.join(said)}", pytrace=False)
        finally:
            process.terminate()
            process.wait(60)
            shutil.rmtree(home, ignore_errors=True)


@pytest.fixture(scope="module")
def playwright() -> Iterator[Playwright]:
    """Not for the whole run: its event loop would be in the way of tests that start one of their own."""
    with sync_playwright() as running:
        yield running


@pytest.fixture(scope="module")
def chromium(playwright: Playwright) -> Iterator[Browser]:
    """Debian's Chromium with a software GPU, the same pixels everywhere."""
    with playwright.chromium.launch(executable_path=chromium_path(), args=CHROMIUM_FLAGS) as browser:
        yield browser


def chromium_path() -> str:
    path = shutil.which("chromium")
    if path is None:
        pytest.fail("Browser tests need Chromium: `make test` installs it, or apt-get install chromium.", pytrace=False)
    return path


@pytest.fixture
def page_for(server: LiveServer, chromium: Browser) -> Iterator[Callable[[str], Page]]:
    """`page_for("annotator")`: a fresh browser profile, signed in through the form as that demo person."""
    contexts: list[BrowserContext] = []

    def open_page(name: str) -> Page:
        context = chromium.new_context(base_url=server.address, viewport={"width": 1024, "height": 768})
        contexts.append(context)
        page = context.new_page()
        sign_in(page, name)
        return page

    yield open_page
    for context in contexts:
        context.close()


def sign_in(page: Page, name: str, password: str = "lanewright-demo") -> None:
    """Signs in through the form."""
    page.goto("/")
    page.get_by_label("Name").fill(name)
    page.get_by_label("Password", exact=True).fill(password)
    page.get_by_role("button", name="Sign in").click()
    page.get_by_role("navigation").wait_for()


def sign_in_again(page: Page, name: str) -> None:
    """Signs in unless the profile still holds the session: a killed browser may not have written its cookies."""
    page.goto("/")
    form = page.get_by_role("button", name="Sign in", exact=True)
    form.or_(page.get_by_role("navigation")).first.wait_for()
    if form.is_visible():
        sign_in(page, name)
