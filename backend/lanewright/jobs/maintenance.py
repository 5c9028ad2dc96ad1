"""Jobs that nobody asks for: they come back by the clock."""

from __future__ import annotations

import datetime

import structlog
from procrastinate import JobContext
from procrastinate.manager import JobManager

from lanewright.db.engine import transaction
from lanewright.db.repositories import accounts
from lanewright.jobs.queue import queue
from lanewright.services.throttle import MEMORY
from lanewright.services.verify import subjects, verify
from lanewright.settings import get_settings

STALLED_AFTER_S = 30.0
"""A job whose worker gave no sign of life for so long has lost it."""

KEEP_FAILED_JOBS_H = 30 * 24

_log = structlog.get_logger(__name__)


async def retry_stalled_jobs(manager: JobManager) -> int:
    """Puts the jobs of killed workers back into the queue, and says how many there were."""
    stalled = list(await manager.get_stalled_jobs(seconds_since_heartbeat=STALLED_AFTER_S))
    for job in stalled:
        _log.warning("job of a lost worker is retried", job=job.id, task=job.task_name)
        await manager.retry_job(job)
    return len(stalled)


@queue.periodic(cron="* * * * * */10")
@queue.task(name="maintenance.sweep", queueing_lock="maintenance.sweep", pass_context=True)
async def sweep(context: JobContext, timestamp: int) -> None:
    """Procrastinate itself does not retry the jobs of a worker that was killed."""
    await retry_stalled_jobs(context.app.job_manager)


@queue.periodic(cron="17 * * * *")
@queue.task(name="maintenance.purge", queueing_lock="maintenance.purge", pass_context=True)
async def purge(context: JobContext, timestamp: int) -> None:
    """Removes what has run out: browser sessions, counted sign-in failures, old failed jobs."""
    purge_sign_ins(context.additional_context["database_url"])
    await context.app.job_manager.delete_old_jobs(KEEP_FAILED_JOBS_H, include_failed=True, include_aborted=True)


@queue.periodic(cron="41 3 * * *")
@queue.task(name="maintenance.verify", queueing_lock="maintenance.verify", pass_context=True)
def verify_everything(context: JobContext, timestamp: int) -> None:
    """What ``lanewright verify`` does, every night; a difference is an error in the log."""
    log_differences(context.additional_context["database_url"])


def log_differences(url: str) -> int:
    """Logs where the store contradicts itself, and says how often it does."""
    found = 0
    with transaction(url) as session:
        for subject in subjects(session):
            for difference in verify(session, subject):
                _log.error("the store contradicts itself", where=difference.where, what=difference.what)
                found += 1
    _log.info("the store was verified", differences=found)
    return found


def purge_sign_ins(url: str) -> None:
    """Removes expired browser sessions, and failures that no longer count against anybody."""
    now = datetime.datetime.now(datetime.UTC)
    with transaction(url) as session:
        accounts.end_stale_sessions(session, now, datetime.timedelta(seconds=get_settings().session_idle_s))
        accounts.forget_failures(session, before=now - MEMORY)
