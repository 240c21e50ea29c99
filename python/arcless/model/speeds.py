"""Speeds beside the wave speed of the contact wire: refused, warned of, or a missing unit."""

from typing import TYPE_CHECKING

from arcless.errors import ModelError

if TYPE_CHECKING:
    from arcless.model.fields import Path
    from arcless.model.scenario import Scenario

KMH = 3.6
# EN 50119:2009, 5.2.4: speed at most 70 % of the wave speed of the contact wire.
WAVE_SPEED_SHARE = 0.70
# Just above the wave speed a run can be asked for to see what happens there. Nobody has run
# that far beyond it: such a speed is one in km/h without its unit.
SUPERCRITICAL = 1.25
# Lines in service have 380 to 570 km/h; much less is a tension in another unit. In m/s.
SLOW_WAVES = 200.0 / KMH
ROUNDING = 1e-9


def check_supercritical(scenario: "Scenario") -> None:
    """Refuse a speed far beyond the wave speed of the contact wire, if that is one of a line."""
    speed, wave = scenario.top_speed, scenario.line.wave_speed
    if wave is None or wave < SLOW_WAVES or speed <= SUPERCRITICAL * wave * (1 + ROUNDING):
        return
    profile = scenario.speed_profile is not None
    field: Path = ("speed_profile", "speed") if profile else ("speed",)
    raise ModelError(
        "a speed far beyond the wave speed of the contact wire",
        got=f"{speed:g} m/s ({speed * KMH:.0f} km/h), {speed / wave:.0%} of {wave * KMH:.0f} km/h",
        expected=f"at most {SUPERCRITICAL * wave * KMH:.0f} km/h",
        hint=_meant(scenario) or "look at speed, and at tension and mass of line.contact_wire",
        field=field,
    )


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
    assert wave is not None  # asked for beside it alone
    if wave < SLOW_WAVES or not speed.is_integer() or speed < 1:
        return ""
    if (speed * KMH / 10).is_integer() and speed < wave:
        return ""
    return f"did you mean {speed:g} km/h? a number without a unit is in m/s"
