"""The routes of all rooms in one application."""

from collections.abc import AsyncIterator
from contextlib import AbstractAsyncContextManager, AsyncExitStack, asynccontextmanager

from starlette.applications import Starlette
from starlette.routing import BaseRoute
from starlette.types import ASGIApp

from arcless.studio.at_rest import routes as at_rest_routes
from arcless.studio.charts import routes as chart_routes
from arcless.studio.hands_on import routes as hands_on_routes
from arcless.studio.jobs.jobs import Jobs
from arcless.studio.model_text import routes as text_routes
from arcless.studio.project import measured
from arcless.studio.project import routes as project_routes
from arcless.studio.project.project import Project
from arcless.studio.project.view import View
from arcless.studio.project.watch import Watch
from arcless.studio.runs import routes as runs_routes
from arcless.studio.runs.motions import Motions
from arcless.studio.server import page
from arcless.studio.server.crowd import Crowd
from arcless.studio.server.gate import Gate
from arcless.studio.server.keys import Keys
from arcless.studio.stream import routes as stream_routes
from arcless.studio.stream.hub import Hub
from arcless.studio.studies import routes as studies_routes
from arcless.studio.studies.computing import Computing

# Most bytes of a question where a file is sent: a measured run, as long as the reader takes it.
LONGEST = {"/api/measured": measured.LONGEST}


def application(project: Project, keys: Keys, crowd: Crowd) -> ASGIApp:
    """Return the application that serves the page and answers its questions about a project.

    What several rooms share is made here and handed to them; what works next to the routes is
    entered when the server starts, and left when it ends.
    """
    desks, hub, view = at_rest_routes.Desks(), Hub(), View(project)
    jobs, watch = Jobs(hub.tell), Watch(view, hub.tell)
    computing = Computing()
    motions = Motions(project, jobs)
    at_work: list[AbstractAsyncContextManager[object]] = [
        desks.at_work(), hub.at_work(), jobs.at_work(), watch.at_work(), computing.at_work()
    ]  # fmt: skip
    routes: list[BaseRoute] = [
        *project_routes.routes(view),
        *at_rest_routes.routes(project, desks),
        *text_routes.routes(project),
        *chart_routes.routes(project),
        *hands_on_routes.routes(project),
        *studies_routes.routes(project, computing),
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

    return Gate(Starlette(routes=routes, lifespan=lifespan), keys, crowd, LONGEST)
