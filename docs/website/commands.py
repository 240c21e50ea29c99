"""Options of every command, as the program has them."""

import re
from collections.abc import Iterator
from typing import Any

import typer.main

from arcless.cli.app import app

PAGE = "reference/commands.md"


def pages() -> dict[str, str]:
    """Return what the site has more on its page of commands."""
    root = typer.main.get_command(app)
    parts = ["## Options", ""]
    for words, command in sorted(_commands(root, ("arcless",)), key=lambda entry: entry[0]):
        parts += [*_command(words, command), ""]
    return {PAGE: "\n".join(parts)}


def _commands(command: Any, words: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], Any]]:
    """Yield all commands below one, with their words."""
    for name, below in getattr(command, "commands", {}).items():
        if not below.hidden:
            yield from _commands(below, (*words, name))
    if not getattr(command, "commands", {}):
        yield words, command


def _command(words: tuple[str, ...], command: Any) -> Iterator[str]:
    """Yield the section of a command: how it is called, what it does, its options."""
    context = command.make_context(" ".join(words), [], resilient_parsing=True)
    usage = " ".join(command.collect_usage_pieces(context))
    yield f"### `{' '.join(words)}`\n"
    yield f"```text\n{' '.join(words)} {usage}\n```\n"
    yield f"{escaped(command.help or '')}\n"
    records = [one.get_help_record(context) for one in command.get_params(context)]
    # Arguments have the type of Python behind their name.
    rows = [(re.sub(r" <.*>$", "", name), text) for name, text in filter(None, records)]
    yield "| option | does |"
    yield "|---|---|"
    for name, text in rows:
        if name != "--help":
            yield f"| {escaped(f'`{name}`')} | {escaped(' '.join(text.split()))} |"


def escaped(text: str) -> str:
    """Return plain text as Markdown shows it: what stands in backticks is code."""
    parts = text.split("`")
    for place in range(0, len(parts), 2):
        for sign in "\\*_[]<>|$":
            parts[place] = parts[place].replace(sign, f"\\{sign}")
    return "`".join(part.replace("|", "\\|") if i % 2 else part for i, part in enumerate(parts))
