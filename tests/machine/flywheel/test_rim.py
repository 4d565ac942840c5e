"""Rims and their placement: exact ring, thin limit, both directions, limits of speed and room."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.machine.flywheel.materials import CAST_IRON, MATERIALS, RECOMMENDED, STEEL, Material
from tmmcalc.machine.flywheel.placement import wheels
from tmmcalc.machine.flywheel.rim import (
    Proportions,
    Rim,
    largest_diameter,
    rim_of_diameter_and_thickness,
    rim_of_mean_diameter,
    rim_of_outer_diameter,
    rim_of_proportions,
    rim_of_section,
)
from tmmcalc.machine.model import FlywheelTask

WHOLE = Proportions(rim_inertia=1.0, rim_mass=1.0)


def ring(rim: Rim) -> tuple[float, float]:
    """Mass and inertia of the full ring as the difference of two disks."""
    disks = [math.pi * rim.material.density * rim.width * (d / 2) ** 2 for d in (rim.outer, rim.inner)]
    return disks[0] - disks[1], (disks[0] * (rim.outer / 2) ** 2 - disks[1] * (rim.inner / 2) ** 2) / 2


class TestRing:
    @given(st.floats(0.1, 500), st.floats(0.3, 3.0), st.floats(0.5, 4.0))
    def test_mean_diameter(self, inertia: float, diameter: float, ratio: float) -> None:
        try:
            rim = rim_of_mean_diameter(inertia, diameter, 10.0, proportions=Proportions(ratio, 0.1, 0.9, 0.85))
        except NoSolutionError:
            assert ratio * math.pi * CAST_IRON.density * diameter**5 / 2 <= 0.9 * inertia * (1 + 1e-9)
            return
        mass, held = ring(rim)
        assert held == pytest.approx(0.9 * inertia, rel=1e-11)
        assert rim.inertia == pytest.approx(held, rel=1e-11)
        assert rim.mass == pytest.approx(mass, rel=1e-11)
        assert rim.total_mass == pytest.approx(mass / 0.85, rel=1e-11)
        assert rim.width == pytest.approx(ratio * rim.thickness)

    @given(st.floats(0.1, 500), st.floats(0.3, 3.0))
    def test_directions_agree(self, inertia: float, diameter: float) -> None:
        """Diameter -> section -> diameter, and the same wheel by its outer diameter."""
        try:
            rim = rim_of_mean_diameter(inertia, diameter, 10.0)
        except NoSolutionError:
            return
        back = rim_of_section(inertia, rim.width, rim.thickness, 10.0)
        assert back.diameter == pytest.approx(diameter, rel=1e-12)
        wide = rim_of_diameter_and_thickness(inertia, diameter, rim.thickness, 10.0)
        assert wide.width == pytest.approx(rim.width, rel=1e-12)
        same = rim_of_outer_diameter(inertia, rim.outer, 10.0)
        assert same.thickness == pytest.approx(rim.thickness, rel=1e-10)
        assert same.mass == pytest.approx(rim.mass, rel=1e-10)

    def test_thin_limit(self) -> None:
        """m = 4 J/D^2, and both stresses become rho v^2."""
        rim = rim_of_mean_diameter(1e-3, 2.0, 15.0, STEEL, WHOLE)
        assert rim.thin_mass == pytest.approx(4e-3 / 4)
        assert rim.mass == pytest.approx(rim.thin_mass, rel=1e-4)
        assert rim.stress == pytest.approx(7850 * 15.0**2)
        assert rim.peak_stress == pytest.approx(rim.stress, rel=2e-2)

    def test_full_disk_stress(self) -> None:
        """A ring with a pinhole has twice the stress (3 + nu) rho v^2 / 8 of a full disk in its centre."""
        d, h = 0.402, 0.4
        inertia = 7850 * math.pi * d * h * 0.3 * (d * d + h * h) / 4
        rim = rim_of_section(inertia, 0.3, h, 100.0, STEEL, WHOLE)
        hole = rim.inner / rim.outer
        assert hole == pytest.approx(0.002 / 0.802, rel=1e-9)
        disk = 3.3 * 7850 * (rim.outer / 2 * 100) ** 2 / 8
        assert rim.peak_stress == pytest.approx(2 * disk, rel=1e-5)

    def test_worked_example(self) -> None:
        """Cast iron, D = 2 m, J = 120 kg*m^2 all in the rim, b = 2 h: h from D h^2 (D^2 + h^2) = 4 J/(2 pi rho)."""
        rim = rim_of_mean_diameter(120.0, 2.0, 10.0, CAST_IRON, WHOLE)
        h2 = (-4 + math.sqrt(16 + 4 * (4 * 120 / (2 * math.pi * 7200)) / 2)) / 2
        assert rim.thickness == pytest.approx(math.sqrt(h2), rel=1e-9)
        assert rim.mass == pytest.approx(120.0, rel=1e-3)
        assert rim.speed == pytest.approx(10 * (1 + rim.thickness / 2))
        assert rim.allowed
        assert rim.safety == pytest.approx(200e6 / rim.peak_stress)

    def test_proportions(self) -> None:
        rim = rim_of_proportions(5.0, 10.0)
        assert rim.thickness / rim.diameter == pytest.approx(0.1, rel=1e-12)
        assert rim.inertia == pytest.approx(4.5, rel=1e-12)

    def test_speed_limit(self) -> None:
        """On a fast shaft the rim speed sets the diameter."""
        rim = rim_of_proportions(5.0, 150.0)
        assert rim.outer == pytest.approx(largest_diameter(150.0), rel=1e-12)
        assert rim.speed == pytest.approx(30.0, rel=1e-12)
        assert rim.allowed
        assert not rim_of_mean_diameter(5.0, 0.5, 150.0).allowed

    def test_faults(self) -> None:
        with pytest.raises(NoSolutionError, match="full disk"):
            rim_of_mean_diameter(500.0, 0.3, 10.0)
        with pytest.raises(NoSolutionError, match="full disk"):
            rim_of_outer_diameter(500.0, 0.3, 10.0)
        with pytest.raises(NoSolutionError, match="smaller section"):
            rim_of_section(0.1, 1.0, 1.0, 10.0)
        with pytest.raises(NoSolutionError, match="leaves no hole"):
            rim_of_diameter_and_thickness(0.1, 0.2, 0.2, 10.0)
        with pytest.raises(UsageError, match="diameter is -1"):
            rim_of_mean_diameter(1.0, -1.0, 10.0)

    def test_largest_full_wheel(self) -> None:
        """A wheel without a hole is the heaviest of its outer diameter: h = D_o/2, b = D_o."""
        most = math.pi * 7200 * 1.0 * 0.5**4 / 2
        rim = rim_of_outer_diameter(most * (1 - 1e-12), 1.0, 10.0, CAST_IRON, WHOLE)
        assert rim.inner == pytest.approx(0, abs=1e-3)
        with pytest.raises(NoSolutionError):
            rim_of_outer_diameter(most * 1.001, 1.0, 10.0, CAST_IRON, WHOLE)


def task(**more: Any) -> FlywheelTask:
    nothing = dict.fromkeys(("ratio", "diameter", "width", "thickness", "density", "speed_limit"))
    usual = {"delta": 0.04, "inertia": 0.0, "shaft": "input", "material": "cast iron"}
    return FlywheelTask(**{**nothing, **usual, **more})


class TestPlacement:
    def test_square_of_the_ratio(self) -> None:
        on_crank, on_motor = wheels(task(), 40.0, 2.5, 1.0, 4.0)
        assert (on_crank.shaft, on_motor.shaft) == ("input", "motor")
        assert on_motor.inertia == pytest.approx(40 / 16)
        assert on_motor.speed == pytest.approx(10.0)
        energy = [wheel.inertia * wheel.speed**2 for wheel in (on_crank, on_motor)]
        assert energy[0] == pytest.approx(energy[1])
        # geometrically similar wheels: J ~ D^5, m ~ D^3
        assert on_crank.rim is not None
        assert on_motor.rim is not None
        assert on_motor.rim.mass / on_crank.rim.mass == pytest.approx(16**-0.6, rel=1e-9)

    def test_the_asked_shaft_comes_first_and_none_twice(self) -> None:
        def shafts(shaft: str, ratio: float, motor: float | None) -> list[str]:
            return [wheel.shaft for wheel in wheels(task(shaft=shaft), 40.0, 10.5, ratio, motor)]

        assert shafts("input", 1.0, 14.0) == ["input", "motor"]
        assert shafts("motor", 14.0, 14.0) == ["motor", "input"]
        assert shafts("other", 4.0, 14.0) == ["other", "input", "motor"]
        assert shafts("input", 1.0, None) == shafts("input", 1.0, 1.0) == ["input"]

    def test_sizes_are_those_of_the_asked_shaft_alone(self) -> None:
        own, other = wheels(task(shaft="motor", diameter=0.6, width=0.05), 40.0, 10.5, 14.0, 14.0)
        assert own.rim is not None
        assert other.rim is not None
        assert (own.rim.diameter, own.rim.width) == (0.6, 0.05)
        (fast,) = own.verdicts
        assert "m/s, above 30 m/s" in fast.message
        assert (fast.value, fast.limit, fast.unit) == (own.rim.speed, 30.0, "m/s")
        assert other.rim.thickness / other.rim.diameter == pytest.approx(0.1, rel=1e-12)
        assert other.verdicts == ()
        (thin,) = wheels(task(diameter=0.6, thickness=0.05), 4.0, 10.5, 1.0, None)
        assert thin.rim is not None
        assert (thin.rim.diameter, thin.rim.thickness) == (0.6, 0.05)
        assert ring(thin.rim)[1] == pytest.approx(0.9 * 4, rel=1e-11)

    def test_what_is_no_rim(self) -> None:
        (tiny,) = wheels(task(shaft="other"), 40.0, 10.5, 1e9, 1e9)[:1]
        assert tiny.rim is None
        (said,) = tiny.verdicts
        assert said.message.startswith("no rim is sized: at 1.05e+10 rad/s cast iron allows 5.71e-06 mm of outer")
        (light,) = wheels(task(), 1e-10, 10.5, 1.0, None)
        assert light.rim is None
        assert light.verdicts[0].message.startswith("no rim is sized: for 1e-10 kg*m^2 its mean diameter would be ")
        assert wheels(task(), 0.0, 10.5, 1.0, None)[0].rim is None
        (full,) = wheels(task(diameter=0.1), 40.0, 10.5, 1.0, None)
        assert full.rim is None
        assert full.verdicts[0].message.startswith("no such rim: a wheel of 0.1 m mean diameter is a full disk")


class TestData:
    def test_materials(self) -> None:
        for name, material in MATERIALS.items():
            assert material.name == name
            assert material.source
            # the customary rim speed keeps a thin ring far below its strength
            assert 5 < material.strength / (material.density * material.rim_speed**2) < 60

    def test_own_material(self) -> None:
        wood = Material("birch", 700.0, 40.0, 60e6, "user")
        assert rim_of_proportions(1.0, 10.0, wood).material.name == "birch"

    def test_recommended(self) -> None:
        assert all(0 < allowed.smallest <= allowed.largest <= 1 / 5 for allowed in RECOMMENDED)
        assert len({allowed.machine for allowed in RECOMMENDED}) == len(RECOMMENDED)
