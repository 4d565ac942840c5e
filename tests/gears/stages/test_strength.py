"""The strength stage against the worked cases of the textbook, through specs; the torque and where it comes from."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from machines import spec_text

import tmmcalc
from gears.stages.trains import AI, AIBAR, CASES, LOADED, STEEL, UNFOLDED, at, permissible, sized
from tmmcalc.core.errors import UsageError
from tmmcalc.core.plan import plan
from tmmcalc.gears import sizing
from tmmcalc.gears.strength.explain import coefficients
from tmmcalc.pipeline.runner import run

TRAIN = f"[train]\n{AIBAR}\n[strength]\n{STEEL}"


def told(found: Any, row: int = 0) -> dict[tuple[str, str], float]:
    return {(each.of, each.symbol): each.value for each in coefficients(found.sets, found.task, row)}


def test_coefficients_of_an_unfolded_reducer() -> None:
    """GT-S12."""
    strength = 'torque = "22 N*m"\nface_width = 0.9\n' + STEEL.replace("one-sided", "two-sided")
    found, expected = told(sized(UNFOLDED, strength)), CASES["GT-S12"]["expected"]
    for of in ("wheel 1", "wheel 3"):
        assert found[of, "sigma_HP"] == pytest.approx(1e6 * expected["sigma_HP_MPa"], rel=1e-6)
        assert found[of, "sigma_FP"] == pytest.approx(1e6 * expected["sigma_FP_MPa"], rel=1e-6)
        assert found[of, "K_FC"] == expected["K_FC"]
        assert found[of, "S_H"] == expected["S_H"]
    for stage, mesh in ((1, "1-2"), (2, "2'-3")):
        own = expected[f"stage{stage}"]
        for symbol in ("K_Hbeta", "K_Fbeta"):
            assert found[f"stage {stage}", symbol] == pytest.approx(own[symbol], abs=1e-9)
        for symbol in ("A_H", "A_F"):
            assert 1000 * found[f"mesh {mesh}", symbol] == pytest.approx(own[symbol], abs=1e-4)


def test_coefficients_of_single_planets() -> None:
    """GT-S13."""
    stresses = 'permissible_contact = "609 MPa"\npermissible_bending = "200.6 MPa"\n'
    found, expected = told(sized(AIBAR, f"torque = 66\nface_width = 0.6\n{stresses}")), CASES["GT-S13"]["expected"]
    assert 1000 * found["mesh 1-2", "A_H"] == pytest.approx(expected["A_H"], abs=1e-4)
    assert 1000 * found["mesh 1-2", "A_F"] == pytest.approx(expected["A_F"], abs=1e-4)
    assert found["stage 1", "K_Hbeta"] == pytest.approx(expected["K_Hbeta"], abs=1e-9)
    assert found["stage 1", "K_Fbeta"] == pytest.approx(expected["K_Fbeta"], abs=1e-9)


DESIGNS = {  # case: train, stresses with its coefficients, names of its columns
    "GT-S14": (UNFOLDED, permissible([(31.66, 7.53, 3), (32.2, 7.26, 5)], 22.0, 1, 0.9), ("m1_H", "m2_H")),
    "GT-S15": (AIBAR, permissible([(38.85, 9.83, 1)], 66.0, 3, 0.6), ("m_H",)),
    "GT-S16": (AI, permissible([(40.55, 8.48, 1)] * 2, 75.0, 3, 0.6), ("m1_H", "m2_H")),
}


@pytest.mark.parametrize("case", DESIGNS)
def test_required_modules(case: str) -> None:
    train, strength, names = DESIGNS[case]
    found = sized(train, strength)
    for row in CASES[case]["expected"]["rows"]:
        place = at(found.sets.teeth, row["z"])
        for k, name in enumerate(names):
            contact, bending = 1000 * found.strength.contact_module[place, k], found.strength.bending_module[place, k]
            assert contact == pytest.approx(row[name], abs=1e-4)
            assert 1000 * bending == pytest.approx(row[name.replace("H", "F")], abs=1e-4)


def test_sets_that_the_textbook_rejects() -> None:
    """GT-S16: with m1 = 2 mm the second stage has 3.5 mm, which is not enough for all."""
    train, strength, _ = DESIGNS["GT-S16"]
    found = sized(train, strength + 'on_overload = "reject"\n')
    case = CASES["GT-S16"]
    needed = {tuple(row["z"]): (row["m1_H"], max(row["m2_H"], row["m2_F"])) for row in case["expected"]["rows"]}
    for teeth, (first, second) in needed.items():
        place = at(found.sets.teeth, list(teeth))
        if first > 1.75:  # stage 1 asks for 2 mm, as in the case
            assert found.strength.accepted[place] == (second <= 3.5), teeth
            assert found.strength.module[place].tolist() == [0.002, 0.0035]


def test_torque_from_a_moment() -> None:
    """GT-S23: the total torque, divided by the number of planets in the formulas alone."""
    found = sized(AI, f"moment = 1980\nmoment_ratio = 15\n{STEEL}")
    assert found.torque.value == CASES["GT-S23"]["expected"]["T1_total_Nm"]
    assert told(found)["mesh 1-2", "T"] == CASES["GT-S23"]["expected"]["T1_per_branch_Nm"]
    own = sized(AI, f"moment = 1980\n{STEEL}")
    assert own.torque.value == pytest.approx(1980 / 31.29, rel=1e-15)
    assert own.beyond == 1.0
    assert found.beyond == pytest.approx(15 / 31.29, rel=1e-15)


def test_torque_from_the_machine() -> None:
    """T1 is the largest reduced moment over i_1H; the moment as the power stage of a machine without losses has it."""
    spec = tmmcalc.parse_spec(spec_text(more=TRAIN))
    result = run(spec, target="strength").results
    torque = result["strength"].variants[0].torque
    cycle = result["reduction"].cycle
    theta = np.linspace(0, cycle.period, 200_001)[:-1]
    moment = np.abs(cycle.panels.at(cycle.moment + cycle.viscous * cycle.speed, theta)).max()
    assert torque.source == "reduction"
    assert torque.moment == pytest.approx(moment, rel=1e-6)
    assert torque.moment >= moment
    assert torque.value == torque.moment / 7.29


def test_a_torque_that_is_given_needs_no_machine() -> None:
    given = tmmcalc.parse_spec(spec_text(more=TRAIN + "torque = 20\n"))
    free = tmmcalc.parse_spec(spec_text(more=TRAIN))
    assert plan(given, "strength").running == ("train", "strength")
    assert plan(free, "strength").running == ("structure", "kinematics", "reduction", "train", "strength")


def test_without_anything_that_loads_the_crank_the_torque_is_not_known() -> None:
    spec = tmmcalc.parse_spec('[torque]\nspeed = 10\nformula = "0"\n' + TRAIN)
    with pytest.raises(UsageError, match="nothing loads the crank"):
        run(spec, target="strength")


def test_bounded_but_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = sized(AI, LOADED)
    monkeypatch.setattr(sizing, "first_sets", lambda sets: sizing.rows_of(sets, np.arange(4)))
    few = sized(AI, LOADED)
    assert (len(few.sets), few.count) == (4, whole.count) == (4, 11)
    assert np.array_equal(few.strength.width, whole.strength.width[:4])


def test_files_give_back_what_was_computed(tmp_path: Path) -> None:
    spec = tmmcalc.parse_spec(f"[train]\n{AIBAR}planets = [3, 4]\n[strength]\n{LOADED}")
    first, again = (run(spec, out=tmp_path, target="strength") for _ in range(2))
    assert [event.kind for event in again.events if event.stage == "strength"] == ["loaded"]
    for one, other in zip(first.results["strength"].variants, again.results["strength"].variants, strict=True):
        assert one.task == other.task
        assert one.torque == other.torque
        assert one.strength.coefficients == other.strength.coefficients
        for name in ("module", "width", "psi", "outcome", "contact_stress", "width_unusual"):
            assert np.array_equal(getattr(one.strength, name), getattr(other.strength, name))
    header, *rows = (tmp_path / "strength.csv").read_text().splitlines()
    assert header.startswith("i,layout,K,z_1,z_2,z_3,m_H_1[m],m_F_1[m],governs_1,m_1[m],psi_1,b_1[m],")
    assert len(rows) == len(first.results["strength"].variants[0].sets)
