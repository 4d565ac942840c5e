"""Forces at the edges: friction at the brink of self-locking, zero masses, a dead point in the cycle, far scales."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest

from tmmcalc import Forces, NoSolutionError, SingularityError

from .scenes import solved
from .truth import TURN, Pressed, Slider

PUSHED = range(1, 12)  # positions of the stroke under load
GUIDE = 3  # the pair B0


def rows(forces: Forces) -> list[int]:
    return [forces.labels.index(str(i)) for i in PUSHED]


def inside(slider: Slider, forces: Forces) -> np.ndarray:
    """Tangent of the rod's lean at the positions under load."""
    return np.tan(slider.lean(np.asarray(forces.phi)[rows(forces)]))


@pytest.mark.parametrize("below", [0.5, 1e-2, 1e-4, 1e-5, 1e-7, 1e-9])
def test_friction_below_the_brink(below: float) -> None:
    """On the slider N = -t Q/(1 - f t): with 1 - f t = 1e-7 one rounding of t is a billionth of the force."""
    slider, friction = Slider(r=0.16), 0.75 * (1 - below)
    forces = solved("self-locking", f"mechanism.joints[name=B0].friction={friction!r}", target="forces").results[
        "forces"
    ]
    lean = inside(slider, forces)
    expected = -100 * lean / (1 - friction * lean)
    assert forces.normal[GUIDE][rows(forces)] == pytest.approx(expected, rel=1e-14 + 2e-15 / below)
    largest = math.hypot(1, friction) * np.max(np.abs(expected))
    assert forces.pairs[GUIDE].force.value == pytest.approx(largest, rel=1e-10 + 2e-15 / below)
    assert forces.pairs[GUIDE].force.x == pytest.approx(math.pi / 2, abs=1e-8)
    assert forces.drive_extremes[1].value == pytest.approx(np.max(forces.drive), rel=1e-8 + 2 * below)
    assert np.max(np.abs(forces.equilibrium)) < 1e-14
    assert np.max(np.abs(forces.virtual)) < 1e-13
    near = [grade for grade in forces.grades if "near to self-locking at 90 deg" in grade.message]
    assert len(near) == (below < 5e-3)
    assert forces.error >= 1e-16 / below


@pytest.mark.parametrize("below", [1e-5, 1e-6])
def test_largest_force_is_never_above_that_of_its_place(below: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """Panels that do not resolve the pole swing beyond it: what stands at the place named comes from the statics."""
    monkeypatch.setattr("tmmcalc.linkage.forces.refinement.ROUNDS", 1)
    slider, friction = Slider(r=0.16), 0.75 * (1 - below)
    changes = (f"mechanism.joints[name=B0].friction={friction!r}",)
    forces = solved("self-locking", *changes, target="forces").results["forces"]
    largest = forces.pairs[GUIDE].force
    lean = math.tan(float(slider.lean(np.array([largest.x]))[0]))
    assert largest.value == pytest.approx(math.hypot(1, friction) * 100 * lean / (1 - friction * lean), rel=1e-8)


def test_a_brink_too_near_to_tell() -> None:
    friction = 0.75 * (1 + 1e-9)
    with pytest.raises(NoSolutionError, match="the brink lies within 1e-08 of this friction"):
        solved("self-locking", f"mechanism.joints[name=B0].friction={friction!r}", target="forces")


@pytest.mark.parametrize(("beyond", "words"), [(1e-6, "up to 1 - 1e-06 times"), (0.1, "up to 0.9091 times")])
def test_the_part_of_the_friction_that_moves_is_told_from_one(beyond: float, words: str) -> None:
    with pytest.raises(NoSolutionError, match=words):
        solved("self-locking", f"mechanism.joints[name=B0].friction={0.75 * (1 + beyond)!r}", target="forces")


def test_work_of_friction_at_the_brink() -> None:
    """The moment of friction has a pole beside the path: its work comes from quadrature with forty digits."""
    power = solved("self-locking", target="power").results["power"]
    with mpmath.workdps(40):
        friction, crank, rod = mpmath.mpf(0.749999925), mpmath.mpf(0.16), mpmath.mpf(0.2)

        def moment(phi: mpmath.mpf) -> mpmath.mpf:
            sine = crank / rod * mpmath.sin(phi)
            lean = sine / mpmath.sqrt(1 - sine**2)
            return -friction * 100 * lean / (1 - friction * lean) * crank * (mpmath.sin(phi) + mpmath.cos(phi) * lean)

        quarter = mpmath.pi / 2
        near = [mpmath.mpf(10) ** -k for k in range(1, 7)]
        places = [0, *(quarter - d for d in near), quarter, *(quarter + d for d in reversed(near)), mpmath.pi]
        expected = float(mpmath.quad(moment, places))
    assert power.losses == pytest.approx(expected, rel=1e-9)
    assert power.efficiency == pytest.approx(32 / (32 - expected), rel=1e-9)


@pytest.mark.parametrize("beyond", [1e-6, 1e-4, 0.1, 4.0])
@pytest.mark.parametrize("stage", ["forces", "reduction"])
def test_friction_beyond_the_brink(beyond: float, stage: str) -> None:
    friction = 0.75 * (1 + beyond)
    with pytest.raises(NoSolutionError, match=r"self-locking at .*the friction in B0 holds the group") as refused:
        solved("self-locking", f"mechanism.joints[name=B0].friction={friction!r}", target=stage)
    assert refused.value.where == "forces, group RRP(2,3)"
    assert refused.value.exit_code == 3
    # of all positions the one at 90 deg locks first
    assert refused.value.limit == pytest.approx(0.75 / friction, rel=1e-6)


def test_zero_masses_leave_the_static_polygon() -> None:
    results = solved("massless").results
    forces, slider = results["forces"], Slider()
    pushed, phi = rows(forces), np.asarray(forces.phi)
    lean, load = slider.lean(phi[pushed]), 2000.0
    rod = load / np.cos(lean)
    for pair in range(3):  # O, A, B: one force goes from the frame through crank and rod to the slider
        assert np.abs(forces.reaction[pair][pushed]) == pytest.approx(rod, rel=1e-13)
    assert forces.reaction[GUIDE][pushed].imag == pytest.approx(-load * np.tan(lean), rel=1e-13)
    pressed = Pressed(slider, load)
    assert forces.drive == pytest.approx(-pressed.moment(phi), abs=1e-11)
    idle = [forces.labels.index(str(i)) for i in range(13, 25)]
    assert not np.any(forces.reaction[:, idle])
    assert not np.any(results["reduction"].inertia)
    assert results["reduction"].total == pytest.approx(pressed.moment(phi), abs=1e-11)
    assert results["power"].efficiency == 1


def test_stages_that_zero_masses_leave_out() -> None:
    left_out = {event.stage: event.message for event in solved("massless").events if event.kind == "left out"}
    assert "nothing stores kinetic energy" in left_out["motion"]
    assert "no masses" in left_out["balance"]


@pytest.mark.parametrize("stage", ["kinematics", "forces", "reduction", "power"])
def test_a_dead_point_in_the_cycle(stage: str) -> None:
    with pytest.raises(SingularityError, match="dead point at angle_1 = 90 and 270 deg") as refused:
        solved("dead-point", target=stage)
    assert refused.value.exit_code == 3
    assert abs(refused.value.value or 0.0) < (refused.value.limit or 0.0)


@pytest.mark.parametrize("short", [1e-2, 1e-6, 5e-9])
def test_beside_a_dead_point(short: float) -> None:
    """A crank a little shorter than the rod: the guide's force at 90 deg is Q r/sqrt(l^2 - r^2), with all digits."""
    crank = 0.2 * (1 - short)
    forces = solved("dead-point", f"mechanism.links[id=1].points.A=[{crank!r}, 0]", target="forces").results["forces"]
    at = forces.labels.index("6")
    with mpmath.workdps(30):
        lean = crank * mpmath.sin(mpmath.mpf(float(forces.phi[at]))) / mpmath.mpf(0.2)
        expected = -100 * lean / mpmath.sqrt(1 - lean**2)
    assert forces.normal[GUIDE][at] == pytest.approx(float(expected), rel=1e-13)
    assert forces.drive[at] == pytest.approx(100 * crank, rel=1e-6)


def test_a_range_that_keeps_clear_of_the_dead_point() -> None:
    forces = solved("dead-point", 'mechanism.grid={span="80 deg", positions=8}', target="forces").results["forces"]
    # crank and rod alike: both lean by phi, the slider is at 2 r cos(phi)
    assert forces.drive == pytest.approx(100 * 0.4 * np.sin(forces.phi), rel=1e-13, abs=1e-13)


@pytest.mark.parametrize("scale", [1e-12, 1e-6, 1e6, 1e12])
def test_forces_are_in_proportion_to_the_load(scale: float) -> None:
    one, other = (
        solved(
            "self-locking", "mechanism.joints[name=B0].friction=0.7", f"loads[name=Q].force={force!r}", target="forces"
        )
        for force in (100.0, 100.0 * scale)
    )
    expected = one.results["forces"].reaction * scale
    assert np.abs(other.results["forces"].reaction - expected) == pytest.approx(0, abs=1e-12 * np.max(np.abs(expected)))


@pytest.mark.parametrize("speed", [1e-6, 1e-3, 1e3, 1e6])
def test_forces_of_inertia_grow_as_the_speed_squared(speed: float) -> None:
    slow, fast = (
        solved("mass-ratio", f"mechanism.input.speed={w!r}", target="forces").results["forces"] for w in (1.0, speed)
    )
    expected = slow.reaction * speed**2
    assert np.abs(fast.reaction - expected) == pytest.approx(0, abs=1e-12 * np.max(np.abs(expected)))


@pytest.mark.parametrize("ratio", [float(ratio) for ratio in np.geomspace(1e-6, 1e6, 5)])
def test_mass_ratios(ratio: float) -> None:
    """Drive = (dJ/dphi) omega^2/2 of the reduced inertia, here the one of the closed form."""
    masses = f"mechanism.links[id=2].mass={1.0!r}", f"mechanism.links[id=3].mass={ratio!r}"
    results = solved("mass-ratio", *masses, "mechanism.links[id=2].inertia=0.005", target="power").results
    forces = solved("mass-ratio", *masses, "mechanism.links[id=2].inertia=0.005", target="forces").results["forces"]
    slider, step = Slider(m2=1, j2=0.005, s=0.08, m3=ratio), 1e-3
    phi, reduction = np.asarray(forces.phi), results["reduction"]
    assert reduction.inertia == pytest.approx(slider.inertia(phi), rel=1e-12)
    weights = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5])  # central difference of the eighth order
    apart = [slider.inertia(phi - k * step) - slider.inertia(phi + k * step) for k in (4, 3, 2, 1)]
    slope = np.tensordot(weights, apart, 1) / step
    assert reduction.slope == pytest.approx(
        -slope if np.dot(slope, reduction.slope) < 0 else slope, abs=1e-10 * (1 + ratio)
    )
    assert forces.drive == pytest.approx(reduction.slope * 25 / 2, abs=1e-12 * (1 + ratio))
    assert results["power"].machine == "idle"
    assert results["power"].efficiency is None
    assert abs(results["power"].mean_moment) < 1e-12 * (1 + ratio)
    assert forces.phi[-1] == pytest.approx(TURN)
