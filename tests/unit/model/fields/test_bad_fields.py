"""A wrong field in a file: file, line, field, what was given, what is expected, a hint."""

from collections.abc import Callable
from pathlib import Path

import pytest

from arcless.errors import ModelError
from arcless.model import load, load_line

Refused = Callable[..., str]


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            "tension: 22 kN",
            "tension: 22 kg",
            'line.yaml:7: contact_wire.tension: got "22 kg", expected a force (N, kN, daN, MN,'
            " kgf, tf, lbf); hint: kg is the unit of a mass: did you mean kgf?",
        ),
        (
            "tension: 22 kN",
            "tension: 22 kn",
            'line.yaml:7: contact_wire.tension: got "22 kn", expected a force (N, kN, daN, MN,'
            " kgf, tf, lbf); hint: did you mean kN?",
        ),
        (
            "tension: 22 kN",
            "tension: 0",
            "line.yaml:7: contact_wire.tension: got 0 N, expected a force (N, kN, daN, MN, kgf,"
            " tf, lbf), at least 0.001 N; hint: only a conductor rail (kind: conductor_rail)"
            " is without tension",
        ),
        (
            "tension: 22 kN",
            "tension: .nan",
            "line.yaml:7: contact_wire.tension: got nan, expected a force (N, kN, daN, MN, kgf,"
            " tf, lbf), finite",
        ),
        (
            "  tension: 22 kN\n",
            "",
            "line.yaml:3: contact_wire.tension: missing field: expected Tension; 0 only in a"
            " rail: a force (N, kN, daN, MN, kgf, tf, lbf), at least 0 N and at most 1e+09 N",
        ),
        (
            "tension: 22 kN",
            "tensoin: 22 kN",
            'line.yaml:7: contact_wire.tensoin: unknown field: got "tensoin", expected a field of'
            " contact_wire; hint: did you mean tension?",
        ),
        (
            "mass: 1.35 kg/m",
            "mass: -1.35 kg/m",
            'line.yaml:4: contact_wire.mass: got "-1.35 kg/m", expected a mass per length (kg/m,'
            " g/m, kg/km, t/km, lb/ft), at least 1e-06 kg/m and at most 10000 kg/m",
        ),
        (
            "[10, 20, 35, 45]",
            "[10, 20, 35, 56]",
            "line.yaml:27: span_types.standard.droppers.positions.3: dropper outside its span:"
            " got 56 m, expected a position between 0 and 55 m, the span's length; hint: positions"
            " count from the left support of the span",
        ),
        (
            "positions: [10, 20, 35, 45]",
            "positions: [10, 20, 35, 55]",
            "line.yaml:27: span_types.standard.droppers.positions.3: dropper at a support:"
            " got 55 m, the place of the right support, expected a position between the supports at"
            " 0 and 55 m; hint: leave it out: the support holds the messenger wire there",
        ),
        (
            "positions: [10, 20, 35, 45]",
            "positions: [0 mm, 20, 35, 45]",
            "line.yaml:27: span_types.standard.droppers.positions.0: dropper at a support:"
            " got 0 m, the place of the left support, expected a position between the supports at"
            " 0 and 55 m; hint: leave it out: the support holds the messenger wire there",
        ),
        (
            "[10, 20, 35, 45]",
            "[10, 35, 20, 45]",
            "line.yaml:27: span_types.standard.droppers.positions.2: droppers out of order: got"
            " 20 m after 35 m, expected positions that increase along the span",
        ),
        (
            "[10, 20, 35, 45]",
            "[10, 20, 35, 45]\n      presag: [0, 0]",
            "line.yaml:28: span_types.standard.droppers.presag: wrong number of values: got 2"
            " values, expected 4, one for each of positions",
        ),
        (
            "[10, 20, 35, 45]",
            "[10, 20, 35, 45]\n      presag: [0, 20 , 20, 0]",
            "line.yaml:28: span_types.standard.droppers.presag.1: got 20 m, expected less than the"
            " encumbrance, 1.2 m; hint: pre-sag is positive downwards; mind mm and m",
        ),
        (
            "[10, 20, 35, 45]",
            "[10, 20, 35, 45]\n      presag: [0, 0, 0, 0]\n      lengths: [1, 1, 1, 1]",
            "line.yaml:29: span_types.standard.droppers.lengths: both presag and lengths given:"
            " expected presag (design) or lengths (as built)",
        ),
        (
            "[10, 20, 35, 45]",
            "[10, 20, 35, 45]\n      lengths: [1, 0, 1, 1]",
            "line.yaml:28: span_types.standard.droppers.lengths.1: got 0 m, expected a dropper"
            " length above 0 m",
        ),
        (
            "kind: spring",
            "kind: spirng",
            'line.yaml:18: steady_arm.kind: got "spirng", expected spring or arm or none; hint: did'
            " you mean spring?",
        ),
        (
            "  kind: spring\n",
            "",
            "line.yaml:17: steady_arm.kind: missing field: expected the kind",
        ),
        (
            "type: standard",
            "type: standart",
            'line.yaml:29: spans.0.type: unknown span type: got "standart", expected a'
            " name from span_types; hint: did you mean standard?",
        ),
        (
            "count: 8",
            "count: 8.5",
            "line.yaml:29: spans.0.count: got 8.5, expected a whole number",
        ),
        (
            "count: 8",
            "count: 100000",
            "line.yaml:29: spans.0.count: got 100000, expected less than or equal to 5000",
        ),
        (
            "count: 8}",
            "count: 4000}\n  - {type: standard, count: 4000}",
            "line.yaml:28: spans: too many spans: got 8000, expected at most 5000 in all",
        ),
        (
            "spans:\n  - {type: standard, count: 8}",
            "spans: []",
            "line.yaml:28: spans: got a list of 0, expected at least 1 items",
        ),
        (
            "name: small",
            "name: 55",
            "line.yaml:2: name: got 55, expected a text; hint: write it in quotes",
        ),
        (
            "stiffness: 200 kN/m",
            'stiffness: {value: 200 kN/m, mark: X, note: "n"}',
            'line.yaml:14: dropper.stiffness.mark: got "X", expected A or'
            " A' or B or C or C* or D or assumed; hint: known: A, A', B, C, C*, D, assumed",
        ),
        (
            "stiffness: 200 kN/m",
            "stiffness: {value: 200 kN/m, mark: A, note: soft, old}",
            'line.yaml:14: dropper.stiffness.old: unknown field next to a value: got "old",'
            " expected value, mark, source, note; hint: write a note that contains a comma in"
            " quotes",
        ),
        (
            "stiffness: 200 kN/m",
            "stiffness: {value: 200 kN/m, mark: A, source: S1}",
            'line.yaml:14: dropper.stiffness.source: unknown source: got "S1", expected a key of'
            " sources; hint: add sources:",
        ),
        (
            "format: arcless-line/1",
            "format: arcless-line/2",
            'line.yaml:1: format: wrong format: got "arcless-line/2", expected arcless-line/1;'
            " hint: this version of Arcless reads version 1",
        ),
        (
            "format: arcless-line/1\n",
            "",
            "line.yaml: format: missing field: expected arcless-scenario/1 or arcless-line/1 or"
            " arcless-pantograph/1",
        ),
    ],
)
def test_line(refused: Refused, old: str, new: str, message: str) -> None:
    assert refused(old, new) == message


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            "speed: 200 km/h",
            "speed: 200 kn/h",
            'scenario.yaml:6: speed: got "200 kn/h", expected a speed (m/s, km/h, mph, ft/s); hint:'
            " did you mean km/h?",
        ),
        (
            "speed: 200 km/h\n",
            "",
            "scenario.yaml: speed: missing field: expected speed or speed_profile; hint: for"
            " instance speed: 160 km/h",
        ),
        (
            "model: dsa-380",
            "{model: dsa-380, static_force: 70 N, mean_force: 100 N}",
            "scenario.yaml:5: pantographs.0.mean_force: both static_force and mean_force given:"
            " expected one of the two; hint: leave static_force out: mean_force finds it",
        ),
        (
            "model: dsa-380",
            "model: ac-simple",
            "scenario.yaml:5: pantographs.0.static_force: no force given: expected static_force or"
            " mean_force, since the pantograph has no static_force",
        ),
        (
            "model: dsa-380",
            "model: dsa-830",
            'scenario.yaml:5: pantographs.0.model: unknown pantograph: got "dsa-830", expected a'
            " shipped name or a file (.json, .yaml, .yml); hint: did you mean dsa-380?",
        ),
        (
            "- model: dsa-380",
            "- model: dsa-380\n  - {model: dsa-380, distance: 400 m}",
            "scenario.yaml: travel: no travel: got 455 m to 385 m, expected a start before the"
            " end; hint: the line is 440 m long and the last pantograph 400 m behind the first: add"
            " spans, bring the pantographs closer together, or give travel.start and travel.end",
        ),
        (
            "- model: dsa-380",
            "- model: dsa-380\n  - {model: dsa-380, distance: 0 m}",
            "scenario.yaml:6: pantographs.1.distance: pantographs out of order: got 0 m after 0 m,"
            " expected distances that increase towards the rear; hint: every distance counts from"
            " the first pantograph, backwards",
        ),
        (
            "speed:",
            "analysis: {from: 100 m, to: 500 m}\nspeed:",
            "scenario.yaml:6: analysis.to: analysis section outside the line: got 500 m, expected"
            " a position between 0 and 440 m, the line's length",
        ),
        (
            "speed:",
            "analysis: {spans: [3, 9]}\nspeed:",
            "scenario.yaml:6: analysis.spans: analysis section outside the line: got span 9,"
            " expected spans between 1 and 8",
        ),
        (
            "speed:",
            "analysis: {spans: [1, 1]}\nspeed:",
            "scenario.yaml:6: analysis.spans: analysis section not travelled by every pantograph:"
            " got 0 m to 55 m, expected a section between 55 m and 385 m; hint: choose a section"
            " within that, or change travel.start or travel.end",
        ),
        (
            "speed:",
            "travel: {end: 700 m}\nspeed:",
            "scenario.yaml:6: travel.end: outside the line: got 700 m, expected a position between"
            " 0 and 440 m, the line's length",
        ),
        (
            "speed:",
            "output: {points: [20, 441]}\nspeed:",
            "scenario.yaml:6: output.points.1: outside the line: got 441 m, expected a position"
            " between 0 and 440 m, the line's length",
        ),
        (
            "speed:",
            "solver: {time_step: 1 s}\nspeed:",
            'scenario.yaml:6: solver.time_step: got "1 s", expected a time (s, ms, min), at least'
            ' 1e-05 s and at most 0.05 s, or "auto", or "one element"',
        ),
        (
            "speed:",
            "solver: {time_step: one elment}\nspeed:",
            'scenario.yaml:6: solver.time_step: got "one elment", expected a time (s, ms, min), at'
            ' least 1e-05 s and at most 0.05 s, or "auto", or "one element"; hint: write a number,'
            " then its unit, such as 1.5 m",
        ),
        (
            "speed:",
            "solver: {time_step: 25 ms, contact_wire_element: 1.45 m}\nspeed:",
            "scenario.yaml: analysis.low_pass: the recorded steps are too long for the filter: got"
            " 20 Hz, expected less than 20 Hz, half the record rate; hint: give"
            " solver.time_step less than 25 ms (it is 25 ms), or a lower analysis.low_pass",
        ),
        (
            "speed:",
            "solver: {time_step: 50 ms}\nspeed:",
            "scenario.yaml:6: solver.time_step: step longer than an element: got 2.778 m in a step,"
            " expected at most 0.725 m, one element of the contact wire; hint: give at most"
            " 13.05 ms at this speed, or leave solver.time_step out, and it is chosen",
        ),
        (
            "speed: 200 km/h",
            "speed_profile: {time: [0, 9], speed: [50, 60]}\nsolver: {time_step: one element}",
            'scenario.yaml:7: solver.time_step: no time step: got "one element" with a speed'
            " profile, expected a time: with a changing speed, one element takes no fixed time",
        ),
        (
            "speed:",
            "solver: {kinematics: updated}\noutput: {energy: always}\nspeed:",
            "scenario.yaml:7: output.energy: no energy balance with updated kinematics: got always,"
            " expected auto or never, or solver.kinematics linearised; hint: stiffness that is"
            " formed again in each step belongs to no stored energy",
        ),
        (
            "speed:",
            "solver: {residual_flexibility: true, wire_model: lumped}\nspeed:",
            "scenario.yaml:6: solver.wire_model: not together with residual_flexibility: got"
            " lumped, expected hermite, or residual_flexibility: auto",
        ),
        (
            "speed:",
            "solver: {residual_flexibility: true, kinematics: updated}\nspeed:",
            "scenario.yaml:6: solver.kinematics: not together with residual_flexibility: got"
            " updated, expected linearised, or residual_flexibility: auto",
        ),
        (
            "speed:",
            "solver: {scheme: central-difference, wire_model: hermite}\nspeed:",
            "scenario.yaml:6: solver.wire_model: not together with the scheme central-difference:"
            " got hermite, expected lumped, or another scheme; hint: leave it out: auto takes what"
            " the scheme needs",
        ),
        (
            "speed:",
            "solver: {wire_model: lump}\nspeed:",
            'scenario.yaml:6: solver.wire_model: got "lump", expected auto or hermite or lumped;'
            " hint: did you mean lumped?",
        ),
        (
            "speed:",
            "solver: {contact_wire_element: automatic}\nspeed:",
            'scenario.yaml:6: solver.contact_wire_element: got "automatic", expected a length (m,'
            ' mm, cm, km, in, ft, yd, chain, mi), at least 0.05 m and at most 20 m, or "auto";'
            " hint: write a number, then its unit, such as 1.5 m",
        ),
        (
            "speed:",
            "solver: {messenger_wire_element: one element}\nspeed:",
            'scenario.yaml:6: solver.messenger_wire_element: got "one element", expected a length'
            ' (m, mm, cm, km, in, ft, yd, chain, mi), at least 0.05 m and at most 20 m, or "auto";'
            " hint: write a number, then its unit, such as 1.5 m",
        ),
        (
            "speed:",
            "solver: {scheme: central-difference, kinematics: updated}\nspeed:",
            "scenario.yaml:6: solver.kinematics: not together with the scheme central-difference:"
            " got updated, expected linearised, or another scheme",
        ),
        (
            "speed:",
            "solver: {scheme: central-difference, residual_flexibility: false}\nspeed:",
            "scenario.yaml:6: solver.residual_flexibility: not together with the scheme"
            " central-difference: got false, expected auto or true, or another scheme; hint:"
            " explicit steps always have it",
        ),
        (
            "speed:",
            "solver: {scheme: {name: newmark, beta: 0.25, gamma: 0.6}}\nspeed:",
            "scenario.yaml:6: solver.scheme.beta: not unconditionally stable: got 0.25, expected"
            " at least (gamma + 1/2)²/4 = 0.3025",
        ),
        (
            "speed: 200 km/h",
            "speed_profile: {time: [0, 2, 1], speed: [10, 10, 10]}",
            "scenario.yaml:6: speed_profile.time.2: times out of order: got 1 s after 2 s,"
            " expected times that increase",
        ),
        (
            "line: line.yaml",
            "line: 5",
            "scenario.yaml:3: line: got 5, expected the name of a shipped line, a file, or a"
            " mapping",
        ),
    ],
)
def test_scenario(refused: Refused, old: str, new: str, message: str) -> None:
    assert refused(old, new, "scenario.yaml") == message


def test_an_error_in_a_referenced_file_names_both(files: Path) -> None:
    line = files / "line.yaml"
    line.write_text(line.read_text().replace("22 kN", "22 kg"), encoding="utf-8")
    with pytest.raises(ModelError) as caught:
        load(files / "scenario.yaml")
    assert caught.value.where == f"{line}:7 (named in {files / 'scenario.yaml'}:3)"


def test_an_error_in_an_inline_line_has_its_full_path(files: Path) -> None:
    path = files / "scenario.yaml"
    inline = "\n".join(f"  {row}" for row in (files / "line.yaml").read_text().splitlines())
    text = path.read_text().replace("line: line.yaml", f"line:\n{inline}")
    path.write_text(text, encoding="utf-8")
    assert load(path).line == load_line(files / "line.yaml")
    path.write_text(text.replace("22 kN", "22 kg"), encoding="utf-8")
    with pytest.raises(ModelError, match=r"scenario.yaml:10: line.contact_wire.tension: got"):
        load(path)


def test_all_mistakes_of_a_file_are_listed_in_its_order(refused: Refused) -> None:
    message = refused("tension: 22 kN", "tension: 22 kg\n  ends: loose")
    assert [row.split(": ")[1] for row in message.splitlines()] == [
        "contact_wire.tension",
        "contact_wire.ends",
    ]
