"""An assessment as tables: columns for files and data frames, a card for notebooks."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from typing import TYPE_CHECKING, Any

from arcless.assess.criteria import (
    MET,
    NOT_JUDGED,
    NOT_MET,
    NOT_MET_UNVERIFIED,
    RELATION_SIGNS,
    TOO_CLOSE,
    Criterion,
    allowance,
    decimals_of,
    is_withheld,
    shown_verdict,
    uncertainty_of,
    verdict_of,
)
from arcless.assess.quantities import OF_LINE, OF_PANTOGRAPH, QUANTITIES, WEAR, label_of
from arcless.assess.rules import decides
from arcless.display import cards
from arcless.display.frames import frame
from arcless.display.numbers import number, pair
from arcless.storage.csv_files import Column

if TYPE_CHECKING:
    import pandas

# Verdict on a criterion → state of a page on which it is the least favourable, and its headline.
_HEADLINES: Mapping[str, tuple[cards.State, str]] = {
    NOT_MET: ("missed", "Not met"),
    NOT_MET_UNVERIFIED: ("open", "Beyond a limit that is not verified"),
    TOO_CLOSE: ("open", "Too close to tell"),
    MET: ("met", "Met"),
    NOT_JUDGED: ("open", "Not judged"),
}
# Words for a number of criteria with a verdict, where they are not the verdict itself.
_REST = {NOT_MET_UNVERIFIED: "beyond a limit that is not verified"}


@dataclass(frozen=True)
class Headline:
    """Verdict over all criteria: its state, a sentence, how many have which other verdict."""

    state: cards.State
    text: str
    rest: str


def headline(criteria: Sequence[Criterion]) -> Headline:
    """Return the least favourable verdict on some criteria, and how many have which.

    Where a number could have been compared with its limit and is not judged, they are not met.
    """
    verdicts = [verdict_of(asdict(one)) for one in criteria]
    counts = {word: verdicts.count(word) for word in _HEADLINES}
    withheld = any(is_withheld(asdict(one)) for one in criteria)
    usual = (word for word in _HEADLINES if counts[word] and not (withheld and word == MET))
    word = next(usual, NOT_JUDGED)
    state, title = _HEADLINES[word]
    total = len(criteria)
    share = f"all {total}" if counts[word] == total else f"{counts[word]} of {total}"
    unsure = _against_unverified(criteria)
    rest = [f"{count} {_REST.get(other, other)}{unsure if other == MET else ''}"
            for other, count in counts.items() if other != word and count]  # fmt: skip
    text = f"{title}: {share} criteria{unsure if word == MET else ''}"
    return Headline(state, text, "; ".join(rest))


def _against_unverified(criteria: Sequence[Criterion]) -> str:
    """Return how many of the criteria that are met have a limit that decides nothing, in words."""
    met = [one for one in criteria if verdict_of(asdict(one)) == MET]
    count = sum(not decides(one.mark) for one in met)
    if not count:
        return ""
    limits = "an unverified limit" if count == 1 else "unverified limits"
    return f", {count} of them against {limits}" if len(met) > 1 else f" against {limits}"


def quantity_columns(told: Mapping[str, Any]) -> list[Column]:
    """Return the quantities, one in a row: key, name, unit, each pantograph, the whole run.

    Parameters
    ----------
    told
        The assessment as plain data.
    """
    parts = [*told["pantographs"], told]
    keys = [key for key in QUANTITIES if any(key in part for part in parts)]
    names = [*(f"pantograph {one['name']}" for one in told["pantographs"]), "run"]
    return [
        Column("key", "", keys),
        Column("quantity", "", [_label(told, key) for key in keys]),
        Column("unit", "", [QUANTITIES[key].unit for key in keys]),
        *(
            Column(name, "", [part.get(key) for key in keys])
            for name, part in zip(names, parts, strict=True)
        ),
    ]


def criterion_columns(told: Mapping[str, Any]) -> list[Column]:
    """Return the criteria, one in a row, with value, limit, verdict, reason, source, mark."""
    found = told["criteria"]
    keys = list(dict.fromkeys(key for one in found for key in one))
    return [Column(key, "", [_plain(one.get(key)) for one in found]) for key in keys]


def data_frame(told: Mapping[str, Any], table: str) -> "pandas.DataFrame":
    """Return a table of an assessment, given as plain data; see `Assessment.to_dataframe`."""
    tables = {
        "quantities": lambda: quantity_columns(told),
        "criteria": lambda: criterion_columns(told),
    }
    return frame(tables, table, "key" if table == "quantities" else "name")


def card(told: Mapping[str, Any], over_all: Headline) -> str:
    """Return the assessment as HTML: verdict, criteria, and folded away numbers and notes.

    Parameters
    ----------
    told
        The assessment as plain data.
    over_all
        Its headline.
    """
    return cards.card(title_of(told), *parts(told, over_all))


def parts(told: Mapping[str, Any], over_all: Headline) -> list[str]:
    """Return the parts of `card` below its title."""
    titles = ("criterion", "for", "value", "limit", "unit", "verdict", "mark")
    made = [
        cards.verdict(cards.Badge(over_all.state, over_all.text), over_all.rest),
        cards.table(titles, [_criterion(one) for one in told["criteria"]],
                    numbers=("value", "limit")),
        cards.folded("Numbers", _numbers(told)),
    ]  # fmt: skip
    notes = [f"{one['title']}: {one['reason']}" for one in told["criteria"] if one["reason"]]
    notes += told["notes"]
    if notes:
        made.append(cards.folded("Notes", cards.listed(list(dict.fromkeys(notes)))))
    return made


def title_of(told: Mapping[str, Any]) -> str:
    """Return scenario and speed in words."""
    stop = told.get("stopped_m")
    stopped = "" if stop is None else f", stopped early at {stop:.1f} m"
    return f"{told['scenario']} at {3.6 * told['speed_m_s']:.4g} km/h{stopped}"


def _badge(one: Mapping[str, Any]) -> cards.Cell:
    found = badge_of(verdict_of(one))
    return replace(found, text=shown_verdict(one)) if isinstance(found, cards.Badge) else found


def badge_of(words: str) -> cards.Cell:
    """Return the cell of a verdict on a criterion, given in words."""
    return words if words == NOT_JUDGED else cards.Badge(_HEADLINES[words][0], words)


def _criterion(one: Mapping[str, Any]) -> list[cards.Cell]:
    decimals = decimals_of(one)
    limit = number(one["limit"], decimals)
    return [
        one["title"],
        one["pantograph"] or "run",
        pair(one["value"], uncertainty_of(one.get("certainty")), decimals),
        "–"
        if one["limit"] is None
        else f"{RELATION_SIGNS[one['relation']]} {limit}{allowance(one)}",
        one["unit"].replace("1", ""),
        _badge(one),
        one["mark"],
    ]


def _numbers(told: Mapping[str, Any]) -> str:
    names = [one["name"] for one in told["pantographs"]]
    worn = next(iter(WEAR)) in told["pantographs"][0]
    rows = [
        [_label(told, key), quantity.unit,
         *(_number(one, key, quantity.decimals) for one in told["pantographs"])]
        for key, quantity in {**OF_PANTOGRAPH, **(WEAR if worn else {})}.items()
    ]  # fmt: skip
    rows += [
        [_label(told, key), quantity.unit, _number(told, key, quantity.decimals),
         *[""] * (len(names) - 1)]
        for key, quantity in OF_LINE.items()
    ]  # fmt: skip
    return cards.table(("quantity", "unit", *names), rows, numbers=names)


def _number(of: Mapping[str, Any], key: str, decimals: int) -> str:
    return pair(of.get(key), uncertainty_of((of.get("certainty") or {}).get(key)), decimals)


def _label(told: Mapping[str, Any], key: str) -> str:
    bands = {name: told[name] for name in ("low_pass_Hz", "band_split_Hz")}
    return label_of(key, **bands)


def _plain(value: Any) -> Any:
    """Return a value that fits a cell: lists and mappings as text."""
    return str(value) if isinstance(value, list | dict) else value
