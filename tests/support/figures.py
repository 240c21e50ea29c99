"""Pictures of the evidence, drawn when records are written."""

from pathlib import Path
from typing import Any

FOLDER = Path(__file__).parents[2] / "docs" / "images" / "validation"
STYLES = ("-", "--", ":", "-.")


def draw(name: str, figure: dict[str, Any]) -> str:
    """Draw curves into an SVG file, the same bytes for the same curves; return the file's name."""
    import matplotlib

    matplotlib.use("svg")
    import matplotlib.pyplot as plt

    # Without a fixed salt and date every drawing would be a change.
    settings = {"svg.hashsalt": "arcless", "svg.fonttype": "none", "font.size": 9}
    with plt.rc_context(settings):
        drawn, axes = plt.subplots(figsize=(6.4, 3.2), layout="constrained")
        for number, (label, (x, y)) in enumerate(figure["curves"].items()):
            axes.plot(x, y, STYLES[number % len(STYLES)], label=label, linewidth=1.2)
        axes.set(xlabel=figure["x"], ylabel=figure["y"])
        axes.set_xscale("log" if figure["log_x"] else "linear")
        axes.set_yscale("log" if figure["log_y"] else "linear")
        axes.grid(alpha=0.3)
        if len(figure["curves"]) > 1:
            axes.legend(frameon=False)
        FOLDER.mkdir(parents=True, exist_ok=True)
        drawn.savefig(FOLDER / f"{name}.svg", metadata={"Date": None})
        plt.close(drawn)
    return f"{name}.svg"
