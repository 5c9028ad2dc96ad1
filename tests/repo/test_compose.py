"""The deployment for a team, as far as its files tell (its commands are run in tests/cli)."""

from __future__ import annotations

import re
from pathlib import Path

import yaml

REPOSITORY = Path(__file__).resolve().parents[2]
COMPOSE = yaml.safe_load((REPOSITORY / "docker-compose.yml").read_text())
SERVICES = COMPOSE["services"]
PROGRAM = "/srv/lanewright/.venv/bin/lanewright"
DOCKERFILE = (REPOSITORY / "deploy" / "Dockerfile").read_text()


def test_every_other_service_waits_for_the_migration():
    assert set(SERVICES) == {"db", "migrate", "api", "worker"}
    assert SERVICES["migrate"]["depends_on"] == {"db": {"condition": "service_healthy"}}
    for name in ("api", "worker"):
        assert SERVICES[name]["depends_on"]["migrate"] == {"condition": "service_completed_successfully"}


def test_every_lasting_service_has_a_health_check_and_comes_back():
    for name in set(SERVICES) - {"migrate"}:
        assert SERVICES[name]["healthcheck"]["test"][0] == "CMD", name
        assert SERVICES[name]["restart"] == "unless-stopped", name


def test_images_are_pinned_and_volumes_declared():
    images = [service["image"] for service in SERVICES.values()] + re.findall(r"^FROM (\S+)", DOCKERFILE, re.MULTILINE)
    assert [image for image in images if not re.fullmatch(r"[a-z/]+:\d[\w.-]+", image)] == []
    for service in SERVICES.values():
        for volume in service["volumes"]:
            assert volume.split(":")[0] in COMPOSE["volumes"]


def test_no_secret_has_a_default_and_every_required_variable_is_in_the_example():
    secrets = [
        value
        for service in SERVICES.values()
        for name, value in service["environment"].items()
        if re.search("PASSWORD|SECRET|TOKEN", name)
    ]
    assert secrets
    assert [value for value in secrets if not re.fullmatch(r"\$\{\w+:\?[^}]+\}", value)] == []
    required = set(re.findall(r"\$\{(\w+):\?", (REPOSITORY / "docker-compose.yml").read_text()))
    example = dict(
        line.split("=", 1) for line in (REPOSITORY / ".env.example").read_text().splitlines() if line[:1].isalpha()
    )
    assert example == dict.fromkeys(required, "")


def test_only_the_api_is_published_and_only_on_this_machine():
    published = {name: service["ports"] for name, service in SERVICES.items() if "ports" in service}
    assert list(published) == ["api"]
    assert published["api"] == ["${LANEWRIGHT_BIND:-127.0.0.1}:${LANEWRIGHT_PORT:-8000}:8000"]


def test_image_copies_what_exists_and_runs_the_scripts_of_make():
    for line in re.findall(r"^COPY (.+)", DOCKERFILE, re.MULTILINE):
        for source in line.split()[:-1]:
            assert (REPOSITORY / source).exists(), source
    makefile = (REPOSITORY / "Makefile").read_text()
    steps = re.findall(r"scripts/\w+\.sh \w+", DOCKERFILE)
    assert steps == ["scripts/debian_packages.sh run", "scripts/python_packages.sh run", "scripts/frontend.sh build"]
    assert [step for step in steps if f"@{step}" not in makefile] == []
    assert f'ENTRYPOINT ["{PROGRAM}"]' in DOCKERFILE
    assert re.search(r"^USER lanewright$", DOCKERFILE, re.MULTILINE)
