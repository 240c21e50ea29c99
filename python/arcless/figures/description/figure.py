"""A figure: title, caption, alternative text, two axes, layers from below upwards."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from arcless.figures.description.layers import Layer

HEIGHT = 290  # px of a page, of which a centimetre on paper has 38


@dataclass(frozen=True)
class Axis:
    """One axis.

    Attributes
    ----------
    label, unit
        Name and unit of the quantity; both stand at the axis.
    low, high
        Ends of the range shown first; None for an end that follows from the data.
    bounds
        Range that a reader cannot leave; None for no such range.
    logarithmic
        True for a logarithmic axis.
    categories
        Names along the axis in place of numbers, the first at 0, each 1 further; places with an
        empty name have no mark. Empty for numbers.
    group
        Figures whose axes have the same group show the same range, and are zoomed together. Empty
        for an axis of its own.
    form
        Decimals of the numbers along the axis, as in ``"0.00"``. Empty where the medium may choose.
    """

    label: str
    unit: str = ""
    low: float | None = None
    high: float | None = None
    bounds: tuple[float, float] | None = None
    logarithmic: bool = False
    categories: tuple[str, ...] = ()
    group: str = ""
    form: str = ""

    @property
    def title(self) -> str:
        """Label and unit, as they stand at the axis."""
        return f"{self.label}, {self.unit}" if self.unit else self.label


@dataclass(frozen=True)
class Scale:
    """A scale of colours: from `low` to `high` of a quantity in the order of a token.

    Attributes
    ----------
    label, unit
        Name and unit of the quantity that is shown by colour.
    low, high
        Values of the first and of the last colour.
    colours
        Token of the order of colours: ``"sequential"`` or ``"diverging"``.
    under
        Token of the colour of values below `low`, with its meaning in `under_label`; empty for
        the first colour.
    """

    label: str
    unit: str
    low: float
    high: float
    colours: str = "sequential"
    under: str = ""
    under_label: str = ""

    @property
    def title(self) -> str:
        """Label and unit, as they stand at the scale."""
        return f"{self.label}, {self.unit}" if self.unit else self.label


@dataclass(frozen=True, eq=False)
class Figure:
    """A figure, whatever draws it.

    Attributes
    ----------
    key
        Name of the figure in a page, in addresses and files: lower-case words with hyphens.
    title
        What is shown.
    x, y
        The axes.
    layers
        Contents, the lowest first.
    caption
        How it is read, in sentences; empty for nothing beyond the title.
    alt
        What it shows, in words for those who do not see it: the quantity and its main numbers.
    height
        In px of a page.
    scale
        The scale of colours of layers that have one.
    """

    key: str
    title: str
    x: Axis
    y: Axis
    layers: Sequence["Layer"] = field(default=())
    caption: str = ""
    alt: str = ""
    height: int = HEIGHT
    scale: Scale | None = None
