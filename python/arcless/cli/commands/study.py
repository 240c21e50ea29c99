"""`arcless study`: a scenario mapped over many variants."""

import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from arcless.cli.arguments.paper import FieldOption, PdfOption, fields_for
from arcless.cli.arguments.scenario import JsonOption, QuietOption
from arcless.cli.completion import names
from arcless.cli.process.background import compute, unfinished
from arcless.cli.process.guard import FAILED
from arcless.cli.terminal import console, study_texts
from arcless.cli.terminal.study_progress import progress
from arcless.errors import OutputError

if TYPE_CHECKING:
    from arcless.study import Execution, Study

app = typer.Typer(rich_markup_mode=None, add_completion=False, no_args_is_help=True)
FileArgument = Annotated[
    Path,
    typer.Argument(
        metavar="FILE",
        help="A study file, or the name of a shipped study.",
        autocompletion=names.studies,
    ),
]
BegunArgument = Annotated[
    Path,
    typer.Argument(
        metavar="STUDY",
        help="A study file, the name of a shipped study, or the folder or journal of a study.",
        autocompletion=names.begun_studies,
    ),
]
FolderOption = Annotated[
    Path | None,
    typer.Option(
        "--out",
        metavar="DIR",
        help="Folder of the study; runs/studies/NAME if not named.",
        show_default=False,
    ),
]
ExecutorOption = Annotated[
    Literal["threads", "dask"] | None,
    typer.Option("--executor", help="What computes; as the file says if not named."),
]
WorkersOption = Annotated[
    int | None,
    typer.Option(
        "--workers",
        min=1,
        max=1024,
        help="Threads, or worker processes of Dask; all cores if not named.",
    ),
]
SchedulerOption = Annotated[
    str | None,
    typer.Option(
        "--scheduler",
        metavar="ADDRESS",
        help="A Dask scheduler that runs already, such as tcp://host:8786.",
        show_default=False,
    ),
]
# Time in s that a stopped study may take to put its table and its workers in order.
_LEAVES_WITHIN_S = {"threads": 0.8, "dask": 20.0}


@app.callback()
def study() -> None:
    """Compute many variants of a scenario.

    A study file describes them: a grid, a list or a sample.

    A study has a folder with its table (table.parquet), which grows while it is computed. Whatever
    ends a study, `arcless study resume` computes what is missing and nothing else.
    """


@app.command()
def run(
    file: FileArgument,
    *,
    out: FolderOption = None,
    executor: ExecutorOption = None,
    workers: WorkersOption = None,
    scheduler: SchedulerOption = None,
    json: JsonOption = False,
    quiet: QuietOption = False,
) -> None:
    """Begin a study and compute it to its end.

    A variant that fails is a row with its error. Exit code 1 means that no variant has a value, or
    that the study was cut off.
    """
    how = (executor, workers, scheduler)
    _compute(file, out, how, json=json, quiet=quiet)


@app.command()
def resume(
    file: BegunArgument,
    *,
    out: FolderOption = None,
    executor: ExecutorOption = None,
    workers: WorkersOption = None,
    scheduler: SchedulerOption = None,
    retry_failed: Annotated[
        bool, typer.Option("--retry-failed", help="Compute those again that failed.")
    ] = False,
    json: JsonOption = False,
    quiet: QuietOption = False,
) -> None:
    """Continue a study that was cut off: compute what is missing.

    The file must say what it said when the study was begun; what differs is shown. What computes
    may be another executor.
    """
    how = (executor, workers, scheduler)
    _compute(file, out, how, json=json, quiet=quiet, resume=True, retry_failed=retry_failed)


@app.command()
def status(file: BegunArgument, *, out: FolderOption = None, json: JsonOption = False) -> None:
    """Say how far a study is, also while it is being computed."""
    from arcless import study as studies
    from arcless.study.analysis import findings
    from arcless.study.folder.started_studies import located

    loaded, out = located(file, out)
    found, more = findings.findings(loaded, out)
    if not found.running:  # who computes it writes them in the end
        try:
            findings.write(studies.StudyFolder(loaded, out), more)
        except OutputError as error:
            console.warn(str(error))
    if json:
        console.data(console.json_text(found.to_dict() | more))
    else:
        study_texts.show_status(found)


@app.command()
def report(
    file: BegunArgument,
    *,
    out: FolderOption = None,
    to: Annotated[
        Path | None,
        typer.Option(
            "--to",
            metavar="FILE",
            help="The page to write; report.html in the folder of the study if neither it nor --pdf"
            " is named.",
            show_default=False,
        ),
    ] = None,
    pdf: PdfOption = None,
    field: FieldOption = None,
) -> None:
    """Write the report of a study, also while it is being computed: HTML page, PDF file, or both.

    With --pdf alone only the PDF file is written.
    """
    from arcless.study.folder.started_studies import located
    from arcless.study.report import write, write_pdf

    fields = fields_for(pdf, field)
    study, folder = located(file, out)
    if to is not None or pdf is None:
        console.data(f"wrote {write(study, folder, to)}")
    if pdf is not None:
        write_pdf(study, pdf, folder, fields=fields)
        console.data(f"wrote {pdf}")


@app.command()
def trials(
    file: BegunArgument,
    *,
    out: FolderOption = None,
    to: Annotated[
        Path | None,
        typer.Option(
            "--to",
            metavar="FILE",
            help="The SQLite file to write; trials.db in the folder of the study if not named.",
            show_default=False,
        ),
    ] = None,
) -> None:
    """Write the trials of an optimisation for Optuna's own programs, also while it is computed."""
    from arcless.study.folder.optuna_trials import write
    from arcless.study.folder.started_studies import located

    path, count = write(*located(file, out), to)
    console.data(f"wrote {path}: {count} trials")


@app.command()
def variant(
    file: BegunArgument,
    number: Annotated[int, typer.Argument(metavar="NUMBER", help="Its number, from 1.", min=1)],
    *,
    out: FolderOption = None,
    to: Annotated[
        Path | None,
        typer.Option(
            "--to",
            metavar="FILE",
            help="The file to write; standard output if not named.",
            show_default=False,
        ),
    ] = None,
) -> None:
    """Write the scenario of one variant, which `arcless run` takes."""
    from arcless import study as studies
    from arcless.errors import ModelError
    from arcless.storage.whole_files import write_bytes
    from arcless.study.evaluation.variants import scenario
    from arcless.study.folder.started_studies import located

    if out is not None and out.suffix.lower() in {".yaml", ".yml", ".json"}:
        raise ModelError("--out", got=str(out), expected="the folder of the study",
                         hint=f"--to {out} writes the scenario into this file")  # fmt: skip
    loaded, out = located(file, out)
    if isinstance(loaded.design, studies.Optimise):
        studies.StudyFolder(loaded, out).recall()
    made = scenario(loaded, number)
    text = console.json_text(made.to_dict())  # JSON is YAML, and every digit stays
    if to is None:
        console.data(text)
    else:
        write_bytes(to, f"{text}\n".encode())
        console.data(f"wrote {to}")


def _compute(
    file: Path,
    out: Path | None,
    how: tuple[Any, int | None, str | None],
    *,
    json: bool,
    quiet: bool,
    **options: Any,
) -> None:
    from arcless import study as studies
    from arcless.study.folder.started_studies import located

    loaded, out = located(file, out)
    place = studies.StudyFolder(loaded, out)
    chosen = _execution(loaded, *how)
    note = (lambda _text: None) if quiet else console.warn
    with progress(quiet=quiet) as tell:
        try:
            done = compute(
                lambda cancel: studies.run(
                    loaded, out, executor=chosen, tell=tell, note=note, cancel=cancel, **options
                )
            )
        except KeyboardInterrupt:
            _wait_for_end(_LEAVES_WITHIN_S[chosen.kind])
            if not quiet:
                console.note(
                    f"rows so far: {place.table}; continue with `{place.command('resume')}`"
                )
            raise
    facts = study_texts.facts_of(loaded, place, done)
    front = study_texts.front_of(loaded, place)
    curves = study_texts.spacings_of(loaded, place)
    if json:
        best = {} if front is None else {"best": [row.variant for row in front]}
        spacings = {"spacings": [curve.to_dict() for curve in curves]} if curves else {}
        console.data(console.json_text(facts | best | spacings | {"table": str(place.table)}))
    else:
        study_texts.show_done(facts)
        study_texts.show_front(loaded, front)
        study_texts.show_spacings(loaded, curves)
        console.data(f"wrote {place.table}")
    if not done.counts["done"]:
        raise typer.Exit(FAILED)


def _execution(
    loaded: "Study", kind: str | None, workers: int | None, scheduler: str | None
) -> "Execution":
    """Return the execution settings: of the command line, else of the file."""
    from arcless import study as studies

    own = loaded.executor
    kind = kind or ("dask" if scheduler is not None else own.kind)
    if kind == own.kind and workers is None:
        scheduler = scheduler or own.scheduler
    if scheduler is None:
        workers = workers or own.workers
    given = {"kind": kind, "workers": workers, "scheduler": scheduler}
    return studies.execution({name: value for name, value in given.items() if value is not None})


def _wait_for_end(longest_s: float) -> None:
    deadline = time.monotonic() + longest_s
    while unfinished() and time.monotonic() < deadline:
        time.sleep(0.02)
