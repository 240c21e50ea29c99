"""Amounts with units as options of the command line."""


def amount(option: str, text: str, unit: str) -> float:
    """Return the amount of an option in SI.

    Parameters
    ----------
    option
        Its name, for the message.
    text
        As given.
    unit
        SI unit of its kind.

    Raises
    ------
    ModelError
        It is no such amount.
    """
    from arcless.errors import ModelError
    from arcless.units import to_si

    try:
        return to_si(text, unit)
    except ModelError as error:
        error.where = option
        raise
