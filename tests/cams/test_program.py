"""The motion over the turn: phases, one-sided limits, jumps, rows of tables."""

import json
from math import pi, radians
from pathlib import Path

import numpy as np
import pytest

from cams.turns import overshooting, turn
from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.program import Phase, Program, of_step, of_steps, positions

CASES = {c["id"]: c for c in json.loads((Path(__file__).parents[1] / "cases/cams.json").read_text())}


def test_the_rise_of_the_guides_rocker_s06():
    case = CASES["cams-s06"]
    program = turn("linear", rise=45, high=30, back=60, stroke=0.050)
    found = 1e3 * program.at(np.radians(case["inputs"]["phi_deg"]))
    # the last row is the end of the rise: its own side
    for row, name in enumerate(("S_mm", "S1_mm", "S2_mm")):
        np.testing.assert_allclose(found[row], case["expected"][name], atol=1e-3)


@pytest.mark.parametrize("name", LAWS)
def test_derivatives_over_the_turn_by_differences(name):
    program = turn(name, "shun", rise=70, high=20, back=110, stroke=0.03)
    edges = program.edges
    middles = (edges[:-1] + edges[1:]) / 2
    h = 1e-4 * np.diff(edges)
    numbers = np.arange(len(middles))
    before, after = (program.at(middles + k * h, numbers) for k in (-1, 1))
    slope = (after - before)[:3] / (2 * h)
    np.testing.assert_allclose(program.at(middles, numbers)[1:], slope, rtol=1e-6, atol=1e-6)


@pytest.mark.parametrize("name", LAWS)
def test_the_return_is_the_rise_backwards(name):
    program = turn(name, rise=60, high=30, back=60)
    into = np.radians([0.0, 7.0, 22.0, 41.0, 60.0])
    rise, back = program.at(into), program.at(radians(150) - into)
    np.testing.assert_allclose(back[0], rise[0], atol=1e-16)
    np.testing.assert_allclose(back[1:], [-rise[1], rise[2], -rise[3]], rtol=1e-11, atol=1e-11)


def test_dwells_are_still():
    program = turn("cosine")
    rows = program.at(np.radians([61.0, 75.0, 89.0, 151.0, 300.0, 359.0]))
    np.testing.assert_array_equal(rows[0], [0.02, 0.02, 0.02, 0, 0, 0])
    np.testing.assert_array_equal(rows[1:], 0)


def test_jumps_of_the_acceleration_at_the_ends_of_the_phases():
    """Cosine: s'' = +-pi^2/2 at its ends."""
    program = turn("cosine", rise=60, high=30, back=90)
    size = 0.02 * pi**2 / 2
    wanted = {0: size / (pi / 3) ** 2, 60: size / (pi / 3) ** 2, 90: -size / (pi / 2) ** 2, 180: -size / (pi / 2) ** 2}
    found = dict(zip(np.degrees(program.edges[:-1]).round(9).tolist(), program.jumps[2].tolist(), strict=True))
    assert found == pytest.approx(wanted, rel=1e-12)
    np.testing.assert_array_equal(program.jumps[:2], 0)


def test_no_jump_where_equal_cosines_meet_without_dwells():
    """Rise and return of half a turn each: one harmonic."""
    program = turn("cosine", rise=180, high=0, back=180)
    np.testing.assert_array_equal(program.jumps, 0)
    phi = np.linspace(0, 2 * pi, 50)
    np.testing.assert_allclose(program.at(phi)[0], 0.01 * (1 - np.cos(phi)), atol=1e-16)


@pytest.mark.parametrize("name", sorted(set(LAWS) - {"cosine", "linear", "const"}))
def test_rounding_is_not_taken_for_a_shock(name):
    np.testing.assert_array_equal(turn(name, rise=83, high=21, back=77).jumps[:3], 0)


def test_one_sided_values_at_an_edge():
    program = turn("const")
    edge = np.array([program.edges[1]] * 2)
    size = 0.02 * 4 / (pi / 3) ** 2
    np.testing.assert_allclose(program.at(edge, np.array([0, 1]))[2], [size, -size])


def test_the_moving_side_at_the_end_of_a_phase():
    program = turn("cosine")
    found = program.at(np.radians([60.0, 90.0, 150.0]))[2]
    assert np.all(np.abs(found) > 0)


def test_rows_in_steps_with_both_limits():
    program = turn("cosine", "shun", rise=60, high=30, back=60)
    rows = of_steps(program, 4)
    assert rows.labels == ("0", "1", "2", "3", "4-", "4", "5", "6", "7", "8", "9", "10")
    np.testing.assert_allclose(np.degrees(rows.phi), [0, 15, 30, 45, 60, 60, 90, 105, 120, 135, 150, 360], atol=1e-12)
    motion = program.at(rows.phi, rows.piece)
    assert motion[2, 4] < 0
    assert motion[2, 5] == 0


def test_rows_inside_a_law_with_a_jump():
    rows = of_steps(turn("const", rise=60, high=30, back=60), 2)
    assert rows.labels[:7] == ("0", "1-", "1", "2-", "2", "3-", "3")
    np.testing.assert_array_equal(rows.piece[:7], [0, 0, 1, 1, 2, 2, 3])


def test_rows_at_equal_steps_hold_the_ends_of_the_phases():
    program = turn("sine", rise=61.5, high=20, back=80.25)
    rows = of_step(program, radians(1))
    degrees = np.degrees(rows.phi).round(9)
    assert {61.5, 81.5, 161.75, 0.0, 360.0} <= set(degrees.tolist())
    assert len(rows.phi) == 361 + 3
    assert np.all(np.diff(rows.phi) > 0)


def test_rows_that_miss_an_end_by_rounding_are_the_end():
    program = turn("cosine", rise=60, high=30, back=60)
    near = program.edges[1] * (1 + 3e-16)
    rows = positions(program, np.array([near]))
    assert np.count_nonzero(rows.phi == program.edges[1]) == 2


def test_many_rows_agree_with_few():
    program = turn("modified_sine", "const")
    many, few = of_step(program, radians(0.01)), of_step(program, radians(1))
    at = np.searchsorted(many.phi, few.phi[few.phi < 6])
    np.testing.assert_allclose(many.phi[at], few.phi[few.phi < 6], atol=1e-12)


def test_samples_on_the_panels_are_exact_and_resolve_the_motion():
    for name in LAWS:
        program = turn(name, rise=77, high=13, back=101)
        on = program.panels
        x = on.x.ravel()
        np.testing.assert_array_equal(program.sampled.reshape(4, -1), program.at(x))
        at = np.linspace(0.01, 6.2, 301)
        np.testing.assert_allclose(on.at(program.sampled[2], at), program.at(at)[2], atol=2e-13)


def test_the_integral_of_the_velocity_is_the_stroke():
    program = turn("sine", "poly5", rise=5, high=10, back=7, stroke=1e-6)
    on = program.panels
    total = on.primitive(program.sampled[1])[1]
    assert np.max(total) == pytest.approx(1e-6, rel=1e-12)
    assert abs(total[-1]) < 1e-19


def test_a_rise_alone_with_its_stroke():
    program = Program((Phase("rise", 1.0, 0.0, 3.0, LAWS["shun"]), Phase("return", 2 * pi - 1, 3.0, 0.0, LAWS["sine"])))
    assert program.stroke == 3.0
    np.testing.assert_allclose(program.at(np.array([0.5, 1.0, 2 * pi]))[0], [1.5, 3.0, 0.0], atol=1e-15)


def test_extremes_of_a_law_that_leaves_the_stroke():
    """s' = 30 k (1 - k)(0.7 - k) and 30 k (1 - k)(k - 0.3): s is largest at 0.7, least at 0.3."""
    program = overshooting(0.03)
    assert program.highest == pytest.approx(0.03 * 1.11475, rel=1e-13)
    assert program.lowest == pytest.approx(-0.03 * 0.11475, rel=1e-13)
    assert program.stroke == 0.03


@pytest.mark.parametrize("name", LAWS)
def test_laws_of_the_catalogue_keep_to_the_stroke(name):
    program = turn(name)
    assert (program.lowest, program.highest) == (0.0, 0.02)
