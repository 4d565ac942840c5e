"""The textbook's recurrence against its tables, its own exactness, and the exact regime as the step shrinks."""

from __future__ import annotations

import math

import numpy as np
import pytest

from machine.motion import CASES, TURN, Parabola, of_pieces, shaper_inertia, upsetter, upsetter_motor
from tmmcalc.core.errors import AccuracyError, NoSolutionError, UsageError
from tmmcalc.core.numerics.panels import panels
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.nodes import nodal_tables
from tmmcalc.machine.recurrence import Nodes, march, multiplier, on_nodes, periodic, turns, warning
from tmmcalc.machine.steady import driven

IDLE = CASES["dyn-shaper-motion-idle"]
PARABOLA = upsetter_motor("par")


def idle(n: int) -> Nodes:
    phi = np.linspace(0, TURN, n + 1)
    inertia = shaper_inertia(phi) + IDLE["inputs"]["J_const"]
    return Nodes(0 * phi, inertia, IDLE["expected"]["A"], IDLE["expected"]["B"], TURN / n)


def test_shaper_case_turn_by_turn() -> None:
    expected = IDLE["expected"]
    history = turns(idle(24), expected["omega_N"])
    assert history[0].first == expected["omega_N"]
    first = march(idle(24), expected["omega_N"])
    np.testing.assert_allclose(first.omega, expected["omega_first_rev_from_omega_N"], atol=1e-5)
    second = march(idle(24), history[1].first)
    np.testing.assert_allclose(second.omega, expected["omega_second_rev"], atol=1e-5)
    assert len(history) == 2  # "usually two revolutions"
    assert abs(history[-1].last - history[-1].first) < 1e-4
    assert [turn.first for turn in history[1:]] == [turn.last for turn in history[:-1]]


def test_shaper_case_periodic() -> None:
    expected = IDLE["expected"]
    regime = periodic(idle(24))
    np.testing.assert_allclose(regime.omega, expected["omega_periodic_n24"], atol=1e-6)
    assert (regime.node_min, regime.node_max) == (expected["i_min"], expected["i_max"])
    assert regime.delta == pytest.approx(expected["delta_n24"], rel=1e-5)
    assert regime.omega[0] == pytest.approx(regime.omega[-1], rel=1e-15)
    assert regime.warning == pytest.approx(0.65, abs=0.01)
    for n, delta in expected["delta_by_n"].items():
        assert periodic(idle(int(n))).delta == pytest.approx(delta, rel=1e-5)
    assert warning(idle(12)) == pytest.approx(1.3, abs=0.01)


def test_upsetter_deltas_by_n() -> None:
    for n, delta in CASES["dyn-upsetter-regime-30"]["expected"]["discrete_parabola_delta_by_n"].items():
        nodes = on_nodes(upsetter(), 30.6, PARABOLA.a, PARABOLA.b, int(n))
        assert periodic(nodes).delta == pytest.approx(delta, rel=1e-5)


def test_deltas_of_the_flywheel_correction() -> None:
    """The history of the case runs on this recurrence: every delta of it with the inertia beside it."""
    case = CASES["dyn-upsetter-flywheel-motor"]
    for inertia, delta in case["expected"]["iteration_Jc_delta"]:
        nodes = on_nodes(upsetter(), inertia, PARABOLA.a, PARABOLA.b, case["inputs"]["n"])
        assert periodic(nodes).delta == pytest.approx(delta, rel=1e-5)


def test_turns_are_marches_one_after_the_other() -> None:
    nodes = on_nodes(upsetter(), 200.0, PARABOLA.a, PARABOLA.b, 24)
    history = turns(nodes, 9.0)
    assert len(history) > 3
    for turn in history:
        assert turn.last == pytest.approx(march(nodes, turn.first).omega[-1], rel=1e-14)
    with pytest.raises(AccuracyError, match="step is too wide"):
        turns(on_nodes(upsetter(0.3), 0.2, PARABOLA.a, PARABOLA.b, 12), 2.0 * PARABOLA.synchronous)


def test_every_step_is_the_formula() -> None:
    nodes = on_nodes(upsetter(), 5.0, PARABOLA.a, PARABOLA.b, 36)
    w = march(nodes, 10.2).omega
    h, a, b = nodes.step, nodes.a, nodes.b
    for i in range(1, 37):
        work = (nodes.moment[i - 1] + nodes.moment[i] + 2 * a) * h
        expected = ((nodes.inertia[i - 1] - b * h) * w[i - 1] ** 2 + work) / (nodes.inertia[i] + b * h)
        assert w[i] ** 2 == pytest.approx(expected, rel=1e-14)


def test_the_multiplier_is_that_of_two_neighbouring_motions() -> None:
    nodes = on_nodes(upsetter(), 40.0, PARABOLA.a, PARABOLA.b, 24)
    one, two = march(nodes, 10.0).omega, march(nodes, 10.1).omega
    measured = (two[-1] ** 2 - one[-1] ** 2) / (two[0] ** 2 - one[0] ** 2)
    assert multiplier(nodes) == pytest.approx(measured, rel=1e-10)
    assert periodic(nodes).multiplier == multiplier(nodes)


def test_second_order_in_the_step() -> None:
    """Against the exact regime; the load of the upsetter has its jump of slope on a node."""
    exact = driven(upsetter(), 30.6, PARABOLA)
    errors = []
    for n in (24, 48, 96, 192):
        nodes = on_nodes(upsetter(), 30.6, PARABOLA.a, PARABOLA.b, n)
        errors.append(np.max(np.abs(periodic(nodes).omega - exact.omega_at(np.linspace(0, TURN, n + 1)))))
    np.testing.assert_allclose(errors[:3], [1.2e-2, 3.1e-3, 7.8e-4], rtol=0.05)
    np.testing.assert_allclose(np.log2(np.array(errors[:-1]) / errors[1:]), 2.0, atol=0.05)


def test_the_larger_load_counts_where_it_jumps() -> None:
    cycle = of_pieces([-30.0, 0.0], [0.0, math.pi, TURN])
    nodes = on_nodes(cycle, 4.0, 100.0, 1.0, 4)
    np.testing.assert_allclose(nodes.moment, [-30.0, -30.0, -30.0, 0.0, -30.0], atol=1e-12)
    np.testing.assert_allclose(nodes.inertia, 4.0)


def test_constant_load_is_exact_at_any_step() -> None:
    cycle = of_pieces([-20.0], [0.0, 2 * TURN])
    regime = periodic(on_nodes(cycle, 3.0, 100.0, 0.8, 6))
    np.testing.assert_allclose(regime.omega, 10.0, rtol=1e-14)
    assert regime.delta < 1e-14


def test_a_step_too_wide_is_told() -> None:
    nodes = on_nodes(upsetter(0.3), 0.2, PARABOLA.a, PARABOLA.b, 12)
    assert warning(nodes) > 10
    with pytest.raises(AccuracyError, match="step is too wide") as caught:
        march(nodes, 2.0 * PARABOLA.synchronous)
    assert "more nodes" in caught.value.remedy


def test_a_load_too_large_is_told() -> None:
    nodes = Nodes(np.full(13, -900.0), np.full(13, 30.0), 100.0, 1.0, TURN / 12)
    with pytest.raises(AccuracyError, match="the load stops the machine"):
        march(nodes, 10.0)
    with pytest.raises(AccuracyError, match="no speed repeats"):
        periodic(nodes)


def test_what_cannot_settle_is_told() -> None:
    nodes = on_nodes(upsetter(), 1e7, PARABOLA.a, PARABOLA.b, 24)
    with pytest.raises(AccuracyError, match="after 1000 cycles"):
        turns(nodes, 5.0, tolerance=1e-6)
    flat = Nodes(np.full(13, -10.0), np.full(13, 30.0), 10.0, 0.0, TURN / 12)
    with pytest.raises(NoSolutionError, match="does not regulate"):
        periodic(flat)
    np.testing.assert_allclose(march(flat, 7.0).omega, 7.0, rtol=1e-14)


def test_tables_that_are_no_cycle() -> None:
    row = np.ones(5)
    for moment, inertia, b, step in (
        (row, np.ones(4), 1.0, 0.1),
        (row[:1], row[:1], 1.0, 0.1),
        (row, 0 * row, 1.0, 0.1),
        (row, row, -1.0, 0.1),
        (row, row, 1.0, 0.0),
    ):
        with pytest.raises(UsageError):
            Nodes(moment, inertia, 1.0, b, step)
    with pytest.raises(UsageError):
        on_nodes(upsetter(), 1.0, 1.0, 1.0, 1)


def test_the_parabola_of_the_tests_is_the_textbook_s() -> None:
    nominal, sync, moment = 10.0, PARABOLA.synchronous, 110.0
    assert isinstance(PARABOLA, Parabola)
    assert pytest.approx(moment * sync**2 / (sync**2 - nominal**2)) == PARABOLA.a
    assert pytest.approx(moment / (sync**2 - nominal**2)) == PARABOLA.b


@pytest.mark.parametrize("beside", [-1, 0, 1])
def test_a_load_that_begins_at_a_node_counts_there(beside: int) -> None:
    """Whether rounding puts the jump on the node, before it or behind it: the larger load is that of the node."""
    edge = np.linspace(0, TURN, 25)[2]
    edge = edge if beside == 0 else np.nextafter(edge, np.inf * beside)
    on = panels(0.0, TURN, (edge,))
    load = np.where(on.x > edge, -100.0, 0.0)
    nothing = np.zeros_like(load)
    moment, _ = nodal_tables(Cycle(on, nothing + 1, nothing, load, nothing, nothing, 5.0), 24, 5.0)
    assert moment[1:3].tolist() == pytest.approx([0.0, -100.0])
