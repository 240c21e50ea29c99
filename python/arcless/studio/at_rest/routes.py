"""The route of lines at rest, and the processes behind it."""

from asyncio import CancelledError
from collections import OrderedDict
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any

from anyio.to_thread import run_sync
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import BaseRoute

from arcless.studio.answers.answers import Refused, json_body, route
from arcless.studio.at_rest.question import question_of
from arcless.studio.at_rest.worker import Desk
from arcless.studio.project.project import Project

# Pages that have processes at once. With more, pages that nobody looks at keep two processes of
# 100 MB each; with one, two pages side by side start processes again and again, a second each time.
MOST_DESKS = 3
# Letters of a page's name for itself. It only tells pages apart; a longer one is cut.
NAME_LENGTH = 64


class Desks:
    """Processes by the page that asks; the page that rested longest makes room for a new one."""

    def __init__(self) -> None:
        self._by_page: OrderedDict[str, Desk] = OrderedDict()

    def of(self, page: str) -> Desk:
        """Return the processes of a page, by its name for itself."""
        name = page[:NAME_LENGTH]
        desk = self._by_page.pop(name, None) or Desk()
        self._by_page[name] = desk
        while len(self._by_page) > MOST_DESKS:
            self._by_page.popitem(last=False)[1].close()
        return desk

    @asynccontextmanager
    async def at_work(self) -> AsyncIterator[None]:
        """Be there while the server is; end all processes with it."""
        yield
        for desk in self._by_page.values():
            desk.close()


def routes(project: Project, desks: Desks) -> list[BaseRoute]:
    """Return the route that answers questions about lines at rest."""

    async def at_rest(request: Request) -> Any:
        asked = await json_body(request)
        question = await run_sync(question_of, project, asked)
        try:
            content = await desks.of(str(asked.get("page", ""))).ask(question)
        except CancelledError:  # the server ends while a line is computed
            raise Refused(503, "The server ends") from None
        return Response(content, media_type="application/json")

    return [route("statics", at_rest, "POST")]
