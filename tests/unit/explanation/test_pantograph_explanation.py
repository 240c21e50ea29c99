"""Explanations of forces whose shares are known, with noise, unequal spans and modes."""

import numpy as np
import pytest

from arcless.errors import ExplanationError
from arcless.pantograph.natural_modes import Band, PantographMode
from tests.support.passages import EQUAL, MODE, UNEQUAL, explain_force, line_of, share

SPAN, DROPPER, MODAL = 20.0, 12.0, 6.0  # amplitudes, N


def known(noise_N: float = 0.0, seed: int = 0):
    random = np.random.default_rng(seed)

    def force(t, x, xi, psi):
        return (
            SPAN * np.cos(2.0 * np.pi * xi + 0.3)
            + DROPPER * np.cos(2.0 * np.pi * psi - 1.0)
            + MODAL * np.cos(2.0 * np.pi * MODE.frequency.middle * t)
            + noise_N * random.normal(size=t.size)
        )

    return force


@pytest.mark.parametrize("spans", [EQUAL, UNEQUAL])
def test_shares_are_those_that_were_written_down(spans) -> None:
    found = explain_force(line_of(spans), known())
    total = SPAN**2 + DROPPER**2 + MODAL**2
    wanted = {"span": SPAN**2, "droppers": DROPPER**2, "pantograph": MODAL**2, "rest": 0.0}
    for key, square in wanted.items():
        # Of equal spans all waves are whole in the section: rounding. Of unequal ones the mode ends
        # within a period and leaks 1/2πn of its amplitude to lines n further on, and the dropper
        # wave has 3 % of its amplitude in orders of the span.
        room = 1e-9 if spans == EQUAL else 2.0
        assert share(found, key) == pytest.approx(100.0 * square / total, abs=room), key
    assert sum(one.share_percent for one in found.groups) == pytest.approx(100.0, rel=1e-9)
    assert found.std_force_N == pytest.approx(np.sqrt(total / 2.0), rel=0.02)


@pytest.mark.parametrize("spans", [EQUAL, UNEQUAL])
def test_noise_is_rest_and_chance_says_how_much_of_it_repeats(spans) -> None:
    # White noise up to 200 Hz: the low-pass is not part of a passage.
    line = line_of(spans)
    found = [explain_force(line, known(5.0, seed)) for seed in range(12)]
    total = (SPAN**2 + DROPPER**2 + MODAL**2) / 2.0 + 25.0
    rest = np.mean([share(one, "rest") for one in found])
    columns = 2 * len(found[0].orders)
    taken = columns / found[0].trace.position_m.size
    band = 2.0 * (MODE.frequency.high * 1.01 - MODE.frequency.low * 0.99) / 400.0
    wanted = 100.0 * 25.0 * (1.0 - taken - band) / total
    assert rest == pytest.approx(wanted, abs=2.0)  # leakage, as above
    for key, square in (("span", SPAN**2), ("droppers", DROPPER**2)):
        group = [next(one for one in each.groups if one.key == key) for each in found]
        by_chance = np.mean([one.chance_percent for one in group])
        mean = np.mean([one.share_percent for one in group])
        # Leakage, and the mean of twelve passages with an uncertainty of 2 % each, three times.
        assert mean == pytest.approx(50.0 * square / total + by_chance, abs=2.0)


def test_the_uncertainty_is_the_spread_over_passages() -> None:
    """Sixty passages with the same orders and other noise: their spread is the uncertainty told."""
    line = line_of(EQUAL)

    def force(seed):
        random = np.random.default_rng(seed)
        return lambda t, x, xi, psi: (
            SPAN * np.cos(2.0 * np.pi * xi) + 30.0 * random.normal(size=t.size)
        )

    found = [explain_force(line, force(seed), modes=()) for seed in range(60)]
    variances = np.array([one.groups[0].variance_N2 for one in found])
    told = np.mean(
        [one.groups[0].uncertainty_percent / 100.0 * one.std_force_N**2 for one in found]
    )
    # The spread of 60 numbers is known to 1/√120 = 9 %; three times that.
    assert variances.std() == pytest.approx(told, rel=0.3)
    # The mean is that of the wave, and what chance gives: 10 columns of 900/4800.
    assert variances.mean() == pytest.approx(
        SPAN**2 / 2.0 + 10 * 900 / 4800, abs=3 * told / 60**0.5
    )


def test_a_longer_section_is_surer() -> None:
    def uncertainty(count):
        random = np.random.default_rng(5)
        found = explain_force(
            line_of((60.0,) * count),
            lambda t, x, xi, psi: (
                SPAN * np.cos(2.0 * np.pi * xi) + 30.0 * random.normal(size=t.size)
            ),
        )
        return found.groups[0].uncertainty_percent

    # As one over the root of the length: four times as long, half as unsure; ± 20 % of noise.
    assert uncertainty(10) / uncertainty(40) == pytest.approx(2.0, rel=0.2)


def test_modes_have_what_repeats_in_their_band_as_well() -> None:
    # Order 4 of the span passes at 3.33 Hz, inside the band of the mode.
    found = explain_force(
        line_of(EQUAL),
        lambda t, x, xi, psi: 10.0 * np.cos(2.0 * np.pi * 4 * xi) + 10.0 * np.cos(2.0 * np.pi * xi),
        modes=[PantographMode(Band(3.2, 3.3, 3.4), 0.01, 0.5)],
    )
    (mode,) = found.modes
    assert mode.share_percent == pytest.approx(0.0, abs=1e-9)
    assert mode.in_band_percent == pytest.approx(50.0, abs=1e-6)  # rounding
    assert [one.mode for one in found.orders[:5]] == [None, None, None, 1, None]


def test_every_number_is_there_as_plain_data() -> None:
    import json

    found = explain_force(line_of(EQUAL), known(1.0))
    data = json.loads(json.dumps(found.to_dict(), allow_nan=False))
    assert [one["key"] for one in data["groups"]] == ["span", "droppers", "pantograph", "rest"]
    assert len(data["by_span"]) == 10
    assert len(data["worst"]) == 10
    assert "trace" not in data


def test_a_section_of_less_than_two_spans_is_refused() -> None:
    with pytest.raises(ExplanationError, match=r"60 to 170 m, 1\.8 spans, expected at least 2"):
        explain_force(line_of(EQUAL), known(), ends=(60.0, 170.0))
    # As many decimals as tell what was given from what is expected.
    with pytest.raises(ExplanationError, match=r"60 to 179 m, 1\.98 spans, expected at least 2"):
        explain_force(line_of(EQUAL), known(), ends=(60.0, 179.0))
    assert explain_force(line_of(EQUAL), known(), ends=(60.0, 180.0)).spans_in_section == 2.0


def test_a_constant_force_is_refused() -> None:
    with pytest.raises(ExplanationError, match="the contact force is constant"):
        explain_force(line_of(EQUAL), lambda t, x, xi, psi: np.zeros_like(t))


def test_spans_that_pass_too_fast_are_refused() -> None:
    with pytest.raises(ExplanationError, match=r"33\.3 spans a second, expected at most 25"):
        explain_force(line_of((1.5,) * 40, None), lambda t, x, xi, psi: np.cos(t))


def test_two_spans_with_unequal_droppers_are_too_short_to_be_sure() -> None:
    found = explain_force(line_of((48.0, 66.0)), known(1.0))
    assert found.groups[1].uncertainty_percent is None
    assert "too short to state the uncertainty" in found.sentences()[0]


def test_a_line_without_droppers_has_spans_only() -> None:
    found = explain_force(line_of(EQUAL, None), known())
    assert share(found, "droppers") == 0.0
    assert found.groups[1].strongest is None
    assert all(one.of_droppers is None for one in found.orders)
