"""Lines of a table in which what was reached stands beside its limit."""

HEAD = ("what", "limit", "reached", "met", "and")


def most(what: str, limit: float, reached: float, unit: str, more: str = "") -> list[str]:
    """Return the line of a number that must not be above its limit."""
    met = "yes" if reached <= limit else "**no**"
    return [what, f"≤ {limit:g} {unit}", _shown(reached, unit), met, more]


def least(what: str, limit: float, reached: float, unit: str, more: str = "") -> list[str]:
    """Return the line of a number that must not be below its limit."""
    met = "yes" if reached >= limit else "**no**"
    return [what, f"≥ {limit:g} {unit}", _shown(reached, unit), met, more]


def told(what: str, reached: float, unit: str, more: str = "") -> list[str]:
    """Return the line of a number without a limit."""
    return [what, "", _shown(reached, unit), "", more]


def _shown(value: float, unit: str) -> str:
    # Three digits, and no powers of ten.
    return f"{f'{value:.0f}' if value >= 100.0 else f'{value:.3g}'} {unit}"
