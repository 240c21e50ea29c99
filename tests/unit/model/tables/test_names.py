"""Names of the types of spans, heights and staggers as a model file has them."""

from random import Random

from arcless.model.line.parts.heights import HeightChange, heights_at
from arcless.model.tables.spans import Hung, Span, named, runs
from arcless.model.tables.supports import pattern, stretches

A, B, C = (Span(length, Hung((length / 2,)), None) for length in (50.0, 55.0, 60.0))


def test_spans_of_a_name_that_differ_become_types_of_their_own() -> None:
    names, types = named([A, B, A, C, B], ["s"] * 5, {"s": A}, {"s"})
    assert names == ["s", "s-2", "s", "s-4", "s-2"]
    assert types == {"s": A, "s-2": B, "s-4": C}


def test_a_name_stays_that_of_the_type_the_line_has() -> None:
    # The first span differs from the type of the line; a later one is as it was.
    assert named([B, A], ["s", "s"], {"s": A}, {"s"})[0] == ["s-1", "s"]
    # No span is as it was: the type itself changes.
    assert named([B, B], ["s", "s"], {"s": A}, {"s"}) == (["s", "s"], {"s": B})


def test_spans_without_a_name_find_one() -> None:
    assert named([A, B, B], [None] * 3, {"s": A}, {"s"})[0] == ["s", "span-2", "span-2"]
    # Named further behind in the table.
    assert named([B, B], [None, "t"], {"s": A}, {"s"})[0] == ["t", "t"]
    # The line's type of this content becomes another one, so its name is none of these spans'.
    assert named([A, B], [None, "s"], {"s": A}, {"s"})[0] == ["span-1", "s"]


def test_a_name_that_is_taken_is_not_given_again() -> None:
    # No span of the line has the type s-2, which stays.
    names, types = named([A, B], ["s", "s"], {"s": A, "s-2": C}, {"s"})
    assert names == ["s", "s-2-2"]
    assert types == {"s": A, "s-2-2": B}
    # A row has the name.
    assert named([A, B, C], ["s", "s", "s-2"], {"s": A}, {"s"})[0] == ["s", "s-2-2", "s-2"]


def test_a_table_that_is_read_again_gives_the_same_names() -> None:
    names, types = named([A, B], ["s", "s"], {"s": A}, {"s"})
    assert named([A, B], ["s", "s"], types, set(names)) == (names, types)
    # Changed further, the type of that span changes.
    assert named([A, C], ["s", "s"], types, set(names)) == (names, {"s": A, "s-2": C})


def test_runs_count_equal_spans() -> None:
    assert runs(["a", "a", "b", "a"]) == [
        {"type": "a", "count": 2}, {"type": "b", "count": 1}, {"type": "a", "count": 1},
    ]  # fmt: skip


def test_the_shortest_pattern_is_found() -> None:
    assert pattern([0.2, -0.2, 0.2, -0.2, 0.2]) == [0.2, -0.2]
    assert pattern([0.0, 0.0]) == [0]
    assert pattern([0.2, -0.2, 0.2, 0.2]) == [0.2, -0.2, 0.2]
    assert pattern([1.0, 2.0, 3.0]) == [1, 2, 3]


def test_a_ramp_is_one_stretch() -> None:
    supports = [0.0, 50.0, 100.0, 150.0, 200.0]
    ramp = heights_at(5.3, [HeightChange(from_support=2, to_support=4, height=5.0)], supports)
    assert stretches(ramp, supports) == [{"from_support": 2, "to_support": 4, "height": 5}]
    assert stretches([5.3] * 5, supports) == []


def test_stretches_give_any_heights_to_the_last_bit() -> None:
    draw = Random(1)
    for _ in range(200):
        supports = [0.0]
        for _ in range(draw.randint(1, 12)):
            supports.append(supports[-1] + draw.uniform(20, 65))
        heights = [draw.choice([5.3, 5.0, draw.uniform(4.7, 6.5)]) for _ in supports]
        changes = [HeightChange(**change) for change in stretches(heights, supports)]
        assert heights_at(heights[0], changes, supports) == heights
