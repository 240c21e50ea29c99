"""The routes of all rooms in one application."""

from collections.abc import AsyncIterator
from contextlib import AbstractAsyncContextManager, AsyncExitStack, asynccontextmanager

from starlette.applications import Starlette
from starlette.routing import BaseRoute
from starlette.types import ASGIApp

from arcless.studio.at_rest import routes as at_rest_routes
from arcless.studio.jobs.jobs import Jobs
from arcless.studio.project import routes as project_routes
from arcless.studio.project.project import Project
from arcless.studio.runs import routes as runs_routes
from arcless.studio.runs.motions import Motions
from arcless.studio.server import page
from arcless.studio.server.gate import Gate
from arcless.studio.server.keys import Keys
from arcless.studio.stream import routes as stream_routes
from arcless.studio.stream.hub import Hub


def application(project: Project, keys: Keys) -> ASGIApp:
    """Return the application that serves the page and answers its questions about a project.

    What several rooms share is made here and handed to them; what works beside the routes is
    entered when the server starts, and left when it ends.
    """
    desks, hub = at_rest_routes.Desks(), Hub()
    jobs = Jobs(hub.tell)
    motions = Motions(project, jobs)
    at_work: list[AbstractAsyncContextManager[object]] = [
        desks.at_work(), hub.at_work(), jobs.at_work()
    ]  # fmt: skip
    routes: list[BaseRoute] = [
        *project_routes.routes(project),
        *at_rest_routes.routes(project, desks),
        *runs_routes.routes(project, jobs),
        *stream_routes.routes(hub, motions.open, motions.compute),
        # One line for each room, `*ROOM.routes(project, …)`.
        *page.routes(),
    ]

    @asynccontextmanager
    async def lifespan(_: Starlette) -> AsyncIterator[None]:
        async with AsyncExitStack() as stack:
            for each in at_work:
                await stack.enter_async_context(each)
            yield

    return Gate(Starlette(routes=routes, lifespan=lifespan), keys)
