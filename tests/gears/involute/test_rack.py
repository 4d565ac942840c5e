"""The tip of the basic rack: the usual rounding, the largest that fits, and what is said where none does."""

import re
from dataclasses import replace
from math import cos, pi, radians, sin, tan

import pytest

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.gears.involute.profile.form import form_radius
from tmmcalc.gears.involute.profile.rounding import rounding
from tmmcalc.gears.involute.rack import Rack, require_tool, section
from tmmcalc.gears.involute.wheel import Wheel


@pytest.mark.parametrize("angle", [14.5, 20, 22, 22.6, 25, 28, 30])
@pytest.mark.parametrize("helix", [0, 15, 45])
def test_all_usual_angles_have_a_tool(angle, helix):
    rack = Rack(radians(angle))
    section(rack, radians(helix))
    alpha, rho = rack.angle, rack.radius
    assert rho == pytest.approx(min(0.25 / (1 - sin(alpha)), rack.full_radius))
    # S lies rho below the tip; the flank ends where its normal through S meets it
    end = 1.25 - rho + rho * sin(alpha)
    assert rack.straight == pytest.approx(end, rel=1e-14)
    width = pi / 2 - 2 * end * tan(alpha) - 2 * rho * cos(alpha)
    assert width >= -1e-15
    assert rack.limited == (angle > 22.5)
    assert not rack.limited or width == pytest.approx(0, abs=1e-15)
    for shape in ("ellipse", "circle"):
        wheel = Wheel(30, 0.1, radians(helix), rack)
        tip = rounding(wheel, shape)
        assert tip.flat >= 0
        assert tip.limit == pytest.approx(float(wheel.limit), rel=1e-13)
        assert float(form_radius(wheel, shape)) >= wheel.base


def test_largest_sizes_that_would_do():
    for rack in (Rack(radians(35)), Rack(radians(25), tip_radius=0.4), Rack(addendum=1.95), Rack(clearance=1.2)):
        with pytest.raises(NoSolutionError, match="wider than the tooth of the rack by") as told:
            require_tool(rack)
        remedy = told.value.remedy
        sizes = {"tip_radius": "tip radius", "addendum": "addendum", "clearance": "clearance", "angle": "profile angle"}
        tried = 0
        for field, words in sizes.items():
            named = re.search(rf"{words} of at most ([\d.]+)", remedy)
            if named is None:
                continue
            value = radians(float(named[1])) if field == "angle" else float(named[1])
            own = 0.0 if rack.tip_radius is None else rack.tip_radius
            require_tool(replace(rack, **({"tip_radius": own} | {field: value})))
            more = value + (radians(0.011) if field == "angle" else 1.1e-4)
            with pytest.raises(NoSolutionError):
                require_tool(replace(rack, **({"tip_radius": own} | {field: more})))
            tried += 1
        assert tried >= 2
