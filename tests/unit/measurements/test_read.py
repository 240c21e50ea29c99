"""CSV files of measured runs: forms that are recognised, and files that are refused."""

import os
from pathlib import Path

import numpy as np
import pytest

from arcless.errors import MeasurementError, ModelError
from arcless.measurements import Head, read
from arcless.measurements.table.dialect import LARGEST_FILE
from tests.support.measured import SPEED, force, record, times, write

HEAD = "time [s],position [m],contact_force [N]"
ROWS = [f"{i / 500!r},{i * 0.14!r},{100.0 + i % 7}" for i in range(20)]


def text(*rows: str, head: str = HEAD) -> str:
    return "\n".join([head, *rows]) + "\n"


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "run.csv"


@pytest.mark.parametrize("ends", [("utf-8", "\n"), ("utf-8-sig", "\r\n")])
@pytest.mark.parametrize(
    ("delimiter", "decimal", "words"),
    [
        (",", ".", "separated by comma, decimal point"),
        (";", ".", "separated by semicolon, decimal point"),
        (";", ",", "separated by semicolon, decimal comma"),
        ("\t", ",", "separated by tab, decimal comma"),
    ],
)
def test_forms_of_a_table(
    file: Path, delimiter: str, decimal: str, words: str, ends: tuple[str, str]
) -> None:
    write(file, record(), delimiter=delimiter, decimal=decimal, ends=ends)
    found = read(file)
    [measured] = found.pantographs
    assert words in found.notes[0]
    # The same bits: nothing was interpolated, and numbers are read as they were written.
    assert np.array_equal(measured.force, force(times()))
    assert np.array_equal(measured.time, times())
    assert np.array_equal(measured.position, SPEED * times())
    assert measured.rate_Hz == pytest.approx(500.0, rel=1e-12)
    assert measured.pieces == (slice(0, 5000),)
    assert measured.left_out == ()


def test_units_are_converted(file: Path) -> None:
    head = "Time [ms];Speed (km/h);Contact Force [kN];contact height [mm]"
    rows = [f"{2 * i};252;{0.1 + i / 1000!r};{5300 + i}" for i in range(20)]
    [found] = read(_written(file, text(*rows, head=head))).pantographs
    count = np.arange(20)
    # One product in floating point each.
    assert found.time == pytest.approx(0.002 * count, rel=1e-12)
    assert found.position == pytest.approx(0.14 * count, rel=1e-12, abs=1e-12)
    assert found.force == pytest.approx(100.0 + count, rel=1e-12)
    assert found.height == pytest.approx(5.3 + count / 1000, rel=1e-12)


def test_units_of_british_drawings(file: Path) -> None:
    rows = [f"{i},60,{10 + i}" for i in range(20)]
    head = "position [ft],speed [mph],contact_force [lbf]"
    [found] = read(_written(file, text(*rows, head=head))).pantographs
    # 1 ft = 0.3048 m, 60 mph = 88 ft/s, 1 lbf = 4.4482216152605 N: exact by definition.
    assert found.time == pytest.approx(np.arange(20) / 88.0, rel=1e-12, abs=1e-12)
    assert found.force == pytest.approx(4.4482216152605 * np.arange(10, 30), rel=1e-12)


def test_comments_quotes_and_empty_lines_are_skipped(file: Path) -> None:
    head = '"time [s]","position [m]","contact_force [N]","remark, by hand"'
    rows = ["# a, b, c, d", "", *(f'{row},"a, b"' for row in ROWS), "   ", "# end"]
    found = read(_written(file, "# from the train\n\n" + text(*rows, head=head)))
    assert found.pantographs[0].force.size == 20
    assert found.notes[1] == "columns that are not used: remark, by hand"


def test_a_line_for_excel_and_delimiters_at_the_end_of_lines(file: Path) -> None:
    rows = [f"{row};".replace(",", ";") for row in (HEAD, *ROWS)]
    [found] = read(_written(file, "sep=;\r\n" + "\r\n".join(rows))).pantographs
    assert found.force.size == 20


def test_lines_of_messages_count_comments(file: Path) -> None:
    rows = ["# one", *ROWS[:3], "", "0.006,0.5,ten", *ROWS[4:]]
    with pytest.raises(MeasurementError, match=r'run\.csv:7: column contact_force.*got "ten"'):
        read(_written(file, text(*rows)))


def test_speed_and_time_make_positions_and_speed_and_position_times(file: Path) -> None:
    head = "time [s],speed [m/s],contact_force [N]"
    # 10 m/s rising by 1 m/s each 0.1 s: x = 10 t + 5 t², which the trapezoidal rule has exactly.
    rows = [f"{i / 10!r},{10 + i},{100 + i % 7}" for i in range(20)]
    [found] = read(_written(file, text(*rows, head=head))).pantographs
    time = np.arange(20) / 10
    assert found.position == pytest.approx(10 * time + 5 * time**2, rel=1e-12, abs=1e-12)
    head = "position [m],contact_force [N]"
    rows = [f"{1000 - i / 4},{100 + i % 7}" for i in range(20)]
    [found] = read(_written(file, text(*rows, head=head)), speed="90 km/h").pantographs
    assert found.time == pytest.approx(np.arange(20) / 100, rel=1e-12, abs=1e-12)
    assert found.clock == "position"
    assert found.position[0] == 1000.0
    assert found.position[-1] < 1000.0


def test_several_pantographs_by_their_names(file: Path) -> None:
    head = "time [s],speed [m/s],P1.contact_force [N],P2.contact_force [N],P2.position [m]"
    rows = [f"{i / 500!r},70,{100 + i % 7},{200 + i % 5},{i * 0.14 - 50!r}" for i in range(20)]
    _written(file, text(*rows, head=head))
    assert [one.name for one in read(file).pantographs] == ["P1", "P2"]
    [second] = read(file, pantograph="P2").pantographs
    assert (second.force[0], second.position[0]) == (200.0, -50.0)
    with pytest.raises(MeasurementError, match='got "P3", expected P1, P2'):
        read(file, pantograph="P3")
    # A slip in the other one's cells is none of the chosen one's business.
    _written(file, file.read_text().replace(",200,", ",two,"))
    assert read(file, pantograph="P1").pantographs[0].force.size == 20


REFUSED = {
    "empty": ("", r"run\.csv: empty file: got no header"),
    "comments only": ("# a\n\n", "empty file"),
    "only a header": (HEAD + "\n", "empty table: got a header without rows"),
    "one column": ("contact_force [N]\n1\n2\n", r"run\.csv:1: header with one column"),
    "blanks as delimiter": ("time[s] position[m]\n0 1\n", "header with one column.*commas"),
    "decimal comma and comma": (
        text("0,002,0,14,100,5"),
        r"run\.csv:2: wrong number of cells: got 6, expected 3.*decimal comma\? .*semicolons",
    ),
    "another delimiter than the header": (
        HEAD.replace(",", ";") + "\n" + "\n".join(ROWS),
        r"run\.csv:2: wrong number of cells: got 1, .*separate the cells as those of the header",
    ),
    "short row": (text(*ROWS[:4], "0.008,0.56"), r"run\.csv:6: wrong number of cells: got 2"),
    "long row": (text(*ROWS[:4], "0.008,0.56,1,2"), r"run\.csv:6: wrong number of cells: got 4"),
    "text in a number": (
        text(*ROWS[:4], "0.008,0.56,off"),
        r'run\.csv:6: column contact_force \[N\]: got "off", expected a number with a decimal po',
    ),
    "decimal comma in quotes": (
        text(*ROWS[:4], '0.008,0.56,"1,5"'),
        r'run\.csv:6: column contact_force \[N\]: got "1,5"',
    ),
    "mixed decimal signs": (
        text(*(row.replace(",", ";").replace(".", ",") for row in ROWS), "9.5;9,5;9,5").replace(
            HEAD, HEAD.replace(",", ";")
        ),
        r'run\.csv:22: column time \[s\]: got "9\.5", expected a number with a decimal comma',
    ),
    "missing unit": (
        text(*ROWS, head=HEAD.replace(" [N]", "")),
        r"run\.csv:1: column contact_force: unit missing.*expected a force.*contact_force \[N\]",
    ),
    "unit without brackets": (
        text(*ROWS, head=HEAD.replace("[N]", "N")),
        r'unit missing: got "contact_force N".*in brackets, such as contact_force \[N\]',
    ),
    "unknown unit": (
        text(*ROWS, head=HEAD.replace("[N]", "[lbs]")),
        r'run\.csv:1: column contact_force: got "lbs", expected a force \(N',
    ),
    "unit of another kind": (
        text(*ROWS, head=HEAD.replace("[N]", "[kg]")),
        'got "kg", expected a force.*kg is the unit of a mass',
    ),
    "column twice": (
        text(*ROWS, head=HEAD.replace("position", "time").replace("[m]", "[ms]")),
        r'run\.csv:1: column given twice: got "time \[s\]" and "time \[ms\]"',
    ),
    "misspelt column": (
        text(*ROWS, head=HEAD.replace("contact_force", "contact_froce")),
        r'unknown column: got "contact_froce \[N\]"; hint: did you mean contact_force\?',
    ),
    "no force": (text(*ROWS, head="time [s],position [m],load [N]"), "got no contact force"),
    "no clock": (text(*ROWS, head="a,b,contact_force [N]"), "got no time and no position"),
    "no speed": (text(*ROWS, head="time [s],a,contact_force [N]"), 'give the speed, such as "250'),
    "unnamed and named": (
        text(*ROWS, head="time [s],P1.contact_force [N],contact_force [N]"),
        "force without the name of its pantograph",
    ),
    "time back": (
        text(*ROWS[:4], "0.001,0.56,100"),
        r"run\.csv:6: time goes back: got 0\.001 s after 0\.006 s in line 5",
    ),
    "time stands": (
        text(*ROWS[:4], "0.006,0.56,100"),
        r"run\.csv:6: time stands: got 0\.006 s after 0\.006 s in line 5.*more digits",
    ),
    "speeds in another unit": (
        text(
            *(f"{i / 500},250,{i}" for i in range(9)),
            head=HEAD.replace("position [m]", "speed [m/s]"),
        ),
        "speed of pantograph P1: got 900 km/h",
    ),
}  # fmt: skip


@pytest.mark.parametrize("kind", REFUSED)
def test_what_is_refused(file: Path, kind: str) -> None:
    content, message = REFUSED[kind]
    with pytest.raises(MeasurementError, match=message):
        read(_written(file, content))


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (text(*ROWS).encode("utf-16"), "text in UTF-16.*save it as CSV in UTF-8"),
        (b"\x89HDF\r\n\x1a\n\0\0", "got an HDF5 or NetCDF file"),
        (b"PK\x03\x04\x14\0", r"a zip archive, as \.xlsx is one"),
        (bytes(range(256)), "binary data"),
        (text(*ROWS).encode() + b"\0" * 2_000_000, "binary data"),
        (text(*ROWS, head=HEAD + ",t [°]").encode("latin-1"), r"run\.csv:1: .*byte 0xb0"),
        (b"a" * 2_000_000, r"run\.csv:1: line too long"),
        (text(*ROWS).encode() + b"1" * 9_000_000, "line too long"),
    ],
    ids=["utf-16", "hdf5", "xlsx", "binary", "binary behind", "latin-1", "one line", "long line"],
)
def test_what_is_no_text_is_refused(file: Path, content: bytes, message: str) -> None:
    file.write_bytes(content)
    with pytest.raises(MeasurementError, match=message):
        read(file)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (text(*ROWS).replace("\n", "\r"), r"run\.csv:1: line end: got a carriage return alone"),
        (text(*ROWS[:3], ROWS[3].replace(",", ",\r", 1), *ROWS[4:]), r"run\.csv:5: line end"),
        (text(*ROWS[:3], ROWS[3] + '"', *ROWS[4:9], ROWS[9] + '"'), "quote|got .*103"),
        (text(*ROWS[:3], ROWS[3].replace("103.0", '"103.0'), *ROWS[4:]), "not a CSV file|quote"),
        (text(*ROWS[:3], "0.006,0.42,1e300"), r"run\.csv:5: .*got 1e\+300, expected a number that"),
        (text(ROWS[0]), "no samples are left: got one sample"),
        (text(",,", ",,"), "no samples are left: got time, position or speed is missing in every"),
    ],
)
def test_found_by_spoiling_files(file: Path, content: str, message: str) -> None:
    with pytest.raises(MeasurementError, match=message):
        read(_written(file, content))


def test_a_file_beyond_memory_is_refused_before_it_is_read(file: Path) -> None:
    _written(file, text(*ROWS))
    os.truncate(file, 2 * 2**30)  # takes no room on the disk
    with pytest.raises(
        MeasurementError, match=r"too large: got 2048 MiB, expected at most 512 MiB"
    ):
        read(file)
    assert file.stat().st_size > LARGEST_FILE


def test_too_many_rows_are_refused_while_they_are_counted(
    file: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("arcless.measurements.table.rows.MOST_LINES", 20)
    with pytest.raises(MeasurementError, match="too many rows: got more than 20 lines"):
        read(_written(file, text(*ROWS)))


def test_no_file_and_a_folder(tmp_path: Path) -> None:
    with pytest.raises(MeasurementError, match="no such file"):
        read(tmp_path / "none.csv")
    with pytest.raises(MeasurementError, match="not a file: got a folder"):
        read(tmp_path)


def test_speeds_that_are_none(file: Path) -> None:
    _written(file, text(*ROWS, head="time [s],a,contact_force [N]"))
    with pytest.raises(MeasurementError, match=r"900 km/h.*a number without a unit is in m/s"):
        read(file, speed="250")
    with pytest.raises(MeasurementError, match="more than 0"):
        read(file, speed="0 km/h")
    with pytest.raises(ModelError, match="kg is the unit of a mass"):
        read(file, speed="3 kg")


def test_speeds_are_those_of_time_and_position(file: Path) -> None:
    # 250 mph read as km/h, and an odometer of 1.5 % too much.
    wrong = write(file, record(speed=np.full(5000, SPEED / 1.609344)))
    with pytest.raises(
        MeasurementError, match=r"column speed.*got 156.6 km/h.*give 252 km/h.*within 2 %"
    ):
        read(wrong)
    # Rounded to 1 m, positions step by nothing or by 1 m.
    rough = np.round(1.015 * SPEED * times())
    near = read(write(file, record(speed=np.full(5000, SPEED), position=rough)))
    assert near.pantographs[0].speed[0] == SPEED
    far = record(speed=np.full(5000, SPEED), position=1.03 * SPEED * times())
    with pytest.raises(MeasurementError, match="column speed against time and position"):
        read(write(file, far))


def test_a_constant_speed_is_not_used_beside_time_and_position(file: Path) -> None:
    found = read(write(file, record()), speed="200 km/h")
    assert found.pantographs[0].speed[0] == pytest.approx(SPEED, rel=1e-9)
    assert any("200 km/h, is not used: the file has times and" in note for note in found.notes)


def test_a_header_in_another_language(file: Path) -> None:
    file.write_text("Zeit [s];Kontaktkraft [N]\n0;100\n")
    expected = r'found "Zeit \[s\]", "Kontaktkraft \[N\]"; names that are known: time, position'
    with pytest.raises(MeasurementError, match=expected):
        read(file)


def test_accelerations_in_g(file: Path) -> None:
    columns = {
        "time [s]": times(), "position [m]": SPEED * times(), "sensor_force_1 [N]": force(times()),
        "acceleration_1 [g]": np.zeros(5000),
    }  # fmt: skip
    columns["acceleration_1 [g]"][::2] = 0.1
    columns["acceleration_1 [g]"][1::2] = -0.1
    for unit in ("g", "gn"):
        named = {name.replace("[g]", f"[{unit}]"): values for name, values in columns.items()}
        [found] = read(write(file, named), head=Head(10.0)).pantographs
        # F = ΣF_s − m a with a = 0.1 · 9.80665 m/s².
        assert found.force[0] == pytest.approx(force(times())[0] - 9.80665, rel=1e-9)


def test_a_speed_that_is_not_used_is_told(file: Path) -> None:
    head = "time [s],speed [km/h],contact_force [N]"
    rows = [f"{i / 500!r},200,{100 + i % 7}" for i in range(20)]
    found = read(_written(file, text(*rows, head=head)), speed="250 km/h")
    assert any("the speed given, 250 km/h, is not used" in note for note in found.notes)
    assert 3.6 * found.pantographs[0].speed[0] == pytest.approx(200.0, rel=1e-12)


def _written(file: Path, content: str) -> Path:
    file.write_bytes(content.encode())
    return file
