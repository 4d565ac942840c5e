"""Columns by choice of the forces: worked cases of the press, differences of positions, dense sums of friction."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from loaded import anything, ready
from loaded import press as loaded_press
from ready import LINKAGES
from sparing import sparing

from linkage.forces.worked import CASES, press, press_loading
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.columns import columns as kinematic_columns
from tmmcalc.linkage.differentiation import differentiate
from tmmcalc.linkage.forces.columns import columns
from tmmcalc.linkage.forces.further import further_columns
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.forces.solve import solve_forces
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.loading import Body, Loading
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Kinematics

FRICTION, IDEAL = (CASES[f"dyn-press-{name}"]["expected"] for name in ("friction", "ideal"))
AGREE = {"rtol": 1e-5, "atol": 2e-4}


def made(mechanism: Mechanism, loading: Loading, kinematics: Kinematics, result: Forces) -> dict[str, np.ndarray]:
    found = further_columns(mechanism, loading, kinematics, result)
    assert len({column.name for column in found}) == len(found)
    assert not {column.name for column in found} & {column.name for column in columns(result)}
    return {column.name: column.make() for column in found}


@pytest.fixture(scope="module")
def worked() -> tuple[Forces, dict[str, np.ndarray]]:
    mechanism, kinematics = press()
    result = solve_forces(mechanism, press_loading(), kinematics)
    return result, made(mechanism, press_loading(), kinematics, result)


def numbered(result: Forces, values: np.ndarray) -> np.ndarray:
    """The rows of the case: at 270 deg it has the limit before."""
    labels = [str(i) if i != 9 else "9-" for i in range(13)]
    return values[[result.labels.index(label) for label in labels]]


def test_parts_of_the_reaction_arm_and_directions(worked: tuple[Forces, dict[str, np.ndarray]]) -> None:
    """Table D.3.2: R21 along and across the rod, h of the slider."""
    result, found = worked
    np.testing.assert_allclose(numbered(result, found["RT_A"]), FRICTION["R21T"], **AGREE)
    np.testing.assert_allclose(numbered(result, found["RN_A"]), FRICTION["R21N"], **AGREE)
    np.testing.assert_allclose(1e3 * numbered(result, found["h_B0"]), FRICTION["h_mm"], **AGREE)
    there = np.degrees(np.arctan2(FRICTION["R10y"], FRICTION["R10x"]))
    np.testing.assert_allclose(numbered(result, found["angle_R_O"]), there, rtol=1e-4)


def test_loads_of_inertia_and_ideal_reactions_beside_the_real_ones(
    worked: tuple[Forces, dict[str, np.ndarray]],
) -> None:
    """Table D.3.1: of the press without friction."""
    result, found = worked
    for name, key in (("Pi_2_x", "P2x"), ("Pi_2_y", "P2y"), ("Mi_2", "M2"), ("Pi_3_x", "P3"), ("M0_drive", "M_bal")):
        np.testing.assert_allclose(numbered(result, found[name]), IDEAL[key], err_msg=name, **AGREE)
    np.testing.assert_allclose(numbered(result, found["N0_B0"]), IDEAL["R30"], **AGREE)
    np.testing.assert_allclose(numbered(result, found["RT0_A"]), IDEAL["R21T"], **AGREE)
    np.testing.assert_allclose(numbered(result, found["RN0_A"]), IDEAL["R21N"], **AGREE)
    np.testing.assert_allclose(numbered(result, found["R0_A"]), np.hypot(IDEAL["R21T"], IDEAL["R21N"]), **AGREE)
    np.testing.assert_allclose(numbered(result, found["R0_B"]), np.hypot(IDEAL["R32x"], IDEAL["R32y"]), **AGREE)


def test_the_drive_by_the_lever_is_that_of_the_case(worked: tuple[Forces, dict[str, np.ndarray]]) -> None:
    """Table D.3.2: the balancing moment, which the lever finds from velocities and forces alone."""
    result, found = worked
    np.testing.assert_allclose(numbered(result, found["M_drive_lever"]), FRICTION["M_bal"], **AGREE)
    assert np.max(np.abs(found["M_drive_difference"])) < 1e-13 * np.max(np.abs(result.drive))


def test_friction_reduced_to_the_crank(worked: tuple[Forces, dict[str, np.ndarray]]) -> None:
    """dyn-press-reduced: M_F is the sum over the pairs."""
    result, found = worked
    total = sum(numbered(result, found[f"M_red_fr_{joint}"]) for joint in ("A", "B", "B0"))
    np.testing.assert_allclose(total, CASES["dyn-press-reduced"]["expected"]["M_F"], rtol=1e-4)
    np.testing.assert_allclose(found["P_fr_A"], 5.0 * found["M_red_fr_A"])


def test_work_of_friction(worked: tuple[Forces, dict[str, np.ndarray]]) -> None:
    """dyn-press-reduced: over the turn; and by the trapezoid over ten thousand positions pair by pair."""
    result, found = worked
    pairs = ("A", "B", "B0")
    assert sum(found[f"A_fr_{joint}"][-1] for joint in pairs) == pytest.approx(
        CASES["dyn-press-reduced"]["expected"]["A_F_fine"], rel=1e-4
    )
    mechanism, kinematics = press(7200)
    dense = solve_forces(mechanism, press_loading(), kinematics)
    powers = {column.name: column for column in further_columns(mechanism, press_loading(), kinematics, dense)}
    row = result.labels.index("8")
    upto = dense.theta <= result.theta[row] + 1e-9
    for joint in pairs:
        power = powers[f"P_fr_{joint}"].make()
        assert np.all(power <= 1e-12)
        work = np.trapezoid(power[upto], dense.theta[upto]) / abs(result.speed)
        assert found[f"A_fr_{joint}"][row] == pytest.approx(work, rel=1e-5)


def test_inertia_by_differences_of_positions() -> None:
    mechanism = ready("shaper")
    mechanism = replace(mechanism, input=replace(mechanism.input, acceleration=2.0))
    loading, kinematics = Loading((Body(4, 12.0, 0.1, 0.12 + 0j),)), solve_kinematics(mechanism)
    result = solve_forces(mechanism, loading, kinematics)
    found = made(mechanism, loading, kinematics, result)
    trace = differentiate(chain_of(mechanism, kinematics), kinematics.x, 1e-4)
    k, link = trace.point_names.index("S4"), trace.link_ids.index(4)
    a = kinematics.in_time(trace.dr[k], trace.ddr[k])[1]
    eps = kinematics.in_time(trace.dangle[link], trace.ddangle[link])[1]
    np.testing.assert_allclose(found["Pi_4_x"] + 1j * found["Pi_4_y"], -12.0 * a, atol=1e-4)
    np.testing.assert_allclose(found["Mi_4"], -0.1 * eps, atol=1e-5)


def test_parts_in_the_pins_of_a_slotted_link() -> None:
    """Section 3.2.3: T along the slot from B to A, N a quarter turn ahead; both pins in the same axes."""
    mechanism = ready("shaper")
    loading, kinematics = anything(mechanism), solve_kinematics(mechanism)
    result = solve_forces(mechanism, loading, kinematics)
    found = made(mechanism, loading, kinematics, result)
    usual = {column.name: column.make() for column in columns(result)}
    at = {column.name: column.make() for column in kinematic_columns(kinematics)}
    rows = [kinematics.labels.index(label.removesuffix("-")) for label in result.labels]
    along = np.exp(1j * np.arctan2(at["y_A"], at["x_A"]))[rows]  # B is the origin
    for joint in ("A", "B"):
        force = usual[f"R_{joint}_x"] + 1j * usual[f"R_{joint}_y"]
        np.testing.assert_allclose(
            (found[f"RT_{joint}"] + 1j * found[f"RN_{joint}"]) * along, force, atol=1e-9 * np.max(np.abs(force))
        )
    assert "RT_D" not in found  # an inner pair
    assert {"RT_C", "RN_C"} <= found.keys()


def test_a_light_block_without_friction_pushes_across_the_slot() -> None:
    """(3.8): R21T of a massless slider is nothing, so R21N is all of R21."""
    mechanism = ready("shaper")
    loading, kinematics = replace(anything(mechanism), pairs=()), solve_kinematics(mechanism)
    loading = replace(loading, bodies=tuple(body for body in loading.bodies if body.link != 2))
    loads = tuple(replace(load, link=3) if load.link == 2 else load for load in loading.loads)
    loading = replace(loading, loads=loads)
    result = solve_forces(mechanism, loading, kinematics)
    found = made(mechanism, loading, kinematics, result)
    size = np.max(np.abs(found["RN_A"]))
    assert np.max(np.abs(found["RT_A"])) < 1e-12 * size
    np.testing.assert_allclose(np.abs(found["RN_A"]), found["R0_A"], atol=1e-12 * size)


@sparing("name", LINKAGES, every=4, first=2)
def test_the_parts_in_outer_pins_make_up_the_reaction(name: str) -> None:
    mechanism = ready(name)
    loading, kinematics = anything(mechanism), solve_kinematics(mechanism)
    result = solve_forces(mechanism, loading, kinematics)
    found = made(mechanism, loading, kinematics, result)
    outer = {joint for group in kinematics.structure.groups if group.kind for joint in group.outer}
    for pair, reaction in zip(result.pairs, result.reaction, strict=True):
        parts = [found.get(f"R{part}_{pair.joint}") for part in "NT"]
        if pair.kind == "prismatic" or pair.joint not in outer:
            assert parts == [None, None]
            continue
        assert parts[0] is not None
        assert parts[1] is not None
        np.testing.assert_allclose(np.hypot(*parts), np.abs(reaction), rtol=1e-9)


@pytest.mark.parametrize("name", ["trammel", "scotch-yoke", "hydraulic-lift", "class-three"])
def test_every_column_has_a_value_a_row(name: str) -> None:
    mechanism = ready(name)
    loading, kinematics = anything(mechanism), solve_kinematics(mechanism)
    result = solve_forces(mechanism, loading, kinematics)
    for column, values in made(mechanism, loading, kinematics, result).items():
        assert np.shape(values) == result.theta.shape, column
        if not column.startswith(("h_", "angle_R_")) and "_h_" not in column:
            assert np.all(np.isfinite(values)), column


def test_a_force_that_is_nothing_has_no_direction_and_no_arm() -> None:
    mechanism, _, kinematics = loaded_press(friction=False)
    loading = Loading((Body(3, 24.0, 0.0, 0j),))  # the slider alone; without gravity
    kinematics = solve_kinematics(mechanism)
    result = solve_forces(mechanism, loading, kinematics)
    found = made(mechanism, loading, kinematics, result)
    empty = np.isnan(found["h_B0"])
    assert empty[0]  # at the dead centre the guide carries nothing
    assert np.array_equal(empty, np.isnan(found["angle_R_B0"]))
    assert np.all(found["h_B0"][~empty] == 0)


def test_nothing_is_solved_before_a_column_is_made(monkeypatch: pytest.MonkeyPatch) -> None:
    mechanism, kinematics = press()
    result = solve_forces(mechanism, press_loading(), kinematics)
    monkeypatch.setattr("tmmcalc.linkage.forces.rows.compile_scene", lambda *_: pytest.fail("solved"))
    assert further_columns(mechanism, press_loading(), kinematics, result)
