"""The routes of all rooms in one application."""

from starlette.applications import Starlette
from starlette.routing import BaseRoute

from arcless.studio.project.project import Project


def application(project: Project) -> Starlette:
    """Return the application that serves the page and answers its questions about a project."""
    routes: list[BaseRoute] = []
    app = Starlette(routes=routes)
    app.state.project = project
    return app
