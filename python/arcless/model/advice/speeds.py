"""Speeds compared with the contact wire's wave speed: refused, warned of, or a missing unit."""

from typing import TYPE_CHECKING

from arcless.errors import ModelError
from arcless.units import written_in

if TYPE_CHECKING:
    from arcless.model.scenario.scenario import Scenario

KMH = 3.6
# EN 50119:2009, 5.2.4: speed at most 70 % of the wave speed of the contact wire.
WAVE_SPEED_SHARE = 0.70
# Beyond the wave speed a run can be asked for to see what happens there. A whole number of m/s that
# far beyond it is one in km/h without its unit.
SUPERCRITICAL = 1.25
# Lines in service have 380 to 570 km/h; much less is a tension in another unit. In m/s.
SLOW_WAVES = 200.0 / KMH


def check_typed_speed(scenario: "Scenario") -> None:
    """Refuse a speed typed without its unit that is far beyond the wave speed of the contact wire.

    Asked by the command line, where it saves a run; from Python, and of a stored scenario, a number
    is in m/s by right, and a warning says how fast that is.

    Raises
    ------
    ModelError
        The speed looks like one in km/h.
    """
    speed, wave = scenario.top_speed, scenario.line.wave_speed
    typed = scenario.as_typed("speed")
    bare = scenario.speed is not None and (typed is None or written_in(typed, "m/s") is None)
    if not bare or wave is None or speed <= SUPERCRITICAL * wave:
        return
    meant = _meant(scenario)
    if not meant:
        return
    raise ModelError(
        "a speed far beyond the wave speed of the contact wire",
        got=f"{speed:g} m/s ({speed * KMH:.0f} km/h), {speed / wave:.0%} of {wave * KMH:.0f} km/h",
        expected="a speed with its unit",
        hint=f"{meant}; if m/s are meant, write {speed:g} m/s",
        field=("speed",),
    )


def check_speed(scenario: "Scenario", file: str | None) -> None:
    """Refuse a speed without its unit that looks like one in km/h, before anything is computed.

    Parameters
    ----------
    scenario
        The scenario.
    file
        Its file; None where the speed was given by the option ``--speed``.

    Raises
    ------
    ModelError
        The speed looks like one in km/h.
    """
    try:
        check_typed_speed(scenario)
    except ModelError as error:
        error.where = "--speed" if file is None else f"{file}: speed"
        raise


def speed_warnings(scenario: "Scenario") -> list[str]:
    """Return a sentence for a speed above the share of the wave speed that the standard allows."""
    speed, wave = scenario.top_speed, scenario.line.wave_speed
    if wave is None:
        return []
    share = f"{speed * KMH:.0f} km/h is {speed / wave:.0%} of the wave speed {wave * KMH:.0f} km/h"
    meant = f"; {question}" if (question := _meant(scenario)) else ""
    if speed >= wave:
        return [
            f"speed: {share} of the contact wire; the run is made, but linear theory says little"
            f" above the wave speed{meant}"
        ]
    if speed > WAVE_SPEED_SHARE * wave:
        return [f"speed: {share}; EN 50119 allows {WAVE_SPEED_SHARE:.0%}{meant}"]
    return []


def _meant(scenario: "Scenario") -> str:
    """Ask for km/h where a speed is whole in m/s, no round one in km/h, and too fast.

    90 m/s are 324 km/h: nobody writes that. 100 m/s are 360 km/h, which somebody may.
    """
    speed, wave = scenario.top_speed, scenario.line.wave_speed
    assert wave is not None  # only called where there is one
    if wave < SLOW_WAVES or not speed.is_integer() or speed < 1:
        return ""
    if (speed * KMH / 10).is_integer() and speed < wave:
        return ""
    return f"did you mean {speed:g} km/h? a number without a unit is in m/s"
