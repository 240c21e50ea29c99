"""Shipped models as they stand, and copies of them to begin a model of one's own with."""

import os
import re
from collections.abc import Mapping
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from arcless.errors import ModelError, OutputError
from arcless.model.edit import change
from arcless.model.files.yaml_reader import is_file, parse, read_text
from arcless.model.second_pantograph import with_second
from arcless.model.shipped.library import RENAMED, find, shipped
from arcless.model.shipped.wire_catalogue import entry_text
from arcless.platforms.file_names import refused_by_windows
from arcless.storage.whole_files import check_writable, write_bytes
from arcless.units import show

KINDS = ("scenario", "line", "pantograph", "study")
SCHEMA = "arcless.schema.json"
HEADER = f"# yaml-language-server: $schema={SCHEMA}\n"
_SUFFIXES = {".yaml", ".yml", ".json"}


def text_of(source: str) -> str:
    """Return the text of a shipped model, or of a file, as it stands.

    A name that a scenario and a line or a pantograph share is that of the scenario;
    ``line/NAME`` and the like mean the other ones. A wire of the catalogue is its entry there.

    Raises
    ------
    ModelError
        There is no such model or file, or it is none of Arcless.
    """
    file = _shipped_file(source)
    path = Path(source) if file is None else file
    if file is None and path.suffix not in _SUFFIXES and not is_file(path):
        entry = entry_text(source.removeprefix("wire/"))
        if entry is None:
            raise _unknown(source, KINDS)
        return entry
    text = read_text(path, str(path) if file is None else source)
    if file is None:
        given = parse(text, source)[0].get("format")
        if not (isinstance(given, str) and given.startswith("arcless-")):
            expected = ", ".join(f"arcless-{kind}/1" for kind in KINDS)
            got = "none" if given is None else show(given)
            raise ModelError("format", where=source, got=got, expected=expected)
    return text


def copies(
    name: str,
    source: str,
    *,
    with_pantographs: bool = False,
    two_pantographs: str | None = None,
    scenario: str | None = None,
) -> dict[str, str]:
    """Return the files of a model of one's own, text by name of file.

    Of a scenario these are the scenario and its line, which the scenario then refers to. Comments,
    order and sources stay. The description is a new one: that of the shipped model would be on the
    cover of reports, and untrue as soon as a value is changed.

    Parameters
    ----------
    name
        The new name, which is that of the first file too.
    source
        The name of a shipped scenario, line, pantograph or study; see `text_of`.
    with_pantographs
        Also copy the scenario's pantographs.
    two_pantographs
        Distance behind the first pantograph of a second one like it, see `with_second`; no second
        one without.
    scenario
        Scenario of a study, by shipped name or by file relative to the copy; as in the source
        without.

    Raises
    ------
    ModelError
        The name is none that a file could have, or is that of a shipped model; the source is none,
        or of another kind than asked for; the pantographs do not fit on the line.
    """
    _check_name(name)
    kind, file = _of_source(source)
    _check_options(kind, source, {
        "--with-pantographs": ("scenario", with_pantographs),
        "--two-pantographs": ("scenario", two_pantographs is not None),
        "--scenario": ("study", scenario is not None),
    })  # fmt: skip
    given = read_text(file, source)
    if two_pantographs is not None:
        given = with_second(given, two_pantographs, source, file)
    given = _renamed(given, kind, name, source)
    if scenario is not None:
        given = change(given, "scenario", scenario, source).apply(given)
    made = {f"{name}.yaml": given}
    if kind != "scenario":
        return {file: HEADER + text for file, text in made.items()}
    data = parse(made[f"{name}.yaml"], source)[0]
    references: dict[str, str] = {}
    made |= _copied("line", data["line"], f"{name}-line", references, "line")
    if with_pantographs:
        for index, item in enumerate(data["pantographs"]):
            new, place = f"{name}-{item['model']}", f"pantographs.{index}.model"
            made |= _copied("pantograph", item["model"], new, references, place)
    for path, target in references.items():
        first = made[f"{name}.yaml"]
        made[f"{name}.yaml"] = change(first, path, target, source).apply(first)
    return {file: HEADER + text for file, text in made.items()}


def write_copies(folder: Path, files: Mapping[str, str], schema: str) -> list[Path]:
    """Write files of `copies`, and the schema where there is none yet; nothing is replaced.

    Raises
    ------
    OutputError
        One of the files exists, or the folder cannot be written; no file is left behind.
    """
    for file in files:
        if os.path.lexists(folder / file):
            raise OutputError(
                "the file exists",
                where=str(folder / file),
                expected="a new name: `arcless new` replaces nothing",
                hint="choose another name, or another folder with --to",
            )
    content = dict(files)
    if not os.path.lexists(folder / SCHEMA):
        content[SCHEMA] = schema
    written: list[Path] = []
    try:
        for file, text in content.items():
            check_writable(folder / file)
            write_bytes(folder / file, text.encode())
            written.append(folder / file)
    except BaseException:
        for path in written:
            path.unlink(missing_ok=True)
        raise
    return written


def _copied(
    kind: str, given: Any, new: str, references: dict[str, str], place: str
) -> dict[str, str]:
    """Return the copy of a model that the scenario refers to, and note the new reference."""
    file = find(kind, given) if isinstance(given, str) else None
    if file is None:  # written in the scenario itself, and copied with it
        return {}
    references[place] = f"{new}.yaml"
    return {f"{new}.yaml": _renamed(read_text(file, given), kind, new, given)}


def _renamed(text: str, kind: str, name: str, source: str) -> str:
    """Return a text with a new name, and with a description that states no more than its origin."""
    changes = {"name": name}
    if "description" in parse(text, source)[0]:
        changes["description"] = f"Own {kind} after {source.rpartition('/')[2]}, to be described"
    for field, value in changes.items():
        text = change(text, field, value, source).apply(text)
    return text


def _check_options(kind: str, source: str, options: Mapping[str, tuple[str, bool]]) -> None:
    """Refuse options that are given and belong to another kind of model."""
    for option, (own, is_given) in options.items():
        if is_given and kind != own:
            raise ModelError(option, got=f"{kind} {source}", expected=f"a {own}",
                             hint=f"leave {option} out, or begin with a {own}")  # fmt: skip


def _check_name(name: str) -> None:
    expected = "letters, digits, `-`, `_` and `.`, beginning with a letter or digit"
    if not re.fullmatch(r"\w[\w.-]{0,99}", name) or Path(name).suffix in _SUFFIXES:
        hint = "leave the ending out; --to names a folder" if Path(name).suffix else None
        hint = "--to names a folder" if "/" in name else hint
        raise ModelError("name", got=show(name), expected=expected, hint=hint)
    if (trouble := refused_by_windows(f"{name}.yaml")) is not None:
        raise ModelError("name", got=trouble, expected="a name for files of every system",
                         hint=f"such as my-{name}")  # fmt: skip
    taken = [kind for kind in KINDS if name in shipped(kind) or name in RENAMED.get(kind, {})]
    if taken:
        expected = "a name that no shipped model has"
        raise ModelError("name", got=f"that of a shipped {taken[0]}, {name}", expected=expected,
                         hint=f"such as my-{name}")  # fmt: skip


def _of_source(source: str) -> tuple[str, Path]:
    kind, _, name = source.rpartition("/")
    for own in KINDS:
        if kind in ("", own) and (file := find(own, name)):
            return own, file
    if is_file(Path(source)):
        raise ModelError("no model to begin with", got=f"the file {source}",
                         expected="the name of a shipped model",
                         hint="a file of your own is copied by the system")  # fmt: skip
    raise _unknown(source, KINDS)


def _shipped_file(source: str) -> Path | None:
    kind, _, name = source.rpartition("/")
    found = (find(own, name) for own in KINDS if kind in ("", own))
    return next((file for file in found if file is not None), None)


def _unknown(source: str, kinds: tuple[str, ...]) -> ModelError:
    """Say which names are near to one that nothing has."""
    known = {name: kind for kind in kinds for name in shipped(kind)}
    close = get_close_matches(source.rpartition("/")[2], known, n=3, cutoff=0.5)
    meant = f"did you mean {' or '.join(close)}?" if close else "arcless library lists the names"
    what = ", ".join(kinds[:-1]) + f" or {kinds[-1]}" if len(kinds) > 1 else kinds[0]
    return ModelError("unknown model", got=show(source), expected=f"a shipped {what}", hint=meant)
