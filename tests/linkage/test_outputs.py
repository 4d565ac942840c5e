"""Dead centres, strokes, time ratio and extremes against closed forms and against finer independent searches."""

from __future__ import annotations

import math
from dataclasses import replace

import mpmath
import numpy as np
import pytest
from random_mechanisms import build
from sparing import sparing
from transforms import scaled

from linkage.scenes import (
    CONFIGS,
    crank_slider,
    drag_link,
    driven_rod,
    four_bar,
    full_turn,
    part,
    shaper,
    slotted,
    with_grid,
    with_input,
    with_output,
    yoke,
)
from tmmcalc import AssemblyError, Kinematics, NoSolutionError, load_spec, solve_kinematics
from tmmcalc.linkage.chain import compile_chain
from tmmcalc.linkage.model import Input, Joint, Link, Mechanism, Output
from tmmcalc.linkage.outputs import coordinate_of
from tmmcalc.linkage.results import Extreme

TURN = 2 * math.pi
TEN_KINDS = ("four-bar", "shaper", "slotter", "inertial-conveyor", "v-engine", "engine-compressor", "four-dyads")


def closed_dead_centres(l1: float, l2: float, e: float) -> tuple[float, float]:
    """Crank and rod in line: sin phi = e/(l2 + l1), and sin phi = -e/(l2 - l1) on the far side."""
    return math.asin(e / (l2 + l1)), math.pi + math.asin(e / (l2 - l1))


@sparing("lengths", [(0.1, 0.32, -0.04), (0.1, 0.32, 0.0), (0.1, 0.3, 0.15), (0.03, 0.9, 0.4)], every=4, first=2)
@pytest.mark.parametrize("start", [0.0, -0.5, 2.0, None])
@pytest.mark.parametrize("speed", [1.0, -7.0])
def test_dead_centres_of_a_crank_slider(lengths: tuple[float, float, float], start: float | None, speed: float) -> None:
    result = solve_kinematics(with_input(crank_slider(*lengths), start=start, speed=speed))
    (summary,), expected = result.summaries, closed_dead_centres(*lengths)
    found = sorted(math.remainder(centre.x - expected[0] + 1, TURN) for centre in summary.dead_centres)
    assert found == pytest.approx(sorted(math.remainder(e - expected[0] + 1, TURN) for e in expected), abs=1e-13)
    l1, l2, e = lengths
    ends = math.sqrt((l2 + l1) ** 2 - e**2), math.sqrt((l2 - l1) ** 2 - e**2)
    assert sorted(centre.value for centre in summary.dead_centres) == pytest.approx(sorted(ends), rel=1e-14)
    assert summary.stroke == pytest.approx(ends[0] - ends[1], rel=1e-12)
    between = expected[1] - expected[0]
    assert summary.working_angle == pytest.approx(max(between, TURN - between), rel=1e-13)
    assert summary.idle_angle == pytest.approx(min(between, TURN - between), rel=1e-13)
    assert summary.time_ratio == pytest.approx(max(between, TURN - between) / min(between, TURN - between), rel=1e-12)
    if start is None:
        assert summary.dead_centres[0].x == pytest.approx(result.x[0], abs=1e-13)
        assert abs(result.ds[0, 0]) < 1e-14


def test_dead_centres_follow_the_motion_from_position_0() -> None:
    for speed in (2.0, -2.0):
        result = solve_kinematics(with_input(shaper(), speed=speed, start=0.3))
        phi = [(centre.x - result.x[0]) * math.copysign(1, speed) for centre in result.summaries[0].dead_centres]
        assert all(0 <= p < TURN for p in phi)


def test_the_working_stroke_is_the_slower_one() -> None:
    """The shaper cuts to the left counter-clockwise and to the right clockwise; both take 217.6 degrees."""
    working = math.pi + 2 * math.asin(0.2 / 0.62)
    for speed, first in ((1.0, 1), (-1.0, -1)):
        result = solve_kinematics(with_input(shaper(), speed=speed))
        summary = result.summaries[0]
        assert summary.working_angle == pytest.approx(working, rel=1e-13)
        assert summary.time_ratio == pytest.approx(working / (TURN - working), rel=1e-12)
        assert first * (summary.dead_centres[0].value - summary.dead_centres[1].value) > 0


def test_resistance_names_the_working_stroke() -> None:
    for sense, first in (("positive", 1), ("negative", -1)):
        mechanism = with_output(shaper(), point="D", resistance=sense)
        summary = solve_kinematics(mechanism).summaries[0]
        assert first * (summary.dead_centres[0].value - summary.dead_centres[1].value) > 0


def test_of_equal_strokes_the_one_from_the_right_is_the_working_one() -> None:
    for mechanism in (crank_slider(0.1, 0.3), yoke(0.1)):
        for speed in (1.0, -3.0):
            result = solve_kinematics(with_input(mechanism, start=None, speed=speed))
            summary = result.summaries[0]
            assert summary.time_ratio == pytest.approx(1.0, abs=1e-12)
            assert result.x[0] == pytest.approx(0.0, abs=1e-12)
            assert summary.dead_centres[0].value > summary.dead_centres[1].value


def test_an_output_that_never_reverses_has_no_extreme_start() -> None:
    mechanism = slotted(0.1, 0.25)
    summary = solve_kinematics(mechanism).summaries[0]
    assert summary.dead_centres == ()
    assert summary.stroke is None
    assert summary.time_ratio is None
    with pytest.raises(NoSolutionError, match="never reverses"):
        solve_kinematics(with_input(mechanism, start=None))
    with pytest.raises(NoSolutionError, match="exactly two dead centres; it has 0"):
        solve_kinematics(with_grid(mechanism, working=6, idle=4))


@pytest.mark.parametrize("size", [1e-6, 1.0, 1e3])
def test_an_output_that_stands_still_has_no_dead_centres(size: float) -> None:
    """A yoke does not turn, a slider does not leave its line: rounding is no motion, whatever the size."""
    for mechanism in (
        with_output(yoke(0.1, 1.1), link=3),
        with_output(crank_slider(0.1, 0.3, 0.05), link=3),
        with_output(crank_slider(0.1, 0.3, 0.05), point="B", direction=math.pi / 2),
        with_output(driven_rod(1.0, 0.2, 0.7), link=3),
    ):
        assert solve_kinematics(scaled(mechanism, size)).summaries[0].dead_centres == ()


def test_more_than_two_reversals() -> None:
    """A point of the coupler near the crank pin: its x, y turn with the crank; the four-bar's coupler angle twice."""
    spec = load_spec(CONFIGS / "four-dyads.toml")
    for summary in solve_kinematics(spec).summaries:
        assert len(summary.dead_centres) % 2 == 0
    mechanism = with_input(with_output(shaper(), link=4), start=0.1)
    (summary,) = solve_kinematics(mechanism).summaries
    count = reversals_by_scan(mechanism)
    assert len(summary.dead_centres) == count
    assert count > 2
    assert summary.working_angle is None
    with pytest.raises(NoSolutionError, match=f"it has {count}"):
        solve_kinematics(with_grid(mechanism, working=6, idle=4))


def reversals_by_scan(mechanism: Mechanism, count: int = 100_000) -> int:
    result = solve_kinematics(with_grid(mechanism, positions=count))
    return int(np.count_nonzero(np.diff(np.sign(result.ds[0]))))


@pytest.mark.parametrize("d", [0.3, 0.01, 1e-4])
def test_a_link_that_goes_round_and_reverses(d: float) -> None:
    """The angle 3 of a drag-link is continuous over the turn and gains exactly one turn."""
    result = solve_kinematics(full_turn(slotted(0.1, 0.1 * (1 + d)), positions=4))
    k = result.trace.link_ids.index(3)
    for speed in (1.0, -1.0):
        result = solve_kinematics(with_input(full_turn(slotted(0.1, 0.1 * (1 + d)), positions=4), speed=speed))
        assert result.trace.angle[k][-1] - result.trace.angle[k][0] == pytest.approx(speed * TURN, abs=1e-9)
        assert result.s[0, -1] == pytest.approx(speed * TURN, abs=1e-9)


@pytest.mark.parametrize("speed", [1.0, -1.0])
@pytest.mark.parametrize("resistance", ["positive", "negative", None])
def test_strokes_of_a_link_that_goes_round_and_swings_back(speed: float, resistance: str | None) -> None:
    """It gains a turn: one stroke is a turn longer than the other, which goes back."""
    mechanism = with_input(with_output(drag_link(), link=4, resistance=resistance), speed=speed)
    fine = solve_kinematics(with_grid(mechanism, positions=20_000))
    (summary,) = fine.summaries
    assert fine.s[0, -1] == pytest.approx(speed * TURN)
    back = abs(summary.dead_centres[0].value - summary.dead_centres[1].value) % TURN
    assert summary.stroke == pytest.approx(TURN + min(back, TURN - back), abs=1e-9)
    begin = summary.dead_centres[0].x + speed * 1e-3
    rate = solve_kinematics(part(mechanism, begin, begin + 1e-4)).ds[0, 0] * speed
    if resistance is not None:
        assert (rate < 0) == (resistance == "positive")
    else:
        assert summary.working_angle is not None
        assert summary.working_angle > math.pi


def by_mpmath(l1: float, l2: float, e: float, order: int, guess: float) -> tuple[float, float]:
    """Extremum of a derivative of x_B, with 40 digits."""
    with mpmath.workdps(40):
        l1, l2, e = mpmath.mpf(str(l1)), mpmath.mpf(str(l2)), mpmath.mpf(str(e))

        def x_b(phi: mpmath.mpf) -> mpmath.mpf:
            return l1 * mpmath.cos(phi) + mpmath.sqrt(l2**2 - (e - l1 * mpmath.sin(phi)) ** 2)

        at = mpmath.findroot(lambda p: mpmath.diff(x_b, p, order + 1), guess)
        return float(at), float(mpmath.diff(x_b, at, order))


@pytest.mark.parametrize("lengths", [(0.1, 0.32, -0.04), (0.1, 0.15, 0.03), (0.1, 0.11, 0.0)])
def test_extreme_velocities_and_accelerations_to_nearly_full_precision(lengths: tuple[float, float, float]) -> None:
    w = 31.0
    (summary,) = solve_kinematics(with_input(full_turn(crank_slider(*lengths)), speed=w)).summaries
    for order, found in ((1, summary.velocity), (2, summary.acceleration)):
        for extreme in found:
            at, value = by_mpmath(*lengths, order, extreme.x)
            assert extreme.x == pytest.approx(at, abs=1e-9)
            assert extreme.value == pytest.approx(value * w**order, rel=1e-12)


def scanned(mechanism: Mechanism, result: Kinematics, output: Output) -> list[tuple[float, float]]:
    """Smallest and largest velocity and acceleration over a scan of 200 001 positions."""
    chain = compile_chain(mechanism, result.structure, result.variants)
    low, high = min(result.x[0], result.x[-1]), max(result.x[0], result.x[-1])
    x = np.linspace(low, high, 200_001)
    _, rate, rate2 = coordinate_of(chain, output, chain.evaluate(x))
    v, a = result.in_time(np.broadcast_to(rate, x.shape), np.broadcast_to(rate2, x.shape))
    return [(float(values.min()), float(values.max())) for values in (v, a)]


@sparing("config", TEN_KINDS, every=4)
@pytest.mark.parametrize("eps", [0.0, 30.0])
def test_extremes_of_the_ready_specs(config: str, eps: float) -> None:
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    mechanism = with_input(to_linkage(load_spec(CONFIGS / f"{config}.toml").mechanism), acceleration=eps)
    result = solve_kinematics(mechanism)
    for summary, output in zip(result.summaries, mechanism.outputs, strict=True):
        check_extremes(summary.velocity + summary.acceleration, scanned(mechanism, result, output))


@sparing("seed", range(25), every=6)
def test_extremes_over_a_part_of_a_turn(seed: int) -> None:
    """Whether they stand inside, in the last cell of the survey, or at an end of the range."""
    mechanism = build(np.random.default_rng(seed), span=math.radians(25)).mechanism
    try:
        result = solve_kinematics(mechanism)
    except AssemblyError:
        return
    (summary,) = result.summaries
    check_extremes(summary.velocity + summary.acceleration, scanned(mechanism, result, mechanism.outputs[0]))
    low, high = min(result.x[0], result.x[-1]), max(result.x[0], result.x[-1])
    for extreme in summary.velocity + summary.acceleration:
        assert low - 1e-12 <= extreme.x <= high + 1e-12


def check_extremes(found: tuple[Extreme, ...], scan: list[tuple[float, float]]) -> None:
    scale = [max(map(abs, pair)) for pair in scan]
    for k, (pair, size) in enumerate(zip(scan, scale, strict=True)):
        low, high = found[2 * k], found[2 * k + 1]
        assert low.value <= pair[0] + 1e-12 * size
        assert high.value >= pair[1] - 1e-12 * size
        assert low.value == pytest.approx(pair[0], abs=1e-6 * size)
        assert high.value == pytest.approx(pair[1], abs=1e-6 * size)


@pytest.mark.parametrize("first", [-0.006, -0.003, -0.002, -1e-3, -1e-5, 1e-5, 1e-3, 0.01])
def test_an_extreme_in_the_last_cell_of_a_range(first: float) -> None:
    """x_B of an in-line crank-slider is greatest in acceleration at 0: also if the range begins just before."""
    mechanism = part(crank_slider(0.1, 0.3), first, 1.5)
    (summary,) = solve_kinematics(mechanism).summaries
    at = max(first, 0.0)
    assert summary.acceleration[0].x == pytest.approx(at, abs=1e-6)
    dead = [centre.x for centre in summary.dead_centres]
    assert dead == ([] if at > 0 else pytest.approx([0.0], abs=1e-14))


def test_two_turns_list_every_dead_centre() -> None:
    result = solve_kinematics(with_grid(full_turn(crank_slider(0.1, 0.3), start=0.5), span=2 * TURN, positions=48))
    (summary,) = result.summaries
    assert [c.x for c in summary.dead_centres] == pytest.approx([math.pi, TURN, 3 * math.pi, 2 * TURN], abs=1e-13)
    assert summary.stroke == pytest.approx(0.2)
    assert summary.working_angle is None


def test_a_rocker_has_two_dead_centres_wherever_position_0_stands() -> None:
    """They stand where crank and coupler are in line; none is lost or doubled at the seam of the turn."""
    l1, l2, l3, c = 0.1, 0.35, 0.3, 0.4
    expected = [
        math.acos((c**2 + (l2 + s * l1) ** 2 - l3**2) / (2 * c * (l2 + s * l1))) + (s < 0) * math.pi for s in (1, -1)
    ]
    for centre in expected:
        for off in (0.0, 1e-12, -1e-12, math.radians(0.5), math.radians(-0.5), 0.3):
            (summary,) = solve_kinematics(full_turn(four_bar(l1, l2, l3, c), centre + off)).summaries
            found = sorted(each.x % TURN for each in summary.dead_centres)
            assert found == pytest.approx(sorted(expected), abs=1e-12)


def test_outputs_default_to_the_last_link_on_the_frame() -> None:
    assert solve_kinematics(replace(shaper(), outputs=())).outputs == ("D0",)
    assert solve_kinematics(replace(full_turn(four_bar(1, 6, 3, 7)), outputs=())).outputs == ("3",)


def test_a_crank_alone_has_no_output() -> None:
    crank = Mechanism(
        Link(0, {"O": 0j}),
        (Link(1, {"O": 0j, "A": 0.1 + 0j}),),
        (Joint("O", "revolute", (0, 1), (0j, 0j)),),
        Input("O", 2.0, start=0.0),
    )
    result = solve_kinematics(crank)
    assert result.outputs == ()
    assert result.s.shape == (0, 25)
    np.testing.assert_allclose(np.abs(result.trace.r[0]), 0.1, rtol=1e-15)


def test_what_is_constant_has_no_place_of_its_own() -> None:
    """A crank's own angle turns evenly: its velocity is the same everywhere, its acceleration zero."""
    mechanism = replace(crank_slider(0.1, 0.3), outputs=(Output(link=1),), input=Input("O", 2.0, start=0.3))
    (summary,) = solve_kinematics(mechanism).summaries
    assert summary.velocity == (Extreme(2.0, 0.3), Extreme(2.0, 0.3))


def test_every_place_lies_within_the_analysed_turn() -> None:
    for speed in (1.0, -1.0):
        mechanism = replace(crank_slider(0.1, 0.3), input=Input("O", speed, start=1.579))
        result = solve_kinematics(mechanism)
        places = [e.x for pair in (result.summaries[0].velocity, result.summaries[0].acceleration) for e in pair]
        places += [q.transmission_at for q in result.qualities if q.transmission_at is not None]
        for x in places:
            assert 0 <= (x - 1.579) * speed < 2 * np.pi + 1e-9
