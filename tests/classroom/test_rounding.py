"""What is zero by symmetry and not in the last digits: asked with how far from it an answer may be, and told as 0."""

from __future__ import annotations

from pathlib import Path

import pytest
from mistakes import item, key

from tmmcalc.classroom.document import class_document
from tmmcalc.classroom.items import items_of
from tmmcalc.classroom.making import make_class
from tmmcalc.core.errors import SpecError
from tmmcalc.naming.language import parse
from tmmcalc.naming.told import one
from tmmcalc.pipeline.runner import run
from tmmcalc.project.loader import parse_spec

CONFIGS = Path(__file__).parents[2] / "configs"
CENTRED = (CONFIGS / "crank-slider.toml").read_text(encoding="utf-8").replace('"-40 mm"', "0")
UPRIGHT = "kinematics.omega_2@3"  # the crank at 90 deg: the rod only shifts, omega_2 = 0 whatever its length
DRAWN = (
    '[[class.drawn]]\nof = "mechanism.links[id=1].points.A[0]"\nat_least = "90 mm"\nat_most = "110 mm"\n'
    'step = "2 mm"\n[[class.drawn]]\nof = "mechanism.links[id=2].points.B[0]"\nat_least = "300 mm"\n'
    'at_most = "340 mm"\nstep = "5 mm"\n'
)
ASKED = f'[[class.asked]]\nresult = "{UPRIGHT}"\nname = "w"\n'
STROKE = '[[class.asked]]\nresult = "kinematics.stroke_B"\n'


def test_the_machine_tells_no_clean_zero() -> None:
    """Else the tests below would test nothing."""
    results = run(parse_spec(CENTRED), target="kinematics").results
    assert 0 < abs(one(parse(UPRIGHT), results).value) < 1e-12


def test_a_zero_without_a_tolerance_of_its_own_is_a_fault() -> None:
    with pytest.raises(SpecError, match=r"class\.asked\[0\]: kinematics\.omega_2@3 is 0 here") as raised:
        items_of(parse_spec(f"{CENTRED}\n{DRAWN}{ASKED}"))
    assert "add within" in raised.value.faults[0].remedy
    items_of(parse_spec(f"{CENTRED}\n{DRAWN}{ASKED}".replace("@3", "@2")))


def test_a_zero_is_one_in_keys_whatever_its_last_digits() -> None:
    asked = (item(UPRIGHT, "rad/s", within=0.01), item("kinematics.omega_2@2", "rad/s"))
    found = key(CENTRED, asked, "classroom.sense_reversed")
    assert found.values[0] == 0.0
    assert found.mistaken[0] == pytest.approx((float("nan"), -found.values[1]), nan_ok=True)


def test_a_zero_has_no_spread_and_is_printed_as_0(tmp_path: Path) -> None:
    file = tmp_path / "centred.toml"
    file.write_text(f'{CENTRED}\n{DRAWN}{ASKED}within = "0.01 rad/s"\n{STROKE}', encoding="utf-8")
    made = make_class(file, tmp_path / "class", 5, 3, jobs=1)
    assert [each.values[0] for each in made.fresh] == [0.0] * 5
    table = class_document(made, "").table
    assert table is not None
    assert [column[0] for column in table.columns] == ["w", "rad/s", 0.0, 0.0, ""]
