"""The table of units: definitions, and one meaning for each spelling."""

import pytest
from scipy import constants

from arcless.units import KINDS, spell, to_si
from arcless.units.kinds import ALIASES

# Scipy has its constants from elsewhere than we have ours.
KNOWN = {
    "kgf": constants.kgf, "lbf": constants.lbf, "lb": constants.lb, "in": constants.inch,
    "ft": constants.foot, "yd": constants.yard, "mi": constants.mile, "mph": constants.mph,
    "km/h": constants.kmh, "deg": constants.degree, "gn": constants.g,
}  # fmt: skip


@pytest.mark.parametrize(("name", "known"), KNOWN.items())
def test_units_are_those_of_scipy(name: str, known: float) -> None:
    (found,) = (kind.units[name] for kind in KINDS.values() if name in kind.units)
    # Scipy multiplies rounded numbers, two or three times.
    assert float(found) == pytest.approx(known, rel=1e-15)


def test_a_unit_that_is_made_of_others_has_their_size() -> None:
    sizes = {name: float(size) for kind in KINDS.values() for name, size in kind.units.items()}
    for made, size in {
        "lb/ft": sizes["lb"] / sizes["ft"],
        "lb/ft3": sizes["lb"] / sizes["ft"] ** 3,
        "lbf·in2": sizes["lbf"] * sizes["in"] ** 2,
        "lbf·ft2": sizes["lbf"] * sizes["ft"] ** 2,
        "lb·ft2": sizes["lb"] * sizes["ft"] ** 2,
        "lbf/in": sizes["lbf"] / sizes["in"],
        "lbf/ft": sizes["lbf"] / sizes["ft"],
        "lbf·s/in": sizes["lbf"] / sizes["in"],
        "lbf·s/ft": sizes["lbf"] / sizes["ft"],
        "lbf·ft/rad": sizes["lbf"] * sizes["ft"],
        "lbf·ft·s/rad": sizes["lbf"] * sizes["ft"],
        "lbf/s": sizes["lbf"],
        "kgf/m": sizes["kgf"],
        "kgf/mm": sizes["kgf"] / sizes["mm"],
        "kgf·s/m": sizes["kgf"],
        "kgf·m2": sizes["kgf"],
        "kgf·m/rad": sizes["kgf"],
        "kgf·m·s/rad": sizes["kgf"],
        "kgf/s": sizes["kgf"],
        "kgf/mm2": sizes["kgf"] / sizes["mm"] ** 2,
        "daN/m": sizes["daN"],
        "kN/mm": sizes["kN"] / sizes["mm"],
        "N·mm2": sizes["mm"] ** 2,
        "g/cm3": sizes["g"] / sizes["cm"] ** 3,
        "t/m3": sizes["t"],
        "tf": 1000 * sizes["kgf"],
        "chain": 22 * sizes["yd"],
        "mi": 80 * sizes["chain"],
        "mph": sizes["mi"] / 3600,
        "ft/s": sizes["ft"],
    }.items():
        # A handful of roundings of the expected size.
        assert sizes[made] == pytest.approx(size, rel=1e-14), made


def test_a_unit_belongs_to_one_kind() -> None:
    names = [name for kind in KINDS.values() for name in kind.units]
    assert len(names) == len(set(names))


@pytest.mark.parametrize(("alias", "name"), ALIASES.items())
def test_an_alias_is_another_spelling(alias: str, name: str) -> None:
    (unit,) = (unit for unit, kind in KINDS.items() if name in kind.units)
    assert alias not in KINDS[unit].units
    assert to_si(f"3 {alias}", unit) == to_si(f"3 {spell(name)}", unit)
