"""The law stage: rows, constants, extremes in closed form, shocks with their remarks, columns, the stored form."""

from dataclasses import fields, replace
from math import pi, radians

import numpy as np
import pytest

from cams.turns import overshooting, task_of, turn
from tmmcalc.cams.facts.cam_law import document as law_document
from tmmcalc.cams.facts.cam_law import summary as law_summary
from tmmcalc.cams.lawresult import LawResult, law_columns, solve_law
from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.laws.constants import constants
from tmmcalc.cams.overshoot import backward
from tmmcalc.cams.program import Phase, Program
from tmmcalc.cams.task import Loads
from tmmcalc.core.conversion import from_record, to_record


def extreme(result, order, sign):
    found = [each for each in result.extremes if each.order == order]
    return max(found, key=lambda each: sign * each.value)


@pytest.mark.parametrize("name", LAWS)
def test_extremes_are_those_of_the_constants(name):
    """S'max = Cv h/phi, S''max = Ca h/phi^2 at the angle of the law's own place."""
    result = solve_law(task_of(turn(name, rise=72, high=30, back=90, stroke=0.03)))
    law, angle = constants(LAWS[name]), radians(72)
    assert extreme(result, 1, 1).value == pytest.approx(law.velocity * 0.03 / angle, rel=1e-12)
    assert extreme(result, 1, 1).phi == pytest.approx(law.velocity_at * angle, rel=1e-9)
    low = extreme(result, 2, -1)
    assert low.value == pytest.approx(law.braking * 0.03 / angle**2, rel=1e-12)
    assert low.phi == pytest.approx(law.braking_at * angle, rel=1e-7)


def test_values_in_time():
    """600 rpm and the cosine law: v = h pi omega/(2 phi), a = h pi^2 omega^2/(2 phi^2)."""
    omega, angle, h = 20 * pi, radians(60), 0.02
    result = solve_law(task_of(turn("cosine"), loads=Loads(omega)))
    velocity, acceleration, jerk = result.in_time
    assert velocity.max() == pytest.approx(h * pi * omega / (2 * angle), rel=1e-12)
    assert acceleration.max() == pytest.approx(h * pi**2 * omega**2 / (2 * angle**2), rel=1e-12)
    assert jerk.min() == pytest.approx(-h * pi**3 * omega**3 / (2 * angle**3), rel=1e-12)
    assert solve_law(task_of(turn("cosine"))).in_time is None


def test_soft_shocks_are_notes_with_place_and_size():
    result = solve_law(task_of(turn("cosine")))
    soft = [shock for shock in result.shocks if shock.order == 2]
    assert [round(float(np.degrees(shock.phi)), 9) for shock in soft] == [0, 60, 90, 150]
    size = 0.02 * pi**2 / 2 / (pi / 3) ** 2
    np.testing.assert_allclose([shock.jump for shock in soft], [size, size, -size, -size], rtol=1e-12)
    (note,) = result.remarks
    assert note.startswith("note: soft shock")
    assert f"{1e3 * size:+.6g} mm at phi = 60 deg" in note


def test_a_rigid_shock_is_a_warning():
    """A straight line of displacement: s' jumps from 0 to 1."""
    from tmmcalc.cams.laws.law import polynomial

    line = polynomial("line", (0.0, [0, 1]))
    phases = (Phase("rise", pi, 0.0, 0.02, line), Phase("return", pi, 0.02, 0.0, LAWS["sine"]))
    result = solve_law(task_of(Program(phases)))
    rigid = [shock for shock in result.shocks if shock.order == 1]
    np.testing.assert_allclose([shock.jump for shock in rigid], [0.02 / pi, -0.02 / pi], rtol=1e-12)
    assert result.remarks[0].startswith("warning: rigid shock")


def test_a_smooth_motion_has_no_remark():
    result = solve_law(task_of(turn("poly4567")))
    assert result.remarks == ()
    assert result.shocks == ()


def test_part_of_the_phase_runs_back_on_the_return():
    result = solve_law(task_of(turn("shun", rise=60, high=30, back=60), steps=4))
    np.testing.assert_allclose(result.part, [0, 0.25, 0.5, 0.75, 1, 1, 0.75, 0.5, 0.25, 0, 0], atol=1e-14)
    law = LAWS["shun"].at(result.part)
    np.testing.assert_allclose(result.motion[0], 0.02 * law[0], atol=1e-16)


def test_columns_of_a_stem_and_of_a_rocker():
    stem = law_columns(solve_law(task_of(turn("sine"), loads=Loads(10.0))))
    headers = "i phase phi[deg] k dS[m] S1[m] S2[m] S3[m] v[m/s] a[m/s^2] jerk[m/s^3]"
    assert list(stem) == headers.split()
    rocker = law_columns(solve_law(task_of(turn("sine", stroke=0.5), "oscillating", loads=Loads(10.0))))
    headers = "i phase phi[deg] k dpsi[deg] psi1 psi2 psi3 omega[rad/s] eps[rad/s^2] jerk[rad/s^3]"
    assert list(rocker) == headers.split()
    assert set(stem["phase"]) == {"rise", "high dwell", "return", "low dwell"}


def same(a, b):
    if isinstance(a, np.ndarray):
        return a.dtype == b.dtype and np.array_equal(a, b)
    if hasattr(a, "__dataclass_fields__"):
        return type(a) is type(b) and all(same(getattr(a, f.name), getattr(b, f.name)) for f in fields(a))
    if isinstance(a, tuple):
        return len(a) == len(b) and all(map(same, a, b))
    return type(a) is type(b) and a == b


@pytest.mark.parametrize("loads", [None, Loads(60.0)])
def test_round_trip(loads):
    result = solve_law(task_of(turn("const", "modified_sine", high=0), loads=loads))
    assert same(from_record(LawResult, to_record(result)), result)


def test_extreme_scenes():
    for stroke, rise in ((1e-6, 5.0), (1.0, 5.0), (1.0, 180.0)):
        program = turn("cosine", "const", rise=rise, high=0, back=180, stroke=stroke)
        result = solve_law(task_of(program, loads=Loads(20_000 * pi / 30)))
        assert all(np.isfinite(row).all() for row in (*result.motion, *result.in_time))
        assert extreme(result, 1, 1).value == pytest.approx(stroke * pi / 2 / radians(rise), rel=1e-12)
        to_record(result)


def test_the_task_hands_its_remarks_on():
    task = replace(task_of(turn("sine")), remarks=("the speed is that of the crank",))
    assert solve_law(task).remarks == ("the speed is that of the crank",)


def test_documents():
    result = solve_law(task_of(turn("cosine", "shun"), loads=Loads(60.0)))
    document = law_document(result, "law")
    facts = {fact.label: fact for fact in document.facts}
    assert "Cv = 1.5708" in facts["constants, rise"].text
    wanted = 150 - 60 * (0.5 - 3**0.5 / 6)
    assert facts["S''"].values["S2_max_at_phi[deg]"] == pytest.approx(wanted, abs=1e-9)
    assert len(document.table.columns[0]) <= 50
    assert any("leaves rows out" in note for note in document.notes)
    whole = law_document(result, "law", everything=True).table
    assert len(whole.columns[0]) == len(result.positions.labels)
    assert "S2[m]" in whole.headers
    few = law_document(result, "law", patterns=["phi", "S*"], rows=[0, 3]).table
    assert list(few.headers) == ["i", "phi[deg]", "S1[mm]", "S2[mm]", "S3[mm]"]
    assert len(few.columns[0]) == 2
    assert law_summary(result, "law").table is None


@pytest.mark.parametrize(("kind", "amount"), [("translating", "3.4425 mm"), ("oscillating", "0.197241 deg")])
def test_overshoot_and_turning_back_are_warned_of(kind, amount):
    """30 mm by 0.11475 at k = 0.7 of the rise, and at k = 0.3 of the return, which runs from 210 to 120 deg."""
    remarks = solve_law(task_of(overshooting(0.03), kind)).remarks
    assert [each for each in remarks if "shoot" in each or "monotone" in each] == [
        f"warning: overshoot: the follower rises {amount} above the stroke at phi = 63 deg; guide and spring are "
        "taken to that",
        f"warning: undershoot: the follower falls {amount} below its lowest position at phi = 183 deg",
        f"warning: the rise is not monotone: the follower goes back by {amount} for phi from 63 to 90 deg",
        f"warning: the return is not monotone: the follower goes back by {amount} for phi from 183 to 210 deg",
    ]


@pytest.mark.parametrize("name", LAWS)
def test_laws_of_the_catalogue_do_not_turn_back(name):
    assert backward(turn(name)) == ()
