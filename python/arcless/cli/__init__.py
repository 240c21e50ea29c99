"""The command line: arguments in, text and exit codes out; no physics here."""

import sys

from arcless.cli.process import interrupts, start

__all__ = ["main"]


def main() -> None:
    """Run the command `arcless` and leave with its exit code."""
    start.open_missing_streams()
    interrupts.merge_signals()
    start.claim_process()
    try:
        with start.permanent_objects():
            from arcless.cli.app import app
            from arcless.cli.completion import scripts

        scripts.listen()

        app(prog_name="arcless")
    except KeyboardInterrupt:  # while the commands themselves are still being imported
        print(interrupts.word(), file=sys.stderr)  # noqa: T201 - the console is not there yet
        sys.exit(interrupts.exit_code(1))
    finally:
        interrupts.ignore()
