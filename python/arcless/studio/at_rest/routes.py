"""The route of lines at rest, and the processes behind it."""

from collections import OrderedDict
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any

from anyio.to_thread import run_sync
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import BaseRoute

from arcless.studio.answers.answers import json_body, route
from arcless.studio.at_rest.question import Question, question_of
from arcless.studio.at_rest.worker import Worker
from arcless.studio.project.project import Project

# Processes at once. A page has one for what follows a slider, and one for natural frequencies,
# which take longer; with more, pages that nobody looks at keep 100 MB each, with fewer, two pages
# side by side start each other's process again and again, a second each time.
MOST_WORKERS = 4
# Letters of a page's name for itself. It only tells pages apart; a longer one is cut.
NAME_LENGTH = 64


class Workers:
    """Processes by the page that asks; the one that rested longest makes room for a new one."""

    def __init__(self) -> None:
        self._by_page: OrderedDict[tuple[str, bool], Worker] = OrderedDict()

    def of(self, page: str, question: Question) -> Worker:
        """Return the process for a question of a page."""
        key = (page[:NAME_LENGTH], question.is_slow)
        worker = self._by_page.pop(key, None) or Worker()
        self._by_page[key] = worker
        while len(self._by_page) > MOST_WORKERS:
            self._by_page.popitem(last=False)[1].close()
        return worker

    @asynccontextmanager
    async def at_work(self) -> AsyncIterator[None]:
        """Be there while the server is; end all processes with it."""
        yield
        for worker in self._by_page.values():
            worker.close()


def routes(project: Project, workers: Workers) -> list[BaseRoute]:
    """Return the route that answers questions about lines at rest."""

    async def at_rest(request: Request) -> Any:
        asked = await json_body(request)
        question = await run_sync(question_of, project, asked)
        status, content = await workers.of(str(asked.get("page", "")), question).ask(question)
        return Response(content, status, media_type="application/json")

    return [route("statics", at_rest, "POST")]
