"""Instant efficiency and power: closed forms of an in-line crank-slider with a rough guide, and blanks.

Rod and slider have no mass. The rod at the angle psi presses the slider with S along the guide and S tan psi across
it, so of a driven slider Q = S (1 - f tan psi), of one that drives the crank S = Q/(1 + f tan psi).
"""

from __future__ import annotations

import numpy as np
import pytest
from linkage.scenes import crank_slider, full_turn, with_grid, with_input

from tmmcalc import solve_kinematics
from tmmcalc.linkage.loading import Load, Loading, Pair, Window
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.machine.facts.reduction import document as reduction_document
from tmmcalc.machine.reduction.columns import cells, columns
from tmmcalc.machine.reduction.efficiency import efficiency
from tmmcalc.machine.reduction.results import Reduction
from tmmcalc.machine.reduction.solve import solve_reduction
from tmmcalc.rooms import STAGES

R, L, F, Q = 0.1, 0.25, 0.2, 500.0
OUT, BACK = (np.pi, 2 * np.pi), (0.0, np.pi)  # along the motion: the slider moves along +x, along -x


def reduced(friction: float, *windows: tuple[float, float], speed: float = 3.0) -> Reduction:
    """Under a force along -x in these windows."""
    mechanism = with_grid(with_input(full_turn(crank_slider(R, L)), speed=speed), positions=24)
    loads = tuple(
        Load(f"Q{k}", 3, "force", Constant(-Q), window=Window(angles=window)) for k, window in enumerate(windows)
    )
    kinematics = solve_kinematics(mechanism)
    return solve_reduction(mechanism, Loading(loads=loads, pairs=(Pair("B0", friction),)), kinematics)


def slope(result: Reduction) -> np.ndarray:
    """|tan psi| of the rod."""
    s = R * np.abs(np.sin(result.phi)) / L
    return s / np.sqrt(1 - s**2)


@pytest.mark.parametrize("speed", [3.0, -3.0])
def test_a_working_machine(speed: float) -> None:
    """Against the motion the whole way out; blank on the way back and in the dead centres."""
    result = reduced(F, OUT, speed=speed)
    eta, known = efficiency(result)
    np.testing.assert_array_equal(np.flatnonzero(known), range(13, 24))
    np.testing.assert_allclose(eta[known], (1 - F * slope(result))[known], rtol=1e-12)


def test_an_engine() -> None:
    """A force with the motion on the way back alone drives the crank."""
    result = reduced(F, BACK)
    eta, known = efficiency(result)
    inner = np.sin(result.phi) > 1e-9
    np.testing.assert_array_equal(known, inner)
    np.testing.assert_allclose(eta[known], 1 / (1 + F * slope(result))[known], rtol=1e-12)


def test_an_engine_that_drives_a_load() -> None:
    """What the load takes is useful too: with nothing rubbing all of the power is, however little is left over."""
    mechanism = with_grid(with_input(full_turn(crank_slider(R, L)), speed=3.0), positions=24)
    loads = (
        Load("gas", 3, "force", Constant(-Q), window=Window(angles=BACK)),
        Load("generator", 1, "moment", Constant(-25.0)),
    )
    result = solve_reduction(mechanism, Loading(loads=loads), solve_kinematics(mechanism))
    eta, known = efficiency(result)
    np.testing.assert_array_equal(known, np.sin(result.phi) > 1e-9)
    np.testing.assert_allclose(eta[known], 1.0, rtol=1e-12)


def test_a_force_that_gives_back_what_it_takes_drives_and_is_driven() -> None:
    """It puts more work in than the drive that makes up for the friction: by the rule of the cycle an engine."""
    result = reduced(F, OUT, BACK)
    eta, known = efficiency(result)
    np.testing.assert_array_equal(known, np.sin(result.phi) > 1e-9)
    np.testing.assert_allclose(eta[known], 1 / (1 + F * slope(result))[known], rtol=1e-12)


def test_a_load_that_helps_a_working_machine_has_no_efficiency() -> None:
    """A weaker force on the way back than on the way out helps the drive, and nothing useful is done there."""
    mechanism = with_grid(with_input(full_turn(crank_slider(R, L)), speed=3.0), positions=24)
    loads = tuple(
        Load(name, 3, "force", Constant(-size), window=Window(angles=window))
        for name, size, window in (("Q", Q, OUT), ("help", Q / 4, BACK))
    )
    pairs = (Pair("B0", F),)
    result = solve_reduction(mechanism, Loading(loads=loads, pairs=pairs), solve_kinematics(mechanism))
    _, known = efficiency(result)
    np.testing.assert_array_equal(known, np.sin(result.phi) < -1e-9)


def test_power_and_blanks_in_the_tables() -> None:
    result = reduced(F, OUT)
    named = {column.name: column for column in columns(result)}
    np.testing.assert_array_equal(named["P_red"].make(), result.total * 3.0)
    assert named["M_red"].unit == "N*m"
    eta, known = efficiency(result)
    own = cells(result, named["eta"])
    assert [cell == "" for cell in own] == (~known).tolist()
    stored = STAGES["reduction"].table(result)
    assert stored is not None
    at = stored.header.index("eta[-]")
    assert stored.columns[at].tolist() == ["" if not k else repr(float(e)) for e, k in zip(eta, known, strict=True)]
    view = reduction_document(result, "t", patterns=["phi", "eta"], rows=[18, 3]).table
    assert view is not None
    assert view.columns[2] == [eta[18], ""]


def test_no_loads_no_efficiency() -> None:
    assert "eta" not in {column.name for column in columns(reduced(F))}
