"""Archive of an FMU: description, libraries, model, and a page about it.

The same model gives the same bytes: entries have one date, and stand in one order.
"""

import html
import io
import zipfile
from collections.abc import Mapping
from pathlib import Path

from arcless.fmi.export.description import Description, Version, model_description
from arcless.fmi.export.library import PLATFORMS

# Name of the model among the resources, as the library looks for it.
MODEL = "model.loop"
# The first date that a zip archive can have.
DATE = (1980, 1, 1, 0, 0, 0)
PAGE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>{title}</title></head><body>
<h1>{title}</h1><p>{about}. By Arcless, licence Apache-2.0.</p>
<p>A communication step is a whole number of steps of {step:g} s. Steps follow one another; states
can be saved and restored.</p>
<table border="1"><tr><th>variable</th><th>unit</th><th>role</th><th>what it is</th></tr>
{rows}
</table></body></html>
"""


def archive(
    model: bytes, description: Description, version: Version, libraries: Mapping[str, Path]
) -> bytes:
    """Return an FMU for a version of the FMI, with libraries by their platforms."""
    entries = {
        "modelDescription.xml": model_description(description, version),
        f"resources/{MODEL}": model,
        "documentation/index.html": page(description).encode(),
    }
    for name, path in libraries.items():
        platform = PLATFORMS[name]
        folder = platform.fmi2 if version == 2 else platform.fmi3  # noqa: PLR2004
        entries[f"binaries/{folder}/{platform.library}"] = path.read_bytes()
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as file:
        for name, content in entries.items():
            entry = zipfile.ZipInfo(name, DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            file.writestr(entry, content)
    return out.getvalue()


def page(description: Description) -> str:
    """Return a page about a model: its variables."""
    row = "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>"
    rows = [
        row.format(*(html.escape(text) for text in (v.name, v.unit, v.role, v.description)))
        for v in description.variables
    ]
    return PAGE.format(
        title=html.escape(description.title),
        about=html.escape(description.about),
        step=description.step_length,
        rows="\n".join(rows),
    )
