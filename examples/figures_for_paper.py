"""Figures of a run for a paper: whole ones, and two of them in a figure of one's own.

Run it with ``python examples/figures_for_paper.py``; it needs ``arcless[plots]``, takes a few
seconds and writes into ``runs/``.
"""

from pathlib import Path

from matplotlib.figure import Figure

import arcless
from arcless.figures import paper


def main(folder: Path = Path("runs/figures"), name: str = "en50318-ac-simple-320") -> None:
    """Run a scenario; write its first figure, one for a column, and one of two parts."""
    result = arcless.run(arcless.load(name))
    folder.mkdir(parents=True, exist_ok=True)

    # Every figure of the report by its key; a key has one for each pantograph, or none.
    for key, figures in result.figures.items():
        print(f"{key:<16}", ", ".join(figure.title for figure in figures) or "none in this run")

    # A file: SVG, PDF or PNG, as wide as the text of an A4 page or one of its two columns.
    (lead,) = result.figures["lead"]
    paper.save(lead, folder / "lead.svg")
    (spectrum,) = result.figures["spectrum"]
    paper.save(spectrum, folder / "spectrum.pdf", width_mm=paper.COLUMN_MM)

    # Axes of one's own, and whatever matplotlib can do to them.
    drawing = Figure(figsize=(6.3, 6.0), layout="constrained")
    above, below = drawing.subplots(2, 1, sharex=True)
    result.plot("force", above)
    result.plot("uplift", below)
    above.set(title="", xlabel="", xlim=result.assessment.section_m)
    drawing.savefig(folder / "two.png", dpi=200)


if __name__ == "__main__":
    main()
