"""Places of files that are named on the command line."""

from pathlib import Path

from arcless.storage.endings import check_ending


def check_place(file: Path, suffix: str, option: str) -> None:
    """Refuse a file that could not be written after the computing, before it."""
    from arcless.storage.whole_files import check_writable

    hint = f"this is the only form that `{option}` writes; a browser can print it"
    check_ending(file, (suffix,), f"not a {suffix} file", hint=hint)
    check_writable(file)
