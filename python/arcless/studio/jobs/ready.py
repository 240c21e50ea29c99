"""First task of a process for jobs: to import what a run needs, so that a run begins at once."""

import gc
from importlib import import_module

from arcless.studio.processes.talk import Talk

_AHEAD = ("arcless.simulate", "arcless.assess", "arcless.validate", "h5py",
          "arcless.results.run_folder.files", "arcless.studio.runs.run")  # fmt: skip


def make_ready(_talk: Talk) -> None:
    """Import what a run needs."""
    from arcless.report import template

    for name in _AHEAD:
        import_module(name)
    template.import_ahead()
    gc.freeze()  # nothing of what was imported will ever be garbage
