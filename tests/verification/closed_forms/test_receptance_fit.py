"""Pantographs from measured frequency responses

The receptance H(iω) = eᵀ(K + iωC − ω²M)⁻¹ e of a shipped pantograph at its head, by a dense solve,
at 0.2, 0.3, … 25 Hz, is given to the program as a measurement of an unknown pantograph, with
normal noise of 0, 1 and 5 % of each value in its real and imaginary part. Without noise the masses,
springs and dampers themselves must be found: no other chain has the same receptance at its head.
With noise σ at N frequencies and p parameters, to first order of the noise,

    mean over frequencies and draws of |ln(H_found/H)|² = p σ²/N

and the true value lies within ± in 95 % of draws (Seber & Wild: Nonlinear Regression, Wiley 1989,
chapter 2). The contact force follows from 1/(1/k_c + H + H_line): an error of H changes it by
H/(1/k_c + H + H_line) times as much, with either sign along the spectrum.

The program is asked by `fit` for the order of the shipped pantograph, and the model file that it
writes is read again; its receptance is that of the file's matrices by a dense solve. The reference
line is run with both.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import arcless
from arcless.model import Pantograph, load_pantograph
from arcless.model.load import load_text
from arcless.pantograph import receptance as fits
from arcless.pantograph.receptance import measured as measuring
from arcless.results import Result
from tests.support.faults import Fault
from tests.support.python_faults import wrong
from tests.support.receptances import FREQUENCIES, measured, receptance

SHIPPED = ["en50318-2002", "two-mass-study", "ac-simple", "dsa-250", "faiveley-cx", "sss-400"]
BEYOND = np.geomspace(0.02, 200.0, 400)
DRAWS = 40
LINE, PANTOGRAPH = "en50318-ac-simple-275-planar", "ac-simple"


def found_for(name: str, noise: float = 0.0, seed: int = 1) -> tuple[fits.Fit, Pantograph]:
    """Return the fit of a shipped pantograph's own order, and the pantograph in its file."""
    order = len(load_pantograph(name).masses)
    one = fits.fit(measured(name, noise, seed), order)
    again = load_text(fits.text(one, "found"), "found.yaml")
    assert isinstance(again, Pantograph)
    return one, again


@pytest.mark.parametrize("name", SHIPPED)
def test_without_noise(evidence: Any, name: str) -> None:
    one, again = found_for(name)
    model = load_pantograph(name)
    for kind, small in (("mass", 0.0), ("stiffness", 1.0), ("damping", 1.0)):
        true = np.array([getattr(part, kind) for part in model.masses])
        got = np.array([getattr(part, kind) for part in again.masses])
        evidence.below(
            f"{name}: {kind}, worst of {len(true)}, relative (of numbers below 1 to 1)",
            float(np.max(np.abs(got - true) / np.maximum(true, small or 1e-9))),
            1e-5,
            unit="1",
            reason="7 digits of the file; dampers of 0 are at the edge of the search, where the sum"
            " of squares, ended at rounding 1e-16, is flat to its root of 1e-8, some hundred times",
        )
    ratio = receptance(again, BEYOND) / receptance(name, BEYOND)
    evidence.below(
        f"{name}: receptance of the file's matrices, worst of 0.02 to 200 Hz",
        float(np.max(np.abs(ratio - 1.0))),
        1e-4,
        unit="1",
        reason="7 digits of the file, 5e-8, times the largest sharpness of a mode, 1/2ζ below 1000",
    )
    own = one.chain.receptance(FREQUENCIES) / receptance(again)
    evidence.below(
        f"{name}: receptance that the fit shows over that of its file, worst",
        float(np.max(np.abs(own - 1.0))),
        1e-4,
        unit="1",
        reason="as above",
    )


@pytest.mark.parametrize("noise", [0.01, 0.05])
@pytest.mark.parametrize("name", ["en50318-2002", "ac-simple"])
def test_with_noise(evidence: Any, name: str, noise: float) -> None:
    one, again = found_for(name, noise)
    expected = noise * np.sqrt(one.chain.parameters / FREQUENCIES.size)
    error = np.log(receptance(again) / receptance(name))
    evidence.below(
        f"{name}, noise {100 * noise:g} %: error of the receptance, root mean square",
        float(np.sqrt(np.mean(np.abs(error) ** 2))),
        2.0 * expected,
        unit="1",
        reason="twice σ√(p/N): χ² of six to nine parameters is above four times its mean once in"
        " 1e5 draws; one draw is made, always the same",
    )
    evidence.close(
        f"{name}, noise {100 * noise:g} %: misfit",
        one.misfit,
        noise,
        unit="1",
        relative=0.15,
        reason="the spread of 498 squares is √(2/498)/2 = 3 %, and p parameters take 1 %; five of"
        " these",
    )


@pytest.mark.evidence
def test_how_sure(evidence: Any) -> None:
    name, noise = "en50318-2002", 0.05
    (true,) = [one for one in found_for(name)[0].modes if one.damping_ratio < 1.0]
    inside = 0
    for seed in range(DRAWS):
        one, _ = found_for(name, noise, 100 + seed)
        (mode,) = [mode for mode in one.modes if mode.damping_ratio < 1.0]
        inside += abs(mode.frequency_Hz - true.frequency_Hz) <= mode.frequency_sure_Hz
    evidence.within(
        f"{name}, noise 5 %: of {DRAWS} draws, true frequency of the swinging mode within ±",
        float(inside),
        low=33.0,
        high=40.0,
        unit="1",
        reason="38 expected; less than 33 of 40 once in a hundred sets of draws",
    )


@pytest.mark.evidence
@pytest.mark.parametrize("noise", [0.0, 0.05])
def test_a_run_with_it(evidence: Any, run_once: Callable[..., Result], noise: float) -> None:
    one, again = found_for(PANTOGRAPH, noise)
    scenario = arcless.load(LINE)
    known = run_once(LINE).assessment.pantographs[0]
    found = arcless.run(scenario.with_(**{"pantographs.0.model": again})).assessment.pantographs[0]
    allowed = 2.0 * noise * np.sqrt(one.chain.parameters / FREQUENCIES.size) + 1e-4
    for what, value, reference in (
        ("σ", found.std_force_N, known.std_force_N),
        ("F_max − F_m", found.max_force_N - found.mean_force_N,
         known.max_force_N - known.mean_force_N),
    ):  # fmt: skip
        evidence.close(
            f"{LINE}, noise {100 * noise:g} %: {what}",
            value,
            reference,
            unit="N",
            relative=allowed,
            reason="twice the expected error of the receptance, σ√(p/N), and digits of the file",
        )


FAULTS = [
    Fault("amplitude read 1 % high", wrong(measuring, "as_receptance", lambda h: 1.01 * h),
          test_without_noise, name="ac-simple"),
    Fault("phase read 1° late", wrong(measuring, "as_receptance", lambda h: h * np.exp(-0.0175j)),
          test_without_noise, name="ac-simple"),
    Fault("± by one standard deviation in place of 95 %",
          wrong("arcless.pantograph.receptance.fit", "confidence", lambda found: type(found)(
              found.root / 2.0, found.open, found.sizes)), test_how_sure, slow=True),
]  # fmt: skip
