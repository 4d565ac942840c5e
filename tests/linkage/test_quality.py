"""Transmission angles, amplification, dead points: where they stand and how they are graded."""

from __future__ import annotations

import math

import numpy as np
import pytest
from random_mechanisms import build
from sparing import sparing
from transforms import moved, scaled

from linkage.scenes import crank_slider, four_bar, full_turn, part, slotted, trammel, with_input, yoke
from tmmcalc import AssemblyError, SingularityError, solve_kinematics
from tmmcalc.linkage.chain import compile_chain


def extreme_transmission(l1: float, l2: float, l3: float, c: float) -> float:
    """Smallest transmission angle of a crank-rocker [rad], at one of the two positions in line with the frame."""
    cosines = [((c + s * l1) ** 2 - l2**2 - l3**2) / (2 * l2 * l3) for s in (-1, 1)]
    return min(math.pi / 2 - abs(math.pi / 2 - math.acos(abs(cosine))) for cosine in cosines)


@pytest.mark.parametrize("lengths", [(1, 6, 3, 7), (0.1, 0.3, 0.25, 0.324), (2, 5, 4, 6)])
@pytest.mark.parametrize("start", [0.0, 0.4, 3.0, math.radians(0.3), -math.radians(0.2)])
def test_the_smallest_transmission_angle_of_a_crank_rocker(lengths: tuple[float, ...], start: float) -> None:
    result = solve_kinematics(full_turn(four_bar(*lengths), start))
    (quality,) = result.qualities
    assert quality.transmission == pytest.approx(extreme_transmission(*lengths), abs=1e-9)
    assert abs(math.sin(quality.transmission_at)) < 1e-7
    assert quality.pressure == pytest.approx(math.pi / 2 - quality.transmission)


@pytest.mark.parametrize(
    ("rod", "words"), [(0.5, None), (0.116, None), (0.115, "below 30"), (0.11, "below 30"), (0.105, "below 20")]
)
def test_grades_of_the_transmission_angle(rod: float, words: str | None) -> None:
    """cos of the rod's angle: its least is sqrt(1 - (l1/l2)^2)."""
    result = solve_kinematics(full_turn(crank_slider(0.1, rod)))
    texts = [str(grade) for grade in result.grades]
    if words is None:
        assert texts == []
        return
    angle = math.degrees(math.acos(0.1 / rod))
    severity = "warning" if angle < 20 else "note"
    assert any(text.startswith(severity) and f"{angle:.4g} deg" in text and words in text for text in texts)


@pytest.mark.parametrize("d", [1e-2, 1e-3, 1e-4])
@pytest.mark.parametrize("off", [0.0, 0.1, -0.25, 0.49, -0.5])
def test_nearly_singular_places_have_their_true_angle_and_amplification(d: float, off: float) -> None:
    """A rotating slotted link: the pin passes the pivot at l1 - l0, against the largest distance l1 + l0."""
    result = solve_kinematics(full_turn(slotted(0.1, 0.1 * (1 + d)), math.radians(270 + off)))
    (quality,) = result.qualities
    assert quality.regularity == pytest.approx(d / (2 + d), rel=1e-3)
    assert abs(math.remainder(quality.regularity_at - 1.5 * math.pi, 2 * math.pi)) < 1e-7
    assert quality.transmission == pytest.approx(math.pi / 2)
    (grade,) = result.grades
    assert grade.severity == "warning"
    assert f"amplified {quality.amplification:.4g} times" in grade.message
    assert grade.where == "group RPR(2,3)"


def test_an_offset_slot_has_its_own_pressure_angle() -> None:
    """The sine of the transmission angle is s/Q, least where the pivots are nearest."""
    result = solve_kinematics(full_turn(slotted(0.1, 0.3, 0.12)))
    (quality,) = result.qualities
    assert math.sin(quality.transmission) == pytest.approx(math.sqrt(1 - (0.12 / 0.2) ** 2), rel=1e-9)
    assert quality.regularity == pytest.approx(math.sqrt(0.2**2 - 0.12**2) / 0.4, rel=1e-4)


@pytest.mark.parametrize("low", [1e-4, 5e-3, 0.1, 1.0])
@pytest.mark.parametrize("high", [1e-4, 3e-3, 0.2])
def test_dead_points_near_the_ends_of_the_range(low: float, high: float) -> None:
    """The guides of a trammel are parallel at 90 degrees, however near that is to an end of the range."""
    mechanism = trammel(0.1, math.pi / 2)
    with pytest.raises(SingularityError, match=r"dead point at angle_1 = 90 deg.*limit 1e-06") as refused:
        solve_kinematics(part(mechanism, math.pi / 2 - low, math.pi / 2 + high))
    assert "group PRP(2,3)" in str(refused.value)
    assert refused.value.limit == 1e-6
    clear = solve_kinematics(part(mechanism, math.pi / 2 - low - 1, math.pi / 2 - low))
    assert clear.qualities[0].regularity == pytest.approx(math.sin(low), rel=1e-9)


def test_a_slot_along_its_own_guide_is_singular_everywhere() -> None:
    with pytest.raises(SingularityError, match=r"group RPP\(2,3\): dead point"):
        solve_kinematics(full_turn(yoke(0.1, 0.0)))
    assert solve_kinematics(full_turn(yoke(0.1, 0.03))).qualities[0].regularity == pytest.approx(math.sin(0.03))


@sparing("seed", range(25), every=6)
def test_random_chains_against_a_dense_scan(seed: int) -> None:
    """No place of 20 001 is worse than the one reported, and the reported one is as bad as it says."""
    mechanism = build(np.random.default_rng(seed), span=math.radians(20)).mechanism
    try:
        result = solve_kinematics(mechanism)
    except AssemblyError:
        return
    chain = compile_chain(mechanism, result.structure, result.variants)
    x = np.linspace(result.x.min(), result.x.max(), 20_001)
    placed = chain.evaluate(x, order=0).placed
    for step, place, quality in zip(chain.steps, placed, result.qualities, strict=True):
        oscillates = step.group.kind == "RPR"  # its pins come near each other without a worse angle
        sine = np.broadcast_to(np.abs(place.s) / np.abs(place.q) if oscillates else step.regularity(place), x.shape)
        assert math.sin(quality.transmission) <= sine.min() * (1 + 1e-9)
        assert math.sin(quality.transmission) == pytest.approx(sine.min(), rel=1e-4)


def test_quality_does_not_depend_on_unit_or_place() -> None:
    mechanism = full_turn(four_bar(1, 6, 3, 7))
    one = solve_kinematics(mechanism).qualities[0]
    for factor in (1e-6, 1e3):
        two = solve_kinematics(with_input(moved(scaled(mechanism, factor), 0.7, 5 * factor), start=0.7)).qualities[0]
        assert two.transmission == pytest.approx(one.transmission, rel=1e-9)
