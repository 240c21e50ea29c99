"""Answers about a line at rest: the same numbers as `arcless statics` gives, by the same functions.

A slider asks again and again for the same file with another value: what does not change is kept
from one question to the next.

A draft is the same line on longer elements, for a drawing that follows what is typed. Of shipped
lines of 20 spans it takes 25 to 55 ms in place of 50 to 120, with forces of droppers within 0.1 N
and their lengths within 0.03 mm. An answer says that it is one; numbers are not read off it.

While a slider moves, a line is searched for from the one of the question before, by the same bounds
on forces and heights: no force is out of balance by more than rounding, 8 EA ε x/L for coordinates
up to x and elements of L, some 1e-4 N of 20 spans. When the slider rests, the line is found as
`arcless statics` finds it, and the numbers are the same to the last bit.
"""

from typing import Any

from arcless.equilibrium import equilibrium
from arcless.equilibrium.equilibrium import Equilibrium
from arcless.equilibrium.initial_configuration import InitialConfiguration
from arcless.equilibrium.line_alone import ALONE, LineAlone
from arcless.errors import ModelError
from arcless.model import Line, Scenario
from arcless.model.files.yaml_reader import Origin
from arcless.model.load import load_text
from arcless.model.scenario.overrides import apply, apply_to_line
from arcless.simulate.schedules import allowance, dropper_schedule
from arcless.storage.csv_files import csv_text
from arcless.studio.at_rest.handles import handles
from arcless.studio.at_rest.of_equilibrium import geometry_at_rest
from arcless.studio.at_rest.question import Question

# Longest elements of a draft, in m. Those of 1 m take as long as a line in numbers, those of 4 m
# are off by twice as much and save a quarter.
DRAFT_ELEMENT = 2.0


class Bench:
    """A place at which one page looks at lines at rest, one after the other."""

    def __init__(self) -> None:
        self._read: tuple[Any, Scenario | LineAlone] | None = None
        self._found: tuple[Any, Scenario | LineAlone, Equilibrium] | None = None
        self._near: Equilibrium | None = None

    def answer(self, question: Question) -> dict[str, Any]:
        """Return the parts that are asked for.

        Raises
        ------
        ArclessError
            The model is wrong, or its line has no shape at rest.
        """
        source, found = self._at_rest(question)
        want = question.want
        x = found.elasticity_positions() if "elasticity" in want else None
        elasticity = [] if x is None else found.elasticity(x).tolist()
        frequencies = found.frequencies().tolist() if "frequencies" in want else []
        line = InitialConfiguration(
            source, found, [] if x is None else x.tolist(), elasticity, frequencies
        )
        answer: dict[str, Any] = {
            "question": question.number,
            "draft": isinstance(source, LineAlone) and source.elements is not ALONE,
            "name": source.line.name,
            "middle_span": line.middle_span,
            "sag_m": line.contact_wire_sag_m,
            "wave_speed_m_s": line.wave_speed,
            "frequencies_Hz": frequencies if "frequencies" in want else None,
            "errors": [],
        }
        if "line" in want:
            answer["line"] = geometry_at_rest(found, source.line)
            answer["handles"] = handles(question.text, source, found)
        if "droppers" in want:
            answer["droppers"] = line.droppers
        if "supports" in want:
            answer["supports"] = line.supports
        if "schedule" in want:
            answer["schedule"] = _schedule(line, question.allowance)
        if x is not None:
            per_force = [1e3 * one for one in elasticity]
            answer["elasticity"] = {"x_m": x.tolist(), "mm_per_N": per_force}
            answer["nonuniformity"] = line.elasticity_nonuniformity
        return answer

    def _at_rest(self, question: Question) -> tuple[Scenario | LineAlone, Equilibrium]:
        """Return model and equilibrium, those of the last question where it was of the same."""
        # Changes in text form: 1, 1.0 and true are different ones.
        changes = repr(sorted(question.changes.items()))
        key = (question.file, question.text, question.draft, question.moving, changes)
        if self._found is None or self._found[0] != key:
            source = self._changed(question)
            source = _draft(source) if question.draft else source
            self._found = None  # an error leaves nothing behind that has another key
            # Lengths of a line as built are not those of a design.
            near = self._near if question.moving and source.as_built.is_empty else None
            found = equilibrium.find(source, near)
            self._near = found if source.as_built.is_empty else None
            self._found = (key, source, found)
        return self._found[1], self._found[2]

    def _changed(self, question: Question) -> Scenario | LineAlone:
        source = self._model(question)
        if not question.changes:
            return source
        place = Origin(folder=question.file.parent, within=question.within)
        if isinstance(source, LineAlone):
            return LineAlone(apply_to_line(source.line, question.changes, place))
        return apply(source, question.changes, place=place)

    def _model(self, question: Question) -> Scenario | LineAlone:
        key = (question.file, question.text)
        if self._read is None or self._read[0] != key:
            loaded = load_text(question.text, question.file, question.within)
            if not isinstance(loaded, Scenario | Line):
                raise ModelError(
                    "a pantograph has no line at rest",
                    where=str(question.file), expected="a line or a scenario",
                )  # fmt: skip
            source = loaded if isinstance(loaded, Scenario) else LineAlone(loaded)
            self._read = (key, source)
        return self._read[1]


def _draft(source: Scenario | LineAlone) -> Scenario | LineAlone:
    """Return the line of a model on longer elements; a line as built is not simplified."""
    if not source.as_built.is_empty:
        return source
    chosen = source.stepping
    same = {"dimension": chosen.dimension, "gravity": chosen.gravity}
    longest = dict.fromkeys(("contact_wire_element", "messenger_wire_element"), DRAFT_ELEMENT)
    return LineAlone(source.line, ALONE.model_copy(update=same | longest))


def _schedule(line: InitialConfiguration, given: str | None) -> str:
    """Return the dropper schedule as the text of a CSV file, as `arcless statics --droppers`."""
    return csv_text(dropper_schedule(line, allowance(given or 0.0)))
