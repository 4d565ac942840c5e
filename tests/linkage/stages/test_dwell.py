"""The stage of a synthesis with a dwell: what it imports."""

from __future__ import annotations

import pytest
from stages.test_laziness import imported, within


@pytest.mark.slow
def test_a_dwell_that_is_given_takes_no_scipy() -> None:
    """Only the search does; the spline of the cross-check is the project's own."""
    names = imported("synth-dwell.toml", "synthesis")
    assert within(names, "tmmcalc.linkage.synthesis.dwell")
    assert not within(names, "scipy", "reportlab", "tmmcalc.feasibility")
