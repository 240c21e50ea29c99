"""Tension lengths, overlaps and twin contact wires in files: what is refused, in which words."""

from typing import Any

import pytest

from arcless.errors import ModelError
from arcless.model import load, load_line
from tests.support.line_types import compound_data, scenario_data
from tests.support.overlaps import overlap_data, plain_data


def refusal(data: dict[str, Any]) -> str:
    with pytest.raises(ModelError) as caught:
        load_line(data)
    return str(caught.value)


def lengths(*pairs: tuple[int, int]) -> list[dict[str, int]]:
    return [{"from_span": first, "to_span": last} for first, last in pairs]


@pytest.mark.parametrize("shared", [3, 4, 5])
def test_round_trip(shared: int) -> None:
    line = load_line(overlap_data(shared))
    assert load_line(line.to_dict()) == line
    assert line.has_overlaps


def test_one_tension_length_over_all_spans_may_be_written_down() -> None:
    line = load_line(plain_data(6, tension_lengths=lengths((1, 6))))
    assert not line.has_overlaps
    assert line.tension_length_list() == load_line(plain_data(6)).tension_length_list()


@pytest.mark.parametrize(
    ("pairs", "message"),
    [
        (
            [(1, 7), (8, 11)],
            "tension_lengths.1.from_span: wires that do not meet in an overlap: got 0 spans that"
            " tension lengths 1 and 2 share, expected 3 to 5 spans; hint: from_span of the one"
            " behind is the first span of the overlap, to_span of the one before it the last",
        ),
        ([(1, 7), (6, 11)], "wires that do not meet in an overlap: got 2 spans"),
        ([(1, 8), (3, 11)], "overlap too long: got 6 spans"),
        (
            [(1, 5), (7, 11)],
            "tension_lengths.1.from_span: spans without wires: got no tension length over span 6,"
            " expected tension lengths over all spans of the line",
        ),
        ([(1, 4), (7, 11)], "no tension length over spans 5 to 6"),
        ([(2, 7), (5, 11)], "tension_lengths.0.from_span: spans without wires"),
        ([(1, 7), (5, 10)], "tension_lengths.1.to_span: spans without wires: got no tension"),
        (
            [(1, 5), (3, 7), (5, 11)],
            "tension_lengths.2.from_span: three wires over one span: got span 5, below tension"
            " lengths 1 to 3, expected a from_span behind 5, where tension length 1 ends",
        ),
        (
            [(1, 7), (5, 12)],
            "tension_lengths.1.to_span: tension length beyond the end of the line: got span 12,"
            " expected at most 11, the number of spans",
        ),
        (
            [(1, 7), (5, 4)],
            "tension_lengths.1.to_span: spans out of order: got 5 to 4, expected from_span, then a"
            " to_span that is not before it",
        ),
        (
            [(5, 11), (1, 7)],
            "tension_lengths.1: tension lengths out of order: got spans 1 to 7 after 5 to 11,"
            " expected each beginning and ending behind the one before it",
        ),
        ([(0, 7), (5, 11)], "tension_lengths.0.from_span"),
    ],
)
def test_refused_tension_lengths(pairs: list[tuple[int, int]], message: str) -> None:
    assert message in refusal(overlap_data(tension_lengths=lengths(*pairs)))


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (
            {"overlap": None},
            "overlap: missing field: expected overlap: how the wires of two tension lengths pass"
            " each other; hint: for instance overlap: {raise: [500 mm, 60 mm]}",
        ),
        ({"overlap": {"kind": "uninsulated"}}, "overlap.raise: missing field"),
        (
            {"tension_lengths": None},
            "overlap: overlap of a line with one tension length: expected tension_lengths with at"
            " least two entries, or no overlap",
        ),
        (
            {"overlap__raise": [0.06, 0.5]},
            "overlap.raise.1: a wire that hangs lower at its anchor than further in: got"
            " 0.5 m after 0.06 m, expected values that do not increase from the anchor inwards;"
            " hint: the first value is the one next to the anchor",
        ),
        (
            {"overlap__raise": [0.5, 0.3, 0.1]},
            "overlap.raise: both wires raised at one support: got 3 raised supports of each wire"
            " in an overlap of 3 spans, expected at most 2, so that one wire is at its height"
            " everywhere",
        ),
        ({"overlap__raise": [-0.1]}, "overlap.raise.0"),
        ({"overlap__separation": "4 m"}, "overlap.separation"),
        ({"overlap__kind": "isolated"}, "overlap.kind"),
        (
            {"overlap__stagger_in": [0.1, 0.1, 0.1, 0.1]},
            "overlap.stagger_out: missing field: expected staggers of both wires, or a separation"
            " alone",
        ),
        (
            {"overlap__stagger_in": [0.1] * 4, "overlap__stagger_out": [-0.1] * 5},
            "overlap.stagger_out: wrong number of values: got 5 values, expected 4, one for each"
            " support of the overlap from span 5 to span 7",
        ),
        (
            {"steady_arm": {"kind": "none"}},
            "overlap.separation: nothing holds the wires apart: got 0.2 m with a steady arm of"
            " kind none, expected separation: 0 m, or a steady arm of kind spring or arm",
        ),
    ],
)
def test_refused_overlaps(changes: dict[str, Any], message: str) -> None:
    assert message in refusal(overlap_data(**changes))


def test_an_insulated_overlap_keeps_more_distance() -> None:
    apart = [load_line(overlap_data(overlap__kind=k)).overlap for k in ("uninsulated", "insulated")]
    assert [one.apart for one in apart if one is not None] == [0.2, 0.45]


def test_wires_apart_make_a_line_spatial() -> None:
    assert load_line(overlap_data()).is_spatial
    assert not load_line(overlap_data(overlap__separation=0.0)).is_spatial


def as_built(line: dict[str, Any], **changes: Any) -> dict[str, Any]:
    return scenario_data(line, **{f"as_built__{name}": value for name, value in changes.items()})


def test_a_dropper_in_an_overlap_is_called_by_its_tension_length() -> None:
    data = as_built(overlap_data(), missing_droppers=["span 6 dropper 2"])
    with pytest.raises(ModelError) as caught:
        load(data)
    assert str(caught.value) == (
        "as_built.missing_droppers.0: a name that fits several droppers: got span 6 dropper 2,"
        " expected tension length 1 span 6 dropper 2 or tension length 2 span 6 dropper 2"
    )
    full = {"tension_length": 2, "span": 6, "dropper": 2}
    scenario = load(as_built(overlap_data(), missing_droppers=[full, "span 2 dropper 1"]))
    assert scenario.as_built.missing_droppers == (
        "tension length 2 span 6 dropper 2",
        "span 2 dropper 1",
    )


@pytest.mark.parametrize(
    ("names", "message"),
    [
        (
            ["span 2 dropper 1", "tension length 1 span 2 dropper 1"],
            "as_built.missing_droppers.1: dropper given twice: got tension length 1 span 2 dropper"
            " 1, which is tension length 1 span 2 dropper 1, expected each dropper once",
        ),
        (
            ["tension length 2 span 2 dropper 1"],
            "unknown dropper: got tension length 2 span 2 dropper 1, expected a dropper of the"
            " line's 11 spans; hint: did you mean tension length 1 span 2 dropper 1?",
        ),
        (["span 2 dropper 1 wire 2"], "unknown dropper"),
        (["wire 2 span 2 dropper 1"], "not a dropper"),
    ],
)
def test_refused_names(names: list[str], message: str) -> None:
    with pytest.raises(ModelError) as caught:
        load(as_built(overlap_data(), missing_droppers=names))
    assert message in str(caught.value)


TWIN = {"separation": 0.04}


def test_one_of_paired_droppers_is_called_by_its_wire() -> None:
    line = plain_data(6, twin_contact_wires=TWIN)
    with pytest.raises(ModelError, match="wire 1 or span 2 dropper 3 wire 2"):
        load(as_built(line, missing_droppers=["span 2 dropper 3"]))
    error = {"span": 2, "dropper": 3, "wire": 2, "length_error": 0.01}
    assert load(as_built(line, dropper_length_errors=[error])).as_built.dropper_length_errors
    alternating = plain_data(6, twin_contact_wires={**TWIN, "droppers": "alternating"})
    assert load(as_built(alternating, missing_droppers=["span 2 dropper 3"]))
    # Of a compound line the droppers hold one auxiliary wire.
    compound = compound_data(twin_contact_wires=TWIN)
    assert load(as_built(compound, missing_droppers=["span 2 dropper 3"]))


@pytest.mark.parametrize(
    ("twin", "message"),
    [
        ({}, "twin_contact_wires.separation: missing field"),
        ({"separation": 0}, "twin_contact_wires.separation"),
        ({"separation": 0.04, "droppers": "both"}, "twin_contact_wires.droppers"),
    ],
)
def test_refused_twins(twin: dict[str, Any], message: str) -> None:
    assert message in refusal(plain_data(6, twin_contact_wires=twin))
