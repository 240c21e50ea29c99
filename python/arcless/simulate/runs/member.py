"""One member of a batch: the runs that it needs, and what is kept of the last one."""

import time
from collections.abc import Callable, Generator
from typing import Any

from arcless.assess import Assessment, assess
from arcless.dataset.build import attributes, variables
from arcless.dataset.plain_dataset import Plain
from arcless.results import Result
from arcless.simulate.recording import contacts
from arcless.simulate.runs.job import Job, keeps_ledger, measured_every
from arcless.simulate.runs.mean_force import Trial, make_runs, searching
from arcless.simulate.runs.outcome import Keep
from arcless.simulate.runs.run_result import attributes_of, whole

# Gives runs to make, and is sent what the core returned.
Running = Generator[Trial, dict[str, Any] | None, Assessment | Result]
# Channels of the contact that an assessment reads.
CHANNELS = ("contact_force", "contact_gap", "contact_height")


def records_all(job: Job, keep: Keep) -> bool:
    """Return whether the runs of a member record more than an assessment reads.

    An energy balance that books every step is settled where the line is recorded: its residual is
    that of a whole record.
    """
    is_settled_in_rows = keeps_ledger(job.scenario) and measured_every(job.scenario) == 1
    return keep == "result" or is_settled_in_rows


def running(
    job: Job, keep: Keep, started: float, additional: Callable[[list[float]], Any] | None = None
) -> Running:
    """Run a member: give runs to make until it is done.

    Parameters
    ----------
    job
        The member, laid out on its line.
    keep
        What is wanted of it.
    started
        Clock at its start in s.
    additional
        Given the static forces in N, runs what says how sure its numbers are; None without.
    """
    search = yield from searching(job)
    raw = search.record
    if raw is None:
        raw = yield Trial(job, search.forces)
        assert raw is not None
    sure = None if additional is None else additional(search.forces)
    if keep == "result":
        command = f"arcless run {job.scenario.name}"
        return whole(job, search.forces, raw, started, command=command, sure=sure)
    return _assessed(job, search.forces, raw, started, sure)


def assessed_alone(job: Job, started: float) -> Assessment:
    """Run a member to its end, and assess it.

    With the clock at its start in s.
    """
    full = records_all(job, "assessment")
    done = make_runs(running(job, "assessment", started), lambda trial: trial.run(full=full))
    assert isinstance(done, Assessment)
    return done


def _assessed(
    job: Job,
    forces: list[float],
    raw: dict[str, Any],
    started: float,
    sure: dict[str, Any] | None,
) -> Assessment:
    """Assess a run from no more of its record than is read."""
    raw["setup_s"] = time.perf_counter() - started - raw["wall_s"]
    return assess(dataset(job, forces, raw, sure))


def dataset(
    job: Job, forces: list[float], raw: dict[str, Any], sure: dict[str, Any] | None = None
) -> Plain:
    """Return what an assessment reads of a record, which may be of a part of a run.

    With the static forces in N, and its additional runs; `raw` has wall_s and setup_s.
    """
    count, mesh = len(job.scenario.pantographs), job.found.mesh
    channels = contacts.channels(raw, count)
    read: dict[str, Any] = {name: channels[name] for name in CHANNELS}
    read["position"] = raw["position"].reshape(-1, count)
    read["speed"] = raw["speed"]
    read["dropper_force_min"] = raw["link_min"][[dropper.link for dropper in mesh.droppers]]
    read["dropper_x"] = [dropper.x for dropper in mesh.droppers]
    read["support_uplift_max"] = raw["uplift_max"]
    read["support_x"] = [support.x for support in mesh.supports]
    names = {
        "time": raw["time"],
        "pantograph": [placement.name for placement in job.scenario.pantographs],
        "dropper": [dropper.name for dropper in mesh.droppers],
        "support": [support.name for support in mesh.supports],
    }
    facts = {**attributes_of(job, raw, forces), "certainty": sure}
    return Plain(*variables(read, names), attributes(facts))
