"""Fields of the cover that the program cannot know: author, project, document, who signs."""

from collections.abc import Mapping, Sequence

from arcless.errors import OutputError
from arcless.units import show

# Steps of a document that people sign for; a field of the name says who.
SIGNED = ("prepared", "checked", "approved")
LONGEST_NAME, LONGEST_VALUE, MOST_FIELDS = 40, 300, 20


def parse_fields(texts: Sequence[str]) -> dict[str, str]:
    """Return fields that were typed as ``name=value``; see `check_fields`.

    Raises
    ------
    OutputError
        One has no ``=``, or is there twice; or as `check_fields` says.
    """
    found: dict[str, str] = {}
    for text in texts:
        name, equals, value = (part.strip() for part in text.partition("="))
        if not equals:
            raise OutputError(
                "not a field of the cover",
                where="--field",
                got=show(text),
                expected="name=value",
                hint='--field "author=A. Smith"',
            )
        if name.lower() in (known.lower() for known in found):
            raise OutputError(f"the field {show(name)} is given twice", where="--field")
        found[name] = value
    check_fields(found)
    return found


def check_fields(fields: Mapping[str, str]) -> None:
    """Refuse fields that a cover has no room for.

    Raises
    ------
    OutputError
        A name is empty, a name or a value too long, or there are too many. An empty value is a
        line to be filled in by hand.
    """
    if len(fields) > MOST_FIELDS:
        raise OutputError(
            "too many fields of the cover", got=str(len(fields)), expected=f"{MOST_FIELDS} at most"
        )
    for name, value in fields.items():
        for what, text, least, most in (
            ("name", name, 1, LONGEST_NAME), ("value", value, 0, LONGEST_VALUE),
        ):  # fmt: skip
            if not isinstance(text, str) or len(text.strip()) < least or len(text) > most:
                raise OutputError(
                    f"wrong {what} of a field of the cover",
                    where=str(name)[:LONGEST_NAME],
                    got=show(text) if len(str(text)) <= most else f"{len(text)} letters",
                    expected=f"a text of {least} to {most} letters",
                )


def of(fields: Mapping[str, str], name: str) -> str:
    """Return the value of a field, whatever the case of its name; empty for none."""
    return next((v for key, v in fields.items() if key.lower() == name), "")


def shown(fields: Mapping[str, str]) -> list[tuple[str, str]]:
    """Return label and value of the fields in the list of the cover: all but who signs."""
    return [
        (key[:1].upper() + key[1:], value)
        for key, value in fields.items()
        if key.lower() not in SIGNED
    ]


def signatures(fields: Mapping[str, str]) -> list[tuple[str, str]]:
    """Return the steps that are signed for, and who does.

    The author has prepared a document unless a field says who did, or leaves that blank.
    """
    names = {step: of(fields, step) for step in SIGNED}
    if "prepared" not in map(str.lower, fields):
        names["prepared"] = of(fields, "author")
    return [(step.capitalize(), name) for step, name in names.items()]
