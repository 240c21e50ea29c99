"""A database behind a URL, through Optuna: what is asked of it is answered in time, or refused.

All calls are made in one thread of their own: whoever waits for a database that does not answer can
be told so, whatever its driver does.
"""

import queue
import re
import threading
from collections.abc import Callable
from concurrent.futures import Future
from pathlib import Path
from typing import TYPE_CHECKING, Any
from urllib.parse import unquote

from arcless.errors import ArclessError, OutputError, StorageError, StudyError

if TYPE_CHECKING:
    import optuna

# A server that runs lets one in within milliseconds; a user is told within 10 s that none does.
# What it is asked then may take its time: other programs, or a machine with much else to do.
CONNECTS_WITHIN_S, ANSWERS_WITHIN_S = 5.0, 60.0
# As SQLAlchemy reads it: a password begins at the first colon and ends at the first @.
_USER = re.compile(r"(://[^:/@]*):([^@]*)(?=@)")
_SECRET = re.compile(r"([?&]\w*(?:password|passwd|pwd|secret|token)\w*)=([^&]*)", re.IGNORECASE)


def hidden(url: str) -> str:
    """Return a URL without its password."""
    return _SECRET.sub(r"\1=***", _USER.sub(r"\1:***", url))


def secrets(url: str) -> set[str]:
    """Return the passwords in a URL, as they are written there and as they are meant."""
    found = {match.group(2) for which in (_USER, _SECRET) for match in which.finditer(url)}
    return {word for secret in found for word in (secret, unquote(secret)) if word}


class Database:
    """A database that Optuna keeps its trials in.

    Parameters
    ----------
    url
        As SQLAlchemy takes it.

    Raises
    ------
    StudyError
        The URL names no database, its driver is not installed, or its tables are of another Optuna.
    OutputError
        Its file cannot be written.
    StorageError
        It does not answer.
    """

    def __init__(self, url: str, file: Path | None = None) -> None:
        self._url, self._file = url, file
        self.shown = hidden(url) if file is None else str(file)
        self._asked: queue.SimpleQueue[tuple[Future[Any], Callable[[], Any]] | None] = (
            queue.SimpleQueue()
        )
        self._storage: optuna.storages.RDBStorage | None = None
        threading.Thread(target=self._answer, daemon=True).start()
        try:
            self._import()
            self._wait(self._connect, CONNECTS_WITHIN_S)
            self._storage = self._wait(self._open)
        except BaseException:
            self.close()
            raise

    @classmethod
    def file(cls, path: Path) -> "Database":
        """Open an SQLite file, whatever its path is made of."""
        return cls("sqlite://", path)

    def call(self, what: Callable[..., Any], *given: Any) -> Any:
        """Return what a function of the storage returns.

        Raises
        ------
        OutputError, StorageError
            As when it was opened.
        """
        return self._wait(lambda: what(self._storage, *given))

    def close(self) -> None:
        """Let go of it, without waiting."""
        self._asked.put(None)

    @staticmethod
    def _import() -> None:
        """Import what is slow to import: that is no fault of the database."""
        import alembic.command
        import optuna
        import optuna.storages._rdb.models
        import sqlalchemy.orm

        _ = alembic.command, sqlalchemy.orm
        optuna.logging.set_verbosity(optuna.logging.ERROR)

    def _connect(self) -> None:
        import sqlalchemy

        engine = sqlalchemy.create_engine(self._url, **self._options())
        engine.connect().close()
        engine.dispose()

    def _open(self) -> "optuna.storages.RDBStorage":
        import optuna

        url = self._url.replace("{", "{{").replace("}", "}}")  # Optuna takes it for a template
        return optuna.storages.RDBStorage(url, engine_kwargs=self._options())

    def _options(self) -> dict[str, Any]:
        if self._file is None:
            return {}
        import sqlite3

        return {"creator": lambda: sqlite3.connect(str(self._file))}

    def _wait(self, what: Callable[[], Any], within_s: float | None = None) -> Any:
        answer: Future[Any] = Future()
        self._asked.put((answer, what))
        try:
            return answer.result(within_s or ANSWERS_WITHIN_S)
        except TimeoutError:
            silence = f"nothing for {within_s or ANSWERS_WITHIN_S:g} s"
            raise self._gone("the database of the study does not answer", silence) from None
        except ArclessError:
            raise
        except Exception as error:
            raise self._told(error) from None

    def _answer(self) -> None:
        while (asked := self._asked.get()) is not None:
            future, what = asked
            try:
                future.set_result(what())
            except BaseException as error:  # raised again by who waits
                future.set_exception(error)
        if self._storage is not None:
            self._storage.remove_session()
            self._storage.engine.dispose()

    def _told(self, error: Exception) -> ArclessError:
        """Return an error of Optuna or SQLAlchemy in a sentence; raise what is none of theirs."""
        from sqlalchemy.exc import SQLAlchemyError

        cause = _cause(error)
        if self._storage is None:
            wrong = self._not_opened(cause)
            if wrong is not None:
                return wrong
        if not isinstance(error, SQLAlchemyError) and cause is error:
            raise error
        return self._broken(cause)

    def _not_opened(self, cause: BaseException) -> ArclessError | None:
        """Return what is wrong with a URL, or with what it names; None where neither is."""
        from sqlalchemy.exc import ArgumentError, NoSuchModuleError

        if isinstance(cause, ImportError):
            return StudyError(
                "the storage needs a package that is not installed",
                where=self.shown, got=self._words(cause),
                expected="the driver that the URL asks for",
                hint="pip install it: psycopg[binary] for postgresql+psycopg://, PyMySQL for"
                " mysql+pymysql://",
            )  # fmt: skip
        if isinstance(cause, ArgumentError | NoSuchModuleError | KeyError | ValueError):
            return StudyError(
                "the storage is no database that can be opened",
                where=self.shown, got=self._words(cause),
                expected="a URL such as postgresql+psycopg://user@host/database",
            )  # fmt: skip
        if isinstance(cause, RuntimeError):
            return StudyError(
                "the storage was made by another Optuna",
                where=self.shown, got=self._words(cause),
                hint="`optuna storage upgrade --storage URL`, or another database",
            )  # fmt: skip
        return None

    def _broken(self, cause: BaseException) -> ArclessError:
        if self._url.startswith("sqlite"):
            return OutputError(
                "the storage of the study cannot be written",
                where=self.shown,
                got=self._words(cause),
                expected="an SQLite file that can be written, with room on its disk",
                hint="make room, or delete it if it is damaged, then `arcless study resume`: it is"
                " made again from the journal",
            )
        return self._gone("the database of the study cannot be used", self._words(cause))

    def _gone(self, what: str, got: str) -> StorageError:
        return StorageError(
            what,
            where=self.shown,
            got=got,
            expected=f"one that lets us in within {CONNECTS_WITHIN_S:g} s, and answers",
            hint="start it, then `arcless study run`, or `resume`: no row that came is lost",
        )

    def _words(self, error: BaseException) -> str:
        """Return the first line of a message, without the password."""
        text = str(error).strip().partition("\n")[0][:300] or type(error).__name__
        for secret in secrets(self._url):
            text = text.replace(secret, "***")
        return text


def _cause(error: BaseException) -> BaseException:
    """Return what is behind an error: what the driver said."""
    while True:
        behind = getattr(error, "orig", None) or error.__cause__
        if behind is None or behind is error:
            return error
        error = behind
