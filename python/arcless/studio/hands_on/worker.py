"""The process of a session: steps at the pace of the wall, takes orders, sends moments."""

import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from arcless.errors import ArclessError, ContactError, ModelError
from arcless.model import Scenario
from arcless.model.load import load_text
from arcless.studio.answers.answers import complaint
from arcless.studio.hands_on.clock import FASTEST, SLOWEST, Clock
from arcless.studio.hands_on.frames import channels, packed
from arcless.studio.hands_on.gusts import Gust, number
from arcless.studio.hands_on.limits import highest_force
from arcless.studio.hands_on.session import Session
from arcless.studio.processes.talk import Talk

# Interval of moments in s, and of looks at orders. Longer, the picture jerks and forces come late.
EVERY, LOOK = 1 / 40, 0.004
# Moments on their way that the page has not drawn yet. With more a slow page lags behind its own
# slider; with one it waits for each to come back.
MOST_UNSEEN = 3
# Reach in m of the wires that are sent, before and behind the pantographs. What a screen shows, and
# some spans more; all of a long line would be megabytes a second.
REACH = 200.0


@dataclass(frozen=True)
class Begin:
    """Start of a session.

    Attributes
    ----------
    file, within, text
        The scenario file, the folder that no reference may lead out of (None: any), its text.
    rate
        Of real time.
    """

    file: Path
    within: Path | None
    text: str
    rate: float


def serve(talk: Talk, begin: Begin) -> None:
    """Hold a session until nobody wants it any more.

    Raises
    ------
    ArclessError
        The scenario is wrong, or cannot be stepped in a real-time loop.
    """
    _Desk(talk, begin).work()


class _Desk:
    def __init__(self, talk: Talk, begin: Begin) -> None:
        self._talk = talk
        loaded = load_text(begin.text, begin.file, begin.within)
        if not isinstance(loaded, Scenario):
            raise ModelError("no scenario", where=begin.file.name, expected="a scenario")
        self._session = session = Session(loaded)
        self._clock = Clock(checked_rate(begin.rate))
        self._unseen = self._laps = 0
        self._next = 0.0
        geometry = session.geometry
        talk.say(
            {
                "topic": "begun",
                "geometry": geometry,
                "channels": channels(session, len(geometry["wires"]), spatial=geometry["spatial"]),
                "pantographs": [
                    {"name": name, "static_force_N": force}
                    for name, force in zip(session.pantographs, session.static_force_N, strict=True)
                ],
                "speed_m_s": session.speed_m_s,
                "highest": highest_force(loaded, session.speed_m_s),
                "notes": session.notes,
            }
        )

    def work(self) -> None:
        session, clock = self._session, self._clock
        clock.begin(time.perf_counter(), session.time_s)
        while not self._talk.cancel():
            while (order := self._talk.order(LOOK)) is not None:
                self._take(order)
            wall = time.perf_counter()
            self._step_until(clock.due(wall), wall + EVERY)
            wall = time.perf_counter()
            clock.give_up_lag(wall, session.time_s)
            if wall >= self._next and self._unseen < MOST_UNSEEN:
                self._send(wall)
            pace = clock.pace(wall, session.time_s)
            if pace is not None:
                self._talk.say({"topic": "pace", "rate": pace, "wanted": clock.rate})

    def _step_until(self, due: float, latest: float) -> None:
        """Step to a time of the session, but no longer than to a time of the wall."""
        session = self._session
        while session.time_s < due and time.perf_counter() < latest:
            before = session.laps
            try:
                session.step()
            except ContactError as error:
                self._talk.say({"topic": "notice", "text": f"begun again: {error}"})
                session.begin_anew()
            if session.laps != before:
                self._talk.say({"topic": "lap", "laps": session.laps})

    def _send(self, wall: float) -> None:
        self._next = wall + EVERY
        self._unseen += 1
        self._talk.say(packed(self._session.moment(REACH)))

    def _take(self, order: dict[str, Any]) -> None:
        try:
            self._obey(order)
        except ArclessError as error:
            self._talk.say({"topic": "error", "error": complaint(error), "final": False})

    def _obey(self, order: dict[str, Any]) -> None:
        topic, session = order.get("topic"), self._session
        if topic == "seen":
            self._unseen = max(self._unseen - 1, 0)
        elif topic == "offset":
            session.offset(order.get("pantograph"), order.get("force_N"))
            self._next = 0.0  # what a hand does is shown at once
        elif topic == "gust":
            session.gust(Gust.of(order.get("wind_m_s"), order.get("duration_s")))
        elif topic == "rate":
            rate = checked_rate(order.get("rate"))
            self._clock.set_rate(rate, time.perf_counter(), session.time_s)
        else:
            raise ModelError("unknown order", expected="seen, offset, gust or rate")


def checked_rate(given: object) -> float:
    """Return a rate of real time: 0, or from `SLOWEST` to `FASTEST`.

    Raises
    ------
    ModelError
        It is none.
    """
    if given == 0 and not isinstance(given, bool):
        return 0.0
    return number("rate of real time", given, "", SLOWEST, FASTEST)
