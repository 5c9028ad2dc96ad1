"""The commands of docker-compose.yml, run here for want of a Docker engine."""

from __future__ import annotations

import signal
import subprocess
import sys
from pathlib import Path

import httpx
import psycopg
import yaml
from tests.cli.command import Lanewright, eventually

SERVICES = yaml.safe_load((Path(__file__).resolve().parents[2] / "docker-compose.yml").read_text())["services"]


def test_every_command_does_its_work(command: Lanewright, template_url: str):
    """In the order of Compose, on an empty database of somebody else's server, as there."""
    name = f"compose_{command.port}"
    with psycopg.connect(template_url.replace("/lanewright?", "/postgres?"), autocommit=True) as admin:
        admin.execute(f"CREATE DATABASE {name} TEMPLATE template0")
        try:
            _run_the_services(command, template_url.replace("/lanewright?", f"/{name}?"))
        finally:
            admin.execute(f"DROP DATABASE {name} WITH (FORCE)")


def _run_the_services(command: Lanewright, url: str) -> None:
    environment = {
        "DATABASE_URL": url,
        "LANEWRIGHT_LOG_FORMAT": SERVICES["api"]["environment"]["LANEWRIGHT_LOG_FORMAT"],
    }
    for service in ("api", "worker"):
        assert command.run(*_health(service), **environment).returncode == 2, f"{service} is not there yet"
    migrated = command.run(*SERVICES["migrate"]["command"], **environment)
    assert migrated.returncode == 0, migrated.stderr
    running = [_start(command, service, environment) for service in ("api", "worker")]
    try:
        for service in ("api", "worker"):
            eventually(
                lambda service=service: command.run(*_health(service), **environment).returncode == 0,
                f"the health check of {service} passes",
            )
        assert httpx.get(f"http://127.0.0.1:{command.port}/healthz").is_success
    finally:
        for process in running:
            process.send_signal(signal.SIGTERM)  # what Compose sends
        outputs = [process.communicate(timeout=60) for process in running]
    assert [process.returncode for process in running] == [0, 0], outputs
    assert not (command.home / "cluster").exists()


def _health(service: str) -> list[str]:
    return list(SERVICES[service]["healthcheck"]["test"][2:])  # after CMD and the program


def _start(command: Lanewright, service: str, environment: dict[str, str]) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-m", "lanewright.cli.main", *SERVICES[service]["command"]],
        env=command.environment | environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
