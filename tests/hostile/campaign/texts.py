"""Spoilt texts and data for the loader: a model error, or a model that is whole and finite."""

import json
import warnings
from functools import cache
from pathlib import Path
from random import Random
from tempfile import gettempdir
from typing import Any

from arcless.errors import ModelError
from arcless.model import load_any, scenario_warnings
from arcless.model.files.yaml_reader import parse, read_text
from arcless.model.scenario.scenario import Scenario
from arcless.model.shipped.library import shipped
from tests.hostile.campaign import spoiling
from tests.hostile.campaign.blocks import FoundError
from tests.support.hostile import numbers_in

KINDS = ("scenario", "line", "pantograph")
# Through YAML a text takes a hundred times as long as its data.
THROUGH_A_FILE = 0.25


@cache
def sound() -> list[tuple[bytes, Any]]:
    """Shipped models: their files and what these say."""
    texts = [read_text(shipped(kind)[name], name) for kind in KINDS for name in shipped(kind)]
    return [(text.encode(), parse(text, "shipped")[0]) for text in texts]


def case(seed: int) -> str:
    """Spoil a text or its data, and load it."""
    random = Random(f"texts {seed}")
    text, data = random.choice(sound())
    warnings.simplefilter("ignore")
    if random.random() < THROUGH_A_FILE:
        path = Path(gettempdir()) / f"arcless-campaign-{seed}.yaml"
        path.write_bytes(spoiling.text(random, text))
        try:
            return loaded(path)
        finally:
            path.unlink()
    return loaded(spoiling.data(random, data, times=random.randint(1, 3)))


def loaded(given: Any) -> str:
    """Load a model; it is refused in words, or whole."""
    try:
        model = load_any(given)
    except ModelError as error:
        message = str(error)
        if not message or "Traceback" in message:
            raise FoundError(message) from error
        if any(ord(sign) < ord(" ") and sign != "\n" for sign in message):
            raise FoundError(f"control characters in {message!r}") from error
        return "refused"
    data = json.loads(json.dumps(model.to_dict(), allow_nan=False))
    if not all(abs(number) < float("inf") for number in numbers_in(data)):
        raise FoundError("numbers that are not finite")
    if isinstance(model, Scenario):
        scenario_warnings(model)
    return "loaded"
