"""Fields of the cover: as they were typed, in their order, or refused with a sentence."""

import pytest

from arcless.errors import OutputError
from arcless.report.paper.fields import check_fields, parse_fields, shown, signatures


def test_fields_stay_in_order_and_may_hold_equals_signs() -> None:
    found = parse_fields(["project = Line 7", "author=A. Smith", "note=a=b", "checked=B. Jones"])
    assert shown(found) == [("Project", "Line 7"), ("Author", "A. Smith"), ("Note", "a=b")]
    assert signatures(found) == [
        ("Prepared", "A. Smith"), ("Checked", "B. Jones"), ("Approved", "")
    ]  # fmt: skip


def test_who_prepared_it_need_not_be_the_author() -> None:
    assert signatures({"author": "A", "Prepared": "P"})[0] == ("Prepared", "P")


def test_an_empty_value_leaves_the_line_blank() -> None:
    found = parse_fields(["author=A", "prepared=", "approved=", "order = "])
    assert shown(found) == [("Author", "A"), ("Order", "")]
    assert signatures(found) == [("Prepared", ""), ("Checked", ""), ("Approved", "")]


@pytest.mark.parametrize(
    ("texts", "told"),
    [
        (["author"], "expected name=value"),
        (["=A. Smith"], "expected a text of 1 to 40 letters"),
        (["author=A", "Author=B"], "given twice"),
        ([f"author={'x' * 301}"], "expected a text of 0 to 300 letters"),
        ([f"f{k}=x" for k in range(21)], "expected 20 at most"),
    ],
)
def test_refused(texts: list[str], told: str) -> None:
    with pytest.raises(OutputError, match=told):
        parse_fields(texts)


def test_values_of_python_are_texts() -> None:
    with pytest.raises(OutputError, match="got 7"):
        check_fields({"author": 7})  # type: ignore[dict-item]
