"""The return spring: both methods of sizing, the exact stiffness, the safety that is reached, the wire."""

import json
from math import pi, radians
from pathlib import Path

import numpy as np
import pytest

from cams.turns import overshooting, task_of
from tmmcalc.cams.facts.cam_forces import summary as forces_summary
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.results import Reserve
from tmmcalc.cams.forces.solve import solve_forces
from tmmcalc.cams.forces.spring import lifting, solve_spring
from tmmcalc.cams.forces.verdicts import force_notes
from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.laws.law import polynomial
from tmmcalc.cams.program import Phase, Program
from tmmcalc.cams.task import AngleLimits, Asked, CamTask, Force, Loads, Spring
from tmmcalc.core.errors import NoSolutionError

CASES = {case["id"]: case for case in json.loads((Path(__file__).parents[1] / "cases/cams.json").read_text())}


def program(rise, back, stroke, rise_law, back_law=None):
    first, second = (LAWS[law] if isinstance(law, str) else law for law in (rise_law, back_law or rise_law))
    rest = 2 * pi - rise - back - 0.2
    return Program(
        (
            Phase("rise", rise, 0.0, stroke, first),
            Phase("high dwell", 0.2, stroke, stroke),
            Phase("return", back, stroke, 0.0, second),
            Phase("low dwell", rest, 0.0, 0.0),
        )
    )


SIXTY = radians(60)


def task(laws, spring, *, rise=SIXTY, back=SIXTY, stroke=0.02, mass=0.2, speed=100.0, **more):
    kind = more.pop("kind", "translating")
    loads = Loads(speed=speed, mass=mass, spring=spring, **more)
    return CamTask(program(rise, back, stroke, *laws), Asked(kind), AngleLimits(1.0, None), loads=loads)


def found(given):
    return solve_spring(given, given.loads)


@pytest.mark.parametrize("law", list(CASES["cams-s18"]["expected"]))
def test_safety_of_all_laws(law):
    """Textbook's spring, the safety it really reaches, and the exact stiffness."""
    expected = CASES["cams-s18"]["expected"][law]
    spring = found(task([law], Spring("safety", safety=1.25)))
    assert spring.lifting == pytest.approx(expected["P_M_N"], rel=1e-5)
    assert spring.preload == pytest.approx(expected["Q0_N"], rel=1e-5)
    assert spring.stiffness / 1e3 == pytest.approx(expected["c_N_per_mm"], rel=1e-5)
    assert spring.exact / 1e3 == pytest.approx(expected["c_exact_N_per_mm"], rel=2e-5)  # const: of a grid there
    assert spring.reached == pytest.approx(expected["min_ratio"], rel=1e-5)


def test_tangent_construction():
    given, expected = CASES["cams-s07"]["inputs"], CASES["cams-s07"]["expected"]
    # the analogue of acceleration fixes the angle of the phase: S'' = 4 h/phi^2
    angle = float(np.sqrt(4 * 0.04 / given["S2max_m"]))
    asked = Spring("preload", least=5.0, deflection=0.016)
    spring = found(task(["const"], asked, rise=angle, back=angle, stroke=0.04, mass=0.12, speed=600 * pi / 30))
    assert spring.lifting == pytest.approx(expected["F_in_max_N"], rel=2e-4)
    assert spring.stiffness / 1e3 == pytest.approx(expected["c_N_per_mm"], rel=2e-4)
    assert spring.highest == pytest.approx(expected["F_max_N"], rel=2e-4)
    assert spring.preload == pytest.approx(expected["F_preload_N"], rel=2e-4)
    assert spring.lift == pytest.approx(0.02)
    usual = found(
        task(["const"], Spring("preload"), rise=angle, back=angle, stroke=0.04, mass=0.12, speed=600 * pi / 30)
    )
    assert usual.stiffness == pytest.approx(spring.stiffness, rel=1e-12)  # 0.4 h is the default


@pytest.mark.parametrize("case", ["cams-s08", "cams-s09"])
def test_rocker_of_program_27(case):
    given, expected = CASES[case]["inputs"], CASES[case]["expected"]
    asked = task(
        [given["law"]], Spring("safety", safety=1.25), stroke=radians(30), mass=1e-4, kind="oscillating"
    )  # fmt: skip
    spring = found(asked)
    assert spring.lifting == pytest.approx(expected["M_in_max_Nm"], rel=1e-6)
    assert spring.lift == pytest.approx(expected["dpsi_M_rad"], rel=1e-6)
    assert spring.stiffness == pytest.approx(expected["c_psi_Nm_per_rad"], rel=1e-6)
    assert spring.preload == pytest.approx(expected["M0_Nm"], rel=1e-6)


@pytest.mark.parametrize("laws", [("sine", "const"), ("poly5", "cosine"), ("modified_trapezoid", "shun")])
@pytest.mark.parametrize("angles", [(60, 90), (80, 50), (5, 120)])
def test_exact_stiffness_against_a_dense_scan(laws, angles):
    """Never beaten by a point of a dense scan, and reached by one within its resolution."""
    rise, back = map(radians, angles)
    asked = task(laws, Spring("safety", safety=1.4, exact=True), rise=rise, back=back)
    spring = found(asked)
    y, _, y2, _ = asked.program.at(np.linspace(0, 2 * pi, 400_001))
    lift = -0.2 * 100**2 * y2
    where = (lift > 0) & (y > 1e-9)
    scan = np.max((1.4 * lift[where] - spring.preload) / y[where])
    assert scan <= spring.stiffness * (1 + 1e-12)
    assert spring.stiffness == pytest.approx(scan, rel=1e-4)
    assert spring.reached == pytest.approx(1.4, rel=1e-10)
    ratios = (spring.preload + spring.stiffness * y[where]) / lift[where]
    assert np.min(ratios) >= 1.4 * (1 - 1e-12)


def test_a_return_that_lifts_lower_down_is_held_as_well():
    """A slightly smaller P_M at half the lift asks for the stiffer spring."""
    asked = task(("cosine", "const"), Spring("safety", safety=1.2), rise=radians(60), back=radians(54.1))
    spring = found(asked)
    rise, back = (0.2 * 1e4 * 0.02 * c / radians(a) ** 2 for c, a in ((pi**2 / 2, 60), (4, 54.1)))
    assert rise > back
    assert spring.lifting == pytest.approx(rise, rel=1e-12)
    assert spring.stiffness == pytest.approx((1.2 * back - 0.2 * rise) / 0.01, rel=1e-10)
    assert spring.reached == pytest.approx(1.2, rel=1e-9)


def notes_of(given, spring):
    return list(force_notes(given, spring, (), (), Reserve(1.0, 0.0, 0.0, 0.0, None)))


def test_the_phase_that_asks_for_the_stiffness_is_told():
    """P_M = 180 N at 20 mm on the rise gives 9 N/mm, with which 145.9 N at 10 mm on the return lift off."""
    asked = task(("cosine", "const"), Spring("safety", safety=1.25))
    spring = found(asked)
    back = 0.2 * 1e4 * 0.02 * 4 / SIXTY**2
    assert spring.lifting == pytest.approx(180.0, rel=1e-12)
    assert (spring.phase, spring.governing.phase) == ("rise", "return")
    assert spring.governing.rule == pytest.approx(9000.0, rel=1e-12)
    assert spring.governing.force == pytest.approx(back, rel=1e-12)
    assert spring.governing.lift == pytest.approx(0.01, rel=1e-12)
    assert spring.stiffness == pytest.approx((1.25 * back - 45) / 0.01, rel=1e-12)
    (note,) = (note for note in notes_of(asked, spring) if "lifts lower down" in note)
    assert "the return asks for the stiffness" in note
    assert "c = 9 N/mm (5.57)" in note
    facts = {fact.label: fact for fact in forces_summary(solve_forces(asked, Follower("translating", 0.06)), "").facts}
    assert facts["stiffness"].values["c_rule[N/m]"] == pytest.approx(9000.0)
    for alike in (task(["cosine"], Spring("safety")), task(("cosine", "const"), Spring("safety", exact=True))):
        assert found(alike).governing is None


def test_a_stiffness_that_there_is_not_refuses_nothing_else():
    """A hanging follower: 0.25 P_M is less than the weight takes at the lowest position, but the contact is kept."""
    asked = task(["cosine"], Spring("safety"), gravity=9.81, speed=19.77)
    spring = found(asked)
    top = 0.2 * (9.81 + 19.77**2 * 0.02 * pi**2 / 2 / SIXTY**2)
    assert spring.exact is None
    assert (spring.stiffness, spring.preload) == pytest.approx((top / 0.02, 0.25 * top), rel=1e-12)
    assert spring.reached == pytest.approx(0.25 * top / (0.2 * 9.81), rel=1e-9)
    assert any("exact = true finds a larger one" in note for note in notes_of(asked, spring))
    assert found(task(["cosine"], Spring("safety", exact=True), gravity=9.81, speed=19.77)).reached > 1.25 * (1 - 1e-9)


def test_weight_that_presses_spares_stiffness():
    free = found(task(["cosine"], Spring("safety")))
    pressed = found(task(["cosine"], Spring("safety"), gravity=-9.81))
    assert pressed.lifting == pytest.approx(free.lifting - 0.2 * 9.81, rel=1e-12)
    for speed in (0.5, 100.0):
        hanging = found(task(["sine"], Spring("safety", exact=True), gravity=9.81, speed=speed))
        assert hanging.preload >= 1.25 * 0.2 * 9.81 * (1 - 1e-12)
        assert hanging.reached >= 1.25 * (1 - 1e-9)


def test_nothing_lifts_off():
    spring = found(task(["cosine"], Spring("safety"), mass=0.0))
    assert (spring.stiffness, spring.preload, spring.lifting, spring.reached) == (0.0, 0.0, None, None)


def test_given_and_none():
    spring = found(task(["shun"], Spring("given", stiffness=5e3, preload=30.0)))
    assert (spring.stiffness, spring.preload, spring.highest) == (5e3, 30.0, 130.0)
    lifted = task(["shun"], Spring("none"))
    assert found(lifted).reached == 0.0
    assert np.max(lifting(lifted, lifted.loads).force) > 0


def test_wire():
    """c and tau of the wire give the spring back."""
    spring = found(task(["cosine"], Spring("safety", wire=0.002, coil=0.016)))
    wire = spring.wire
    assert 8e10 * 0.002**4 / (8 * 0.016**3 * wire.coils) == pytest.approx(spring.stiffness, rel=1e-12)
    plain = 8 * spring.highest * 0.016 / (pi * 0.002**3)
    assert wire.stress == pytest.approx(plain * (31 / 28 + 0.615 / 8), rel=1e-12)
    with pytest.raises(NoSolutionError, match="does not wind"):
        found(task(["cosine"], Spring("safety", wire=0.02, coil=0.016)))


def test_lift_off_at_the_lowest_position_is_refused():
    """A law that brakes most at its begin lifts the follower off where a stiffness has no arm."""
    backward = polynomial("backward", (0.0, [0, 0, -6, 28, -33, 12]))
    with pytest.raises(NoSolutionError, match="lowest position"):
        found(task([backward], Spring("safety")))


def test_technological_force_does_not_size_the_spring():
    """The textbook sizes it for idle running."""
    assert found(task(["sine"], Spring(), force=Force(-500.0, -200.0))) == found(task(["sine"], Spring()))


@pytest.mark.parametrize("asked", [Spring(), Spring(exact=True), Spring("preload", least=1.0), Spring("none")])
def test_nothing_lifts_off_where_the_weight_outweighs_inertia(asked):
    """2 N of weight press at 1 rad/s; the preload needs nothing for 1 N of contact."""
    spring = found(task(["sine"], asked, speed=1.0, gravity=-9.81))
    assert (spring.stiffness, spring.preload, spring.highest) == (0.0, 0.0, 0.0)
    assert (spring.lifting, spring.reached, spring.phase) == (None, None, "")


def test_a_given_spring_is_kept_where_nothing_lifts_off():
    spring = found(task(["sine"], Spring("given", stiffness=5e3, preload=30.0), speed=1.0, gravity=-9.81))
    assert (spring.stiffness, spring.preload, spring.highest) == (5e3, 30.0, 130.0)
    assert (spring.lifting, spring.reached) == (None, None)


def test_highest_force_stands_at_the_top_of_an_overshoot():
    given = task_of(overshooting(0.02), loads=Loads(10.0, 0.2, spring=Spring("given", stiffness=5e3, preload=30.0)))
    assert found(given).highest == pytest.approx(30 + 5e3 * 0.02 * 1.11475, rel=1e-12)


def test_springs_by_index():
    """Each has the allowed stress and the stiffness back, by the wire and coil that it names; free is taller."""
    spring = found(task(["cosine"], Spring("safety", allowed=5e8)))
    assert [each.index for each in spring.sizes] == list(range(4, 17))
    for each in spring.sizes:
        wound = found(task(["cosine"], Spring("safety", wire=each.wire, coil=each.coil))).wire
        assert wound.index == pytest.approx(each.index)
        assert wound.coils == pytest.approx(each.coils)
        assert wound.stress == pytest.approx(5e8)
        assert each.solid == pytest.approx((each.coils + 2) * each.wire)
        deflection = spring.highest / spring.stiffness
        assert each.free == pytest.approx(each.solid + 0.1 * each.wire * each.coils + deflection)
    # of few dead coils the height falls with D/d as (D/d)^-2, but for k_w
    few = found(task(["cosine"], Spring("safety", allowed=5e8, dead=0.0))).sizes
    ratio = few[0].solid / few[8].solid  # D/d 4 and 12
    wahl = [(4 * i - 1) / (4 * i - 4) + 0.615 / i for i in (4, 12)]
    assert ratio == pytest.approx((12 / 4) ** 2 * wahl[0] / wahl[1])


def test_springs_by_index_by_hand():
    """At D/d = 6 k_w = 1.2525: d^2 = 8 Q 6 k_w/(500 pi) mm^2; with 2 N/mm n = 80 000 d/(8 * 216 * 2), d in mm."""
    spring = found(task(["cosine"], Spring("given", stiffness=2e3, preload=40.0, allowed=5e8)))
    each = spring.sizes[2]
    wire = (8 * spring.highest * 6 * 1.2525 / (pi * 500)) ** 0.5
    assert 1e3 * each.wire == pytest.approx(wire)
    assert each.coils == pytest.approx(80e3 * wire / (8 * 216 * 2))
