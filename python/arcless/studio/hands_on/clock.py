"""The clock of a session: how many steps are due, and what happens when the machine is too slow."""

from dataclasses import dataclass, field

# Time in s that a session may lag behind the wall before it slows down: what is older is given up,
# so that steps never pile up. Shorter, a hiccup of the system slows it; longer, it jumps after one.
MOST_LAG = 0.1
# Interval in s over which the pace is told.
TOLD_EVERY = 0.5
SLOWEST, FASTEST = 0.01, 1.0


@dataclass
class Clock:
    """Due time of a session, s.

    Attributes
    ----------
    rate
        Wanted: 1 is real time, 0 stands still.
    """

    rate: float
    _wall: float = field(default=0.0, init=False)
    _time: float = field(default=0.0, init=False)
    _told: tuple[float, float] = field(default=(0.0, 0.0), init=False)

    def begin(self, wall: float, time: float) -> None:
        """Start counting from here."""
        self._wall, self._time, self._told = wall, time, (wall, time)

    def set_rate(self, rate: float, wall: float, time: float) -> None:
        """Continue at another rate."""
        self.rate = rate
        self.begin(wall, time)

    def due(self, wall: float) -> float:
        """Return the time that the session should have reached."""
        return self._time + self.rate * (wall - self._wall)

    def give_up_lag(self, wall: float, time: float) -> None:
        """Forget what the session lags behind by more than `MOST_LAG` of the wall."""
        if self.due(wall) - time > self.rate * MOST_LAG:
            self._wall, self._time = wall, time

    def pace(self, wall: float, time: float) -> float | None:
        """Return the rate that was reached since it was last told; None before it is due again."""
        since, from_time = self._told
        if wall - since < TOLD_EVERY:
            return None
        self._told = (wall, time)
        return (time - from_time) / (wall - since)
