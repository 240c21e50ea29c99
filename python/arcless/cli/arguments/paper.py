"""Options of commands that write a report on paper."""

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer

PdfOption = Annotated[
    Path | None,
    typer.Option(
        "--pdf",
        metavar="FILE",
        help="Write the report as a PDF file for print and for the archive.",
        show_default=False,
    ),
]
FieldOption = Annotated[
    list[str] | None,
    typer.Option(
        "--field",
        metavar="NAME=VALUE",
        help='A field of the cover of the PDF file, such as "author=A. Smith"; may be given again.',
        show_default=False,
    ),
]


def fields_for(pdf: Path | None, texts: Sequence[str] | None) -> dict[str, str]:
    """Return the fields of the cover, before anything is read or drawn.

    Raises
    ------
    OutputError
        The file could not be written, a field is none, or there are fields without a file.
    """
    if pdf is None:
        if texts:
            raise typer.BadParameter("fields are for the cover of a PDF file: give --pdf FILE",
                                     param_hint="--field")  # fmt: skip
        return {}
    from arcless.report.paper.fields import parse_fields
    from arcless.report.paper.typeset import check_target

    found = parse_fields(texts or [])
    check_target(pdf)
    return found
