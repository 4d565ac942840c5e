"""Every ready spec by every method: finite, silent, in agreement; and outputs that hardly move."""

from __future__ import annotations

import math
import warnings
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from random_mechanisms import build
from ready import LINKAGES
from sparing import sparing

from linkage.scenes import CONFIGS, bar, crank_slider, driven_rod, full_turn, part, pin, slide, with_output, yoke
from tmmcalc import AssemblyError, Method, SingularityError, load_spec, solve_kinematics

SPECS = [CONFIGS / f"{name}.toml" for name in LINKAGES]


@sparing("spec", SPECS, ids=lambda path: path.stem, every=24)
def test_every_ready_spec_by_every_method(spec: Path) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        one, two = (solve_kinematics(load_spec(spec), Method(name)) for name in ("closed", "projection"))
        by_differences = solve_kinematics(load_spec(spec), Method("differences", step=1e-4))
    for rows in ("dr", "ddr", "dangle", "ddangle", "ds", "dds"):
        exact = getattr(one.trace, rows)
        scale = 1 + np.max(np.abs(exact), initial=0.0)
        np.testing.assert_allclose(getattr(two.trace, rows), exact, atol=1e-12 * scale)
        np.testing.assert_allclose(getattr(by_differences.trace, rows), exact, atol=1e-6 * scale)


def test_constant_columns_of_a_yoke_on_a_fixed_guide() -> None:
    """The matrix of the projections is one for all positions there."""
    one, two = (solve_kinematics(full_turn(yoke(0.1, 1.1)), Method(name)) for name in ("closed", "projection"))
    np.testing.assert_allclose(two.trace.ddr, one.trace.ddr, atol=1e-15)


def test_differences_beside_a_limit_are_refused() -> None:
    """The position exists, the one half a step farther does not."""
    mechanism = part(crank_slider(0.1, 0.15, 0.08), math.asin(-0.7) + 1e-3, 1.0)
    assert np.all(np.isfinite(solve_kinematics(mechanism).trace.ddr))
    with pytest.raises(SingularityError, match="a position beside it does not assemble"):
        solve_kinematics(mechanism, Method("differences"))


def test_differences_of_a_driven_slider_step_in_metres() -> None:
    mechanism = driven_rod(1.0, 0.2, 0.5)
    exact, found = solve_kinematics(mechanism), solve_kinematics(mechanism, Method("differences"))
    np.testing.assert_allclose(found.dds, exact.dds, rtol=1e-4)


def test_an_output_that_cannot_move_has_a_summary() -> None:
    """A slider held by a straight guide of the frame: its angle and its distance from the line are constant."""
    for what in ({"link": 3}, {"point": "B", "direction": math.pi / 2}):
        (summary,) = solve_kinematics(with_output(full_turn(crank_slider(0.1, 0.3)), **what)).summaries
        assert summary.dead_centres == ()
        assert summary.velocity[0].value == pytest.approx(0.0, abs=1e-16)


def test_a_group_that_hangs_on_the_frame_alone_stands_still() -> None:
    """Two sliders on two guides of the frame, pinned together: one value stands for all positions."""
    base = full_turn(crank_slider(0.1, 0.3))
    mechanism = replace(
        base,
        links=(*base.links, bar(4, K=0), bar(5, K=0, L=0.1)),
        joints=(*base.joints, slide("K4", 4, 0, 0.2j), pin("K", 4, 5), slide("K5", 5, 0, 0.4, math.pi / 2)),
    )
    for what in ({"joint": "K5"}, {"point": "L"}, {"link": 5}):
        result = solve_kinematics(with_output(mechanism, **what))
        (summary,) = result.summaries
        assert summary.dead_centres == ()
        assert result.s.shape == (1, 25)
        assert not result.s.any()
    assert result.trace.r[result.trace.point_names.index("K"), 7] == pytest.approx(0.4 + 0.2j)


@sparing("seed", range(60), every=6)
def test_random_chains_over_wide_ranges_answer_or_say_why(seed: int) -> None:
    """A result without NaN, or an error of the tree; never a warning, never another exception."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for span in (1.0, 3.0, 2 * math.pi):
            mechanism = build(np.random.default_rng(seed), span=span).mechanism
            try:
                result = solve_kinematics(mechanism)
            except (AssemblyError, SingularityError):
                continue
            assert np.all(np.isfinite(result.trace.ddr))
            assert np.all(np.isfinite([q.amplification for q in result.qualities]))
