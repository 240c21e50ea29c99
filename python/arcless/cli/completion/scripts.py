"""`arcless completion`: what a shell is told once, and its questions afterwards.

The protocol is that of Typer: the shell calls `arcless` with `_ARCLESS_COMPLETE=complete_SHELL` and
the words typed so far. Other than by Typer's own scripts, errors are never seen.
"""

import os
from typing import Annotated, Literal

import typer

from arcless.cli.terminal import console

VARIABLE = "_ARCLESS_COMPLETE"
_SCRIPTS = {
    "bash": """\
_arcless_completion() {
    local IFS=$'\\n'
    COMPREPLY=($(COMP_WORDS="${COMP_WORDS[*]}" COMP_CWORD=$COMP_CWORD \\
        _ARCLESS_COMPLETE=complete_bash "$1" 2>/dev/null))
}
complete -o default -F _arcless_completion arcless""",
    "zsh": """\
#compdef arcless
_arcless_completion() {
    eval $(_TYPER_COMPLETE_ARGS="${words[1,$CURRENT]}" \\
        _ARCLESS_COMPLETE=complete_zsh arcless 2>/dev/null)
}
if [ "$funcstack[1]" = "_arcless" ]; then
    _arcless_completion "$@"
else
    compdef _arcless_completion arcless
fi""",
    "fish": """\
function _arcless_completion
    set -lx _ARCLESS_COMPLETE complete_fish
    set -lx _TYPER_COMPLETE_FISH_ACTION $argv[1]
    set -lx _TYPER_COMPLETE_ARGS (commandline -cp)
    arcless 2>/dev/null
end
complete --command arcless --no-files --arguments "(_arcless_completion get-args)" \\
    --condition "_arcless_completion is-args\"""",
}


def completion(
    shell: Annotated[
        Literal["bash", "zsh", "fish"],
        typer.Argument(metavar="SHELL", help="bash, zsh or fish.", show_default=False),
    ],
) -> None:
    """Print the script for completion in a shell.

    The tab key then completes commands, options, and names of shipped models, runs and studies.

    bash, a line in ~/.bashrc: eval "$(arcless completion bash)"

    zsh, a line in ~/.zshrc below compinit: eval "$(arcless completion zsh)"

    fish, once: arcless completion fish > ~/.config/fish/completions/arcless.fish
    """
    console.data(_SCRIPTS[shell])


def listen() -> None:
    """Get ready to answer a shell where one asks."""
    if VARIABLE in os.environ:
        from typer.completion import get_completion_inspect_parameters

        get_completion_inspect_parameters()  # makes the shells known to Typer, which it needs first
