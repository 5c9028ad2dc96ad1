"""Engines and transactions. Outside the API's own dependency this is the one place that commits."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from functools import lru_cache
from typing import Any

import orjson
from sqlalchemy import Engine, create_engine
from sqlalchemy.orm import Session, sessionmaker


def _dumps(value: Any) -> str:
    return orjson.dumps(value).decode()


@lru_cache(maxsize=8)
def engine_for(url: str) -> Engine:
    """The process's engine for a database URL (psycopg 3); pooled, with connections tested before use."""
    return create_engine(
        url.replace("postgresql://", "postgresql+psycopg://", 1),
        json_serializer=_dumps,
        json_deserializer=orjson.loads,
        pool_pre_ping=True,
        pool_size=10,
        max_overflow=10,
    )


@contextmanager
def transaction(url: str) -> Iterator[Session]:
    """A session whose work is committed when the block ends well and rolled back when it raises."""
    with sessionmaker(engine_for(url), expire_on_commit=False)() as session, session.begin():
        yield session


@contextmanager
def snapshot(url: str) -> Iterator[Session]:
    """A session that only reads, and sees one state of the database however long the block takes."""
    isolated = engine_for(url).execution_options(isolation_level="REPEATABLE READ", postgresql_readonly=True)
    with isolated.connect() as connection, Session(connection, expire_on_commit=False) as session:
        yield session
