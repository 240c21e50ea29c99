"""Columns of a run over position or time, as lowest and highest values in equal buckets."""

from typing import Any

import numpy as np
from starlette.requests import Request
from starlette.responses import Response

from arcless.studio.charts import asked
from arcless.studio.charts.charted_run import ChartedRun
from arcless.studio.charts.plain.binary import binary
from arcless.studio.charts.plain.drawable import span


def answer(run: ChartedRun, request: Request) -> Response:
    """Return places, lowest and highest values of the buckets of a series, as singles.

    Three rows of little-endian singles, one after the other: x of the first sample of each bucket,
    minimum, maximum; NaN where there is no number. The header has the count, the unit, the range.
    """
    name = request.query_params.get("name", "")
    column = asked.whole(request.query_params, "column", 0, 0, 10_000)
    x = request.query_params.get("x", "position")
    values, shown = run.series(name, column), asked.shown(request.query_params)
    places = run.places(name, column, "time" if x == "time" else "position")
    begin, end = 0, values.size
    if bool(np.all(places[1:] >= places[:-1])):
        begin, end = span(places, shown.low, shown.high)
    low, high = run.pyramid(values).buckets(begin, end, max(1, shown.points // 2))
    first = np.minimum(low, high)
    rows = np.stack([places[first], values[low], values[high]]).astype("<f4")
    attrs = run.result.recorded[run.stored(name)].attrs
    about: dict[str, Any] = {
        "count": int(low.size),
        "samples": end - begin,
        "unit": str(attrs.get("units", "")),
        "label": str(attrs.get("long_name", name)),
        "from": float(places[0]) if places.size else None,
        "to": float(places[-1]) if places.size else None,
    }
    return binary(rows.tobytes(), about)
