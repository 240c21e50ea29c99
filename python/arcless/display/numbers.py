"""Numbers as text."""


def number(value: float | None, decimals: int = 1) -> str:
    """Return a number with a real minus sign, zero without one, a dash when there is none."""
    if value is None:
        return "–"
    return f"{value:z.{decimals}f}".replace("-", "−")


def pair(value: float | None, uncertainty: float | None, decimals: int) -> str:
    """Return a number with the text after its ±, where there is any that its decimals show."""
    text = number(value, decimals)
    sure = number(uncertainty, decimals)
    return text if uncertainty is None or not float(sure) else f"{text} ± {sure}"


def difference(one: float | None, other: float | None, decimals: int) -> str:
    """Return the difference of two numbers as they are printed, so that a reader finds it again."""
    if one is None or other is None:
        return number(None)
    return number(round(one, decimals) - round(other, decimals), decimals)
