"""`arcless studio`: the folder in the browser."""

from importlib.util import find_spec
from pathlib import Path
from typing import Annotated

import typer

from arcless.cli.terminal import console
from arcless.errors import OutputError

# Packages of the extra.
_PACKAGES = ("starlette", "uvicorn", "websockets")


def studio(
    folder: Annotated[
        Path,
        typer.Argument(metavar="FOLDER", help="Models, runs and studies are read and written "
                       "here, and nowhere else.", show_default=False),
    ] = Path(),
    *,
    browser: Annotated[
        bool, typer.Option("--browser/--no-browser", help="Open the address in the browser.")
    ] = True,
    port: Annotated[
        int,
        typer.Option(help="Port to listen on; 0 takes one that is free.", min=0, max=65535),
    ] = 0,
) -> None:  # fmt: skip
    """See the line move, change it, and compare runs in the browser.

    Serves the page of FOLDER (this folder without) on this machine alone, and prints its address.
    All who have the address can read and write the models of the folder. Ctrl-C ends it, runs that
    are being computed with it.
    """
    missing = [name for name in _PACKAGES if find_spec(name) is None]
    if missing:
        raise OutputError(
            f"the studio needs the package {missing[0]}, which is not installed",
            hint="pip install 'arcless[studio]'",
        )
    from arcless.studio.server.serve import serve

    def ready(address: str, for_browser: str) -> None:
        console.data(address)
        if browser:
            _open(for_browser)

    serve(folder, port, ready)


def _open(address: str) -> None:
    """Open an address in the browser; one that runs in the terminal is not waited for."""
    import webbrowser
    from threading import Thread

    Thread(target=webbrowser.open, args=(address,), daemon=True).start()
