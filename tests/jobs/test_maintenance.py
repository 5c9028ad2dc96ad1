"""What the background worker does by itself."""

from __future__ import annotations

import asyncio
import datetime

import psycopg
from sqlalchemy import text
from tests.stored_logs import add_log

from lanewright.core.workflow import Role
from lanewright.db.engine import transaction
from lanewright.db.models import Account
from lanewright.jobs.maintenance import log_differences, purge_sign_ins
from lanewright.jobs.queue import opened_queue
from lanewright.jobs.worker import run_worker
from lanewright.services.sessions import SessionRules, begin

DAY = datetime.timedelta(days=1)
PURGE = "maintenance.purge"


def test_job_of_a_killed_worker_is_done_by_the_next_one(fresh_database: str):
    asyncio.run(_lose_a_job(fresh_database))
    _sign_in(fresh_database, lasting=-DAY)
    assert _count(fresh_database, "procrastinate_jobs WHERE status = 'doing'") == 1
    asyncio.run(run_worker(fresh_database, wait=False))
    assert _count(fresh_database, "procrastinate_jobs WHERE status IN ('doing', 'todo')") == 0
    assert _count(fresh_database, "account_session") == 0


def test_job_of_a_living_worker_is_left_to_it(fresh_database: str):
    asyncio.run(_lose_a_job(fresh_database, silent_s=1))
    asyncio.run(run_worker(fresh_database, wait=False))
    assert _count(fresh_database, "procrastinate_jobs WHERE status = 'doing'") == 1


def test_purge_takes_what_has_run_out_and_nothing_else(fresh_database: str):
    _sign_in(fresh_database, lasting=-DAY)
    _sign_in(fresh_database, lasting=DAY)
    with psycopg.connect(fresh_database) as connection:
        connection.execute(
            "INSERT INTO login_failure (name, address, at) "
            "VALUES ('a', '::1', now()), ('b', '::1', now() - interval '2 days')"
        )
    purge_sign_ins(fresh_database)
    assert _count(fresh_database, "account_session") == 1
    assert _count(fresh_database, "account_session WHERE expires_at > now()") == 1
    assert _count(fresh_database, "login_failure WHERE name = 'a'") == 1
    assert _count(fresh_database, "login_failure") == 1


def test_nightly_verification_logs_what_differs(fresh_database: str):
    with transaction(fresh_database) as session:
        add_log(session)
    assert log_differences(fresh_database) == 0
    with transaction(fresh_database) as session:
        session.execute(text("UPDATE element_version SET sha256 = '\\x00' WHERE element_id = 11"))
    assert log_differences(fresh_database) > 0


async def _lose_a_job(url: str, silent_s: int = 60) -> None:
    """Leaves what a worker leaves that is killed in the middle of a job, and that many seconds pass."""
    async with opened_queue(url) as queue:
        await queue.configure_task(PURGE).defer_async(timestamp=0)
        worker_id = await queue.job_manager.register_worker()
        assert await queue.job_manager.fetch_job(None, worker_id) is not None
    with psycopg.connect(url) as connection:
        connection.execute("UPDATE procrastinate_workers SET last_heartbeat = now() - %s * interval '1 s'", [silent_s])


def _sign_in(url: str, lasting: datetime.timedelta) -> None:
    with transaction(url) as session:
        account = Account(name=f"{lasting}", role=Role.ANNOTATOR.value, password_hash="none")
        session.add(account)
        session.flush()
        begin(session, account, SessionRules(idle=DAY, absolute=lasting, demo_allowed=False))


def _count(url: str, what: str) -> int:
    with psycopg.connect(url) as connection:
        row = connection.execute(f"SELECT count(*) FROM {what}").fetchone()
    assert row is not None
    return int(row[0])
