"""Tables as data frames of pandas, with the units of their columns."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from arcless.errors import OutputError
from arcless.storage.csv_files import Column
from arcless.units import show

if TYPE_CHECKING:
    import pandas

Tables = Mapping[str, Callable[[], Sequence[Column]]]


def frame(tables: Tables, name: str, index: str | None = None) -> "pandas.DataFrame":
    """Return one of several tables as a data frame.

    Parameters
    ----------
    tables
        How each table is made, by name.
    name
        Of the table that is asked for.
    index
        Name of the column that becomes the index; without it rows are numbered from 0.

    Returns
    -------
    pandas.DataFrame
        Columns are named as in exported files, ``time [s]``; `attrs["units"]` has their units.

    Raises
    ------
    OutputError
        There is no such table.
    """
    if name not in tables:
        known = " or ".join(f"`{one}`" for one in tables)
        raise OutputError("unknown table", got=show(name), expected=known)
    import pandas

    columns = tables[name]()
    made = pandas.DataFrame({column.header: column.values for column in columns})
    # A column that is None all over would be none of numbers.
    made = made.astype({column.header: float for column in columns if column.unit})
    made.attrs["units"] = {column.header: column.unit for column in columns}
    if index is None:
        return made
    return made.set_index(next(one.header for one in columns if one.name == index))
