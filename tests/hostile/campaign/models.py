"""Models with numbers spoilt, at rest and running: a clean error, or numbers that are finite."""

import json
import warnings
from functools import cache
from pathlib import Path
from random import Random
from typing import Any

import numpy as np

import arcless
from arcless.errors import ArclessError, ModelError
from tests.hostile.campaign import spoiling
from tests.hostile.campaign.blocks import FoundError
from tests.support.small import small

SHORT = Path(__file__).parents[2] / "interface" / "data" / "short.yaml"
# Shipped scenarios with parts that the short ones do not have, cut to a second.
NAMES = ("conductor-rail-1-120", "trolley-bridles-60", "norway-s25-250", "spain-ca-160-3kv-160")
WAY_M = 25.0
STATICS_EVERY = 4


@cache
def sound() -> list[dict[str, Any]]:
    """Scenarios that take a second."""
    found = [arcless.load(SHORT), small(), small(**{"solver.scheme": "generalised-alpha"})]
    for name in NAMES:
        scenario = arcless.load(name)
        start = scenario.travel_range()[0]
        end = start + WAY_M + scenario.pantographs[-1].distance
        place = {"from": start, "to": start + WAY_M}
        found.append(scenario.with_(travel={"start": start, "end": end}, analysis=place))
    return [scenario.to_dict() for scenario in found]


def case(seed: int) -> str:
    """Spoil numbers of a scenario, and run it; every fourth one is asked for its statics too."""
    random = Random(f"models {seed}")
    warnings.simplefilter("ignore")
    data = spoiling.numbers(random, random.choice(sound()), times=random.choice([1, 1, 2, 3]))
    try:
        scenario = arcless.load(data)
    except ModelError:
        return "refused"
    try:
        if random.randrange(STATICS_EVERY) == 0:
            json.dumps(arcless.statics(scenario).to_dict(), allow_nan=False)
        result = arcless.run(scenario)
    except ArclessError as error:
        if "nan" in str(error).lower().split():
            raise FoundError(f"a message with nan: {error}") from error
        return type(error).__name__
    finite(result)
    return "ran"


def finite(result: Any) -> None:
    """See that the numbers of a result are finite, and its assessment can be written."""
    if not np.isfinite(result.recorded["contact_force"].values).all():
        raise FoundError("forces that are not finite")
    if "NaN" in result.assessment.to_json():
        raise FoundError("NaN in the assessment")
