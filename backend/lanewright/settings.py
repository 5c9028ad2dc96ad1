"""Everything that can be set from outside, in one place: environment variables with the prefix ``LANEWRIGHT_``."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from urllib.parse import urlsplit

from pydantic import AliasChoices, Field, ValidationError, field_validator
from pydantic_settings import BaseSettings, SettingsConfigDict

from lanewright.core.errors import LanewrightError

REPOSITORY = Path(__file__).resolve().parents[2]
"""Root of the checkout: migrations/ and frontend/ lie there (the package is always installed from it, editable)."""

LOOPBACK_HOSTS = ("127.0.0.1", "::1", "localhost")


class Settings(BaseSettings):
    """Settings of one process; times in seconds, sizes in bytes.

    Attributes:
        home: folder of everything Lanewright keeps (cluster, rasters, logs, backups).
        database_url: a PostGIS database to use; None: the private cluster under ``home``.
        public_url: address that people use, when a proxy stands in front; https makes cookies secure.
        session_idle_s, session_absolute_s: a sign-in ends after this long without a request, or at all.
        body_limit_bytes: largest request body that is read.
        log_format: "console" for people, "json" for collectors.
    """

    model_config = SettingsConfigDict(env_prefix="LANEWRIGHT_", extra="ignore", frozen=True)

    home: Path = REPOSITORY / ".lanewright"
    database_url: str | None = Field(
        default=None, validation_alias=AliasChoices("DATABASE_URL", "LANEWRIGHT_DATABASE_URL", "database_url")
    )
    host: str = "127.0.0.1"
    port: int = Field(default=8000, ge=0, le=65535)
    public_url: str | None = None
    session_idle_s: int = Field(default=12 * 3600, gt=0)
    session_absolute_s: int = Field(default=7 * 24 * 3600, gt=0)
    body_limit_bytes: int = Field(default=32 * 1024 * 1024, gt=0)
    frontend: Path = REPOSITORY / "frontend" / "dist"
    log_format: str = Field(default="console", pattern="^(console|json)$")

    @field_validator("home", "frontend")
    @classmethod
    def _absolute(cls, folder: Path) -> Path:
        return folder.expanduser().absolute()

    @field_validator("database_url")
    @classmethod
    def _postgres(cls, url: str | None) -> str | None:
        if not url:  # an empty variable is how Compose files and shells say "not set"
            return None
        scheme, separator, rest = url.partition("://")
        if not separator or scheme not in ("postgresql", "postgres", "postgresql+psycopg"):
            raise ValueError("must begin with postgresql://")
        return f"postgresql://{rest}"

    @field_validator("public_url")
    @classmethod
    def _web_address(cls, url: str | None) -> str | None:
        if not url:
            return None
        parts = urlsplit(url)
        if parts.scheme not in ("http", "https") or not parts.hostname:
            raise ValueError("must be an http:// or https:// address")
        return url.rstrip("/")

    @property
    def secure_cookies(self) -> bool:
        """Whether cookies are for TLS only."""
        return (self.public_url or "").startswith("https://")

    @property
    def demo_allowed(self) -> bool:
        """Demo sign-ins exist only where nobody else can reach them: loopback bind, private cluster, no proxy."""
        return self.host in LOOPBACK_HOSTS and self.database_url is None and self.public_url is None


class InvalidSettings(LanewrightError):
    """An environment variable holds what it cannot hold."""

    code = "settings.invalid"


@lru_cache(maxsize=1)
def get_settings() -> Settings:
    """The settings of this process.

    Raises:
        InvalidSettings: names the variable and what is wrong with it.
    """
    try:
        return Settings()
    except ValidationError as error:
        first = error.errors()[0]
        name = str(first["loc"][0]) if first["loc"] else "a setting"
        variable = name if name.isupper() else f"LANEWRIGHT_{name.upper()}"
        raise InvalidSettings(
            f"{variable}: {first['msg']}.", mend="Correct or unset this environment variable."
        ) from error
