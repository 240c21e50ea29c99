"""Draw the figure of the README: `python docs/make_figure.py runs/NAME/result.nc FILE.svg`."""

import sys

import arcless
from arcless.figures import paper


def main(result_file: str, figure_file: str) -> None:
    """Draw the first figure of the report."""
    (figure,) = arcless.open(result_file).figures["lead"]
    paper.save(figure, figure_file)


if __name__ == "__main__":
    main(*sys.argv[1:])
