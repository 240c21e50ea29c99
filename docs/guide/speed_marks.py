"""The marks of the shipped sweep of speed, for its guide."""

from validation.runs import table

from arcless.simulate import ResonanceSpeeds, resonance_speeds
from arcless.study import load

STUDY = "speed-sweep"


def told() -> ResonanceSpeeds:
    return resonance_speeds(load(STUDY).base)


def speeds_kmh() -> list[float]:
    """Return the speeds of the study."""
    plan = load(STUDY).plan
    return [3.6 * plan.values(number)[0] for number in range(plan.count)]


def marks(speeds: ResonanceSpeeds, low: float, high: float) -> str:
    """Return the marks between two speeds in km/h."""
    rows = []
    for one in speeds.speeds:
        middle = 3.6 * one.speed.middle
        if low <= middle <= high:
            band = f"{3.6 * one.speed.low:.0f} to {3.6 * one.speed.high:.0f}"
            band = band if one.speed.low < one.speed.high else "–"
            f = "–" if one.frequency_Hz is None else f"{one.frequency_Hz:.2f}"
            rows.append((f"{middle:.0f}", band, f"{one.kind}: {one.name}", f))
    return table(("speed, km/h", "band, km/h", "what", "f, Hz"), rows)


def of_the_study() -> str:
    """Return the marks within the speeds of the study."""
    varied = speeds_kmh()
    return marks(told(), min(varied), max(varied))


QUICK = {"speed-sweep": {"marks": of_the_study}}
