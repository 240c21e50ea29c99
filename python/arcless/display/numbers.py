"""Numbers as text."""


def real_minus(text: str) -> str:
    """Return the text of a number with a real minus sign for a hyphen."""
    return text.replace("-", "−")


def number(value: float | None, decimals: int = 1) -> str:
    """Return a number with a real minus sign, zero without one, a dash when there is none."""
    if value is None:
        return "–"
    return real_minus(f"{value:z.{decimals}f}")


def signed(value: float | None, decimals: int = 1) -> str:
    """Return a number with its sign, plus or a real minus; zero has none."""
    text = number(value, decimals)
    if value is None or not any(digit in text for digit in "123456789"):
        return text
    return text if text.startswith("−") else f"+{text}"


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
