"""Messages in words of the page: no option of the command line is left in what the studio tells."""

import ast
import re
from pathlib import Path

import arcless
from arcless.errors import OutputError
from arcless.studio.answers.answers import complaint
from arcless.studio.answers.page_words import in_page_words

PACKAGE = Path(arcless.__file__).parent
# Where errors come from that a page is told: of output folders, of studies, of measured runs.
# Others are of commands that the studio has not, such as tables of lines and exports of trials.
TOLD = ["storage", "results", "study", "comparison", "measurements"]
# Words of commands themselves, what files and pages of results say, and a sentence that is put
# together from parts, which `test_a_study_that_was_begun` has.
OTHERS = re.compile(
    r"^--[a-z-]+( \w+)?$|arcless (study \w+|run|compare) |^choose another file with `--to`$"
    r"|^NAME with"
)
OPTION = re.compile(r"(?<![\w-])--[a-z]")


def texts() -> list[str]:
    """Return the literals of these rooms that name an option, those of an f-string joined."""
    found = []
    for file in (path for room in TOLD for path in (PACKAGE / room).rglob("*.py")):
        tree = ast.parse(file.read_text("utf-8"))
        docs = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
        inside = {id(part) for node in ast.walk(tree) if isinstance(node, ast.JoinedStr)
                  for part in node.values}  # fmt: skip
        for node in ast.walk(tree):
            if isinstance(node, ast.JoinedStr):
                parts = [str(part.value) if isinstance(part, ast.Constant) else "NAME"
                         for part in node.values]  # fmt: skip
                found.append("".join(parts))
            elif isinstance(node, ast.Constant) and id(node) not in docs | inside:
                found.append(str(node.value))
    return [text for text in found if OPTION.search(text)]


def test_no_option_is_left() -> None:
    all_ = [text for text in texts() if not OTHERS.search(text)]
    assert len(all_) > 10
    left = [text for text in all_ if OPTION.search(in_page_words(text))]
    assert left == []


def test_a_study_that_was_begun() -> None:
    for todo in ("choose another folder", "see it, or restart"):
        words = in_page_words(f"{todo} with `--out NEW_FOLDER`")
        assert words.endswith("another name")


def test_all_parts_of_a_complaint() -> None:
    error = OutputError(
        "the folder of the study cannot be made", where="runs/a", got="Permission denied",
        hint="choose another one with `--out`",
    )  # fmt: skip
    told = complaint(error)
    hint = "give it another name, or open the studio on another folder"
    assert told["hint"] == hint
    assert told["text"].endswith(f"got Permission denied; hint: {hint}")
