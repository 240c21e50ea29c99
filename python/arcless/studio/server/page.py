"""The page: files that `make page` built, and nothing else of the disk."""

from pathlib import Path

from starlette.routing import BaseRoute, Mount
from starlette.staticfiles import StaticFiles

from arcless.errors import OutputError

FOLDER = Path(__file__).resolve().parent.parent / "page"


def check_built() -> None:
    """Refuse to serve a page that was not built.

    Raises
    ------
    OutputError
        There is none.
    """
    if not (FOLDER / "index.html").is_file():
        raise OutputError("the page of the studio is not built", hint="`make page` builds it")


def routes() -> list[BaseRoute]:
    """Return the route of the page's files; it comes after all others."""
    return [Mount("/", StaticFiles(directory=FOLDER, html=True))]
