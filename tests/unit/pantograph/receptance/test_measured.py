"""Tables of frequency responses: quantities, units, and what is refused."""

from pathlib import Path

import numpy as np
import pytest

from arcless.errors import ArclessError, MeasurementError, ModelError
from arcless.pantograph.receptance import QUANTITIES, of_arrays, read
from tests.support.receptances import FREQUENCIES, measured, table

UNITS = {
    "receptance": "m/N", "mobility": "m/s/N", "accelerance": "(m/s²)/N", "dynamic_stiffness": "N/m",
    "impedance": "N s/m", "apparent_mass": "kg",
}  # fmt: skip
ROWS = "0.5, 2, -40\n1, 1, -100\n2, 0.3, -140\n4, 0.1, -60\n8, 0.2, -90\n16, 0.01, -170\n"
HEAD = "frequency [Hz], receptance [mm/N], phase [deg]\n"


def written(folder: Path, text: str) -> Path:
    file = folder / "head.csv"
    file.write_text(text, "utf-8")
    return file


def refused(folder: Path, text: str, *words: str, by: type[ArclessError]) -> None:
    file = written(folder, text)
    with pytest.raises(by) as caught:
        read(file)
    for word in (str(file), *words):
        assert word in str(caught.value)


@pytest.mark.parametrize("quantity", QUANTITIES)
def test_every_quantity_is_the_same_receptance(tmp_path: Path, quantity: str) -> None:
    data = measured("ac-simple")
    found = read(written(tmp_path, table(data, quantity, UNITS[quantity])))
    # Twelve digits are written, of amplitude and phase.
    np.testing.assert_allclose(found.values, data.values, rtol=1e-10)
    np.testing.assert_array_equal(found.frequency, FREQUENCIES)
    assert found.quantity == quantity
    assert len(found.digest) == 12


def test_units_phases_and_errors(tmp_path: Path) -> None:
    text = (
        "# bench 3\nphase [rad], frequency [kHz], receptance [mm/kN], relative_error %\n"
        + "".join(f"{-0.5 + 2 * np.pi * (k % 3)}, {k}e-3, 1e3, {k}\n" for k in range(1, 8))
    )  # fmt: skip
    data = read(written(tmp_path, text))
    np.testing.assert_allclose(data.frequency, np.arange(1.0, 8.0), rtol=1e-15)
    # Phases are those of whole turns further, to the rounding of the text.
    np.testing.assert_allclose(data.values, 1e-3 * np.exp(-0.5j), rtol=1e-12)
    assert data.error is not None
    np.testing.assert_allclose(data.error, np.arange(1, 8) / 100.0, rtol=1e-15)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (HEAD.replace(" [mm/N]", "") + ROWS, ("unit missing", "a compliance (m/N")),
        (HEAD.replace("[mm/N]", "[N/m]") + ROWS, ("N/m is the unit of a stiffness",)),
        (HEAD.replace("[deg]", "[Hz]") + ROWS, ("column phase", "an angle")),
        (HEAD.replace(", phase [deg]", ", angle [deg]") + ROWS, ("unknown column",)),
        (HEAD.replace("frequency [Hz], ", "") + "1, 2\n", ("no frequency",)),
        (HEAD.replace("receptance", "mobility").replace("mm/N", "m/N") + ROWS, ("a mobility",)),
        (HEAD + ROWS.replace("0.3", "nan"), (":4", "receptance", "nan")),
        (HEAD + ROWS.replace("0.3", ""), (":4", "empty cell")),
        (HEAD.replace(",", ";") + ROWS.replace(",", ";"), ("separate the columns by commas",)),
    ],
)
def test_tables_that_are_none(tmp_path: Path, text: str, words: tuple[str, ...]) -> None:
    refused(tmp_path, text, *words, by=ModelError)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (HEAD + ROWS.replace("2, 0.3", "1, 0.3"), ("row 3", "1 Hz after 1 Hz", "sort the rows")),
        (HEAD + ROWS.replace("0.5, 2", "0, 2"), ("0 Hz", "leave the row of 0 Hz out")),
        (HEAD + ROWS.replace("0.3", "0"), ("row 3", "an amplitude above 0")),
        (HEAD + "\n".join(ROWS.splitlines()[:5]), ("number of frequencies", "got 5")),
        (HEAD.replace("deg", "rad") + ROWS, ("170 rad", "write phase [deg]")),
        (HEAD + ROWS.replace("-", ""), ("not passive", "at 0.5, 1, 2, 4, 8 Hz,",
                                        "count a lag as negative")),
        (HEAD + ROWS.replace("-140", "100"), ("not passive", "at 2 Hz, by 80° at 2 Hz",
                                              "of one point")),
        (HEAD + ROWS.replace("-170", "140"), ("not passive", "at 16 Hz", "a delay")),
        (HEAD.replace("\n", ", relative_error %\n") + ROWS.replace("\n", ", 0\n"),
         ("relative_error", "above 0")),
        # Its square outweighs all others: found by the hostile campaign, seed 377.
        (HEAD.replace("\n", ", relative_error %\n") + ROWS.replace("\n", ", 3\n")
         .replace(", 3\n", ", 3e-300\n", 1), ("relative_error", "values below 1e-09")),
        (HEAD + ROWS.replace("0.01", "1e-20"), ("twelve powers of ten",)),
    ],
)  # fmt: skip
def test_measurements_that_are_none(tmp_path: Path, text: str, words: tuple[str, ...]) -> None:
    refused(tmp_path, text, *words, by=MeasurementError)


def test_noise_about_the_limits_of_a_passive_phase_is_none(tmp_path: Path) -> None:
    data = read(written(tmp_path, HEAD + ROWS.replace("-170", "170").replace("-40", "14")))
    assert np.degrees(data.outside.max()) == pytest.approx(14.0)  # rounding
    assert np.count_nonzero(data.outside) == 2


def test_arrays() -> None:
    f = np.arange(1.0, 8.0)
    with pytest.raises(MeasurementError, match="quantity"):
        of_arrays(f, f + 0j, quantity="inertance")
    with pytest.raises(MeasurementError, match="a finite number"):
        of_arrays(f, np.full(7, np.nan))
    with pytest.raises(MeasurementError, match="a finite number"):
        of_arrays(f, np.full(6, 1.0))
    with pytest.raises(MeasurementError, match="frequencies"):
        of_arrays([*f, np.inf], np.full(8, 1.0))
