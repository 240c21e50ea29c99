"""Hints reach the page without options of the command line, which it has not."""

import re
from pathlib import Path

import pytest

import arcless
from arcless.errors import FmuError, ModelError, OutputError
from arcless.measurements.remarks import WITHOUT_INERTIA
from arcless.model import Scenario
from arcless.simulate.fmu.admission import ENVIRONMENT, check_admitted
from arcless.studio.answers.answers import complaint
from arcless.studio.answers.page_words import in_page_words
from tests.support import fmus

OPTION = re.compile(r"(?<![\w-])--[a-z]")
HINT = re.compile(r'hint\s*=\s*\(?\s*f?"([^"]*--[a-z][^"]*)"')


def hints() -> list[str]:
    """Return the hints of the package that name options, where they stand in one text."""
    top = Path(arcless.__file__).parent
    files = [one for one in top.rglob("*.py") if "cli" not in one.relative_to(top).parts]
    return sorted({hint for one in files for hint in HINT.findall(one.read_text("utf-8"))})


def test_there_are_such_hints() -> None:
    assert len(hints()) > 10


@pytest.mark.parametrize("hint", hints())
def test_no_hint_names_an_option(hint: str) -> None:
    told = complaint(OutputError("it cannot be written", where="runs/a", hint=hint))
    assert not OPTION.search(told["text"])
    assert not OPTION.search(told.get("hint", ""))
    assert told["text"].startswith("runs/a: it cannot be written")


def test_what_the_page_offers_is_said_instead() -> None:
    assert in_page_words("`--overwrite` replaces it, `--out FOLDER` keeps both") == (
        "another name of the scenario keeps both"
    )
    assert in_page_words("wait for the other one, or choose another folder with `--out`") == (
        "wait for the other one"
    )
    assert in_page_words("widen the search (--search), or give the offset by hand (--offset)") == (
        "`arcless compare` takes an offset"
    )


def test_remarks_keep_what_can_be_done_here() -> None:
    told = in_page_words(WITHOUT_INERTIA)
    assert not OPTION.search(told)
    assert told.endswith(": call the column contact_force where the recorder took it off")


def with_an_fmu(folder: Path) -> Scenario:
    """Return a scenario whose pantograph is an FMU that nothing may load."""
    file = fmus.undescribed(folder, fmus.description(), ("linux64", "darwin64"))
    own = {"name": "outside", "fmu": {"file": str(file), "static_force": "static_force"}}
    placed = [{"model": own, "static_force": "120 N"}]
    return arcless.load("en50318-ac-simple-275").with_(pantographs=placed)


def test_an_fmu_is_allowed_where_the_studio_is_started(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv(ENVIRONMENT, raising=False)
    with pytest.raises(FmuError) as refused:
        check_admitted(with_an_fmu(tmp_path), allow_fmu=False)
    told = complaint(refused.value)
    words = "a studio that was started with the environment variable ARCLESS_ALLOW_FMU=1"
    assert told["expected"] == words
    assert told["what"] == "pantograph P1 is an FMU, and FMUs are not allowed to run"
    assert f"expected {words}; hint: its code runs with all rights" in told["text"]
    assert not any(OPTION.search(str(part)) for part in told.values())


def test_a_session_with_an_fmu_says_what_goes_instead(tmp_path: Path) -> None:
    with pytest.raises(ModelError) as refused:
        arcless.realtime(with_an_fmu(tmp_path), simulated=True)
    assert complaint(refused.value)["text"] == (
        "pantographs.0.model.fmu: not in a real-time loop: an FMU runs in a process of its own;"
        " hint: run the scenario instead"
    )


def test_other_messages_stay_as_they_are() -> None:
    for text in ("got -1 N, expected 0 N -- or more", "a--b: no such file", "span 3 − 4"):
        assert in_page_words(text) == text
