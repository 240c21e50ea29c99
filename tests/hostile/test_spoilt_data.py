"""Spoilt data give a model error that names a field, or a model that is whole; nothing else.

What is spoilt: every shipped scenario, line and pantograph as its file says it, whole scenarios
with everything written out, and random valid ones.
"""

import json
from functools import cache
from typing import Any

from hypothesis import given
from hypothesis import strategies as st

from arcless.errors import ModelError
from arcless.model import load, load_any, scenario_warnings
from arcless.model.files.yaml_reader import parse, read_text
from arcless.model.scenario.scenario import Scenario
from arcless.model.shipped.library import shipped
from tests.support.hostile import numbers_in, searching, spoilt
from tests.support.valid_models import scenarios


@cache
def written(kind: str, name: str) -> dict[str, Any]:
    """A shipped model as its file says it."""
    return parse(read_text(shipped(kind)[name], name), name)[0]


@cache
def whole(name: str) -> dict[str, Any]:
    """A shipped scenario with everything written out."""
    return load(name).to_dict()


NAMES = [(kind, name) for kind in ("scenario", "line", "pantograph") for name in shipped(kind)]
SOUND = st.one_of(
    st.sampled_from(NAMES).map(lambda entry: written(*entry)),
    st.sampled_from(list(shipped("scenario"))).map(whole),
    scenarios(),
)


def check(data: Any) -> str:
    """Load what may be spoilt; tell what became of it."""
    try:
        model = load_any(data)
    except ModelError as error:
        message = str(error)
        assert message and "Traceback" not in message
        assert error.exit_code == 2
        named = error.what.startswith(("format", "unknown")) or ": " in error.what
        assert named or error.field or error.where
        return "refused"
    again = json.loads(json.dumps(model.to_dict(), allow_nan=False))
    assert all(abs(number) < float("inf") for number in numbers_in(again))
    assert load_any(again) == model
    if isinstance(model, Scenario):
        assert all(isinstance(text, str) for text in scenario_warnings(model))
    return "taken"


@searching(120)
@given(data=SOUND.flatmap(spoilt))
def test_spoilt_data(data: Any) -> None:
    check(data)
