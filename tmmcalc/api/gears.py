"""The Python API of gears: trains, strength, criteria, pairs, contours, profiles."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.api import solved

if TYPE_CHECKING:
    from tmmcalc.gears.gearing import Gearing
    from tmmcalc.gears.meshing.contours import Blocking
    from tmmcalc.gears.meshing.profiles import Profiles
    from tmmcalc.gears.meshing.results import Pairs
    from tmmcalc.gears.selection.results import Selection
    from tmmcalc.gears.single.results import SingleWheel
    from tmmcalc.gears.sizing import Sizing
    from tmmcalc.gears.trains import Trains
    from tmmcalc.project import Spec


def solve_train(spec: Spec) -> Trains:
    """All tooth sets of the gear trains of a spec; raises `NoSolutionError` with what stands in the way of any."""
    return solved(spec, "train")


def solve_strength(spec: Spec) -> Sizing:
    """Modules and face widths of all tooth sets of a spec by the endurance of their teeth."""
    return solved(spec, "strength")


def solve_criteria(spec: Spec) -> Selection:
    """Mass, inertia, size, efficiency of the gear trains of a spec, their Pareto front and the best of them."""
    return solved(spec, "criteria")


def solve_gearing(spec: Spec) -> Gearing:
    """Speeds, torques, power flow and efficiency of the train that a spec writes as members and meshes."""
    return solved(spec, "gearing")


def solve_pairs(spec: Spec) -> Pairs:
    """Geometry, checks and measures of the pairs of gears of a spec, written out or those of its train.

    Raises `NoSolutionError` for pairs that cannot work, with every reason and the nearest admissible shifts.
    """
    return solved(spec, "pair")


def solve_blocking(spec: Spec) -> Blocking:
    """The blocking contours of the external pairs of a spec: all admissible shifts, and where the chosen ones stand."""
    return solved(spec, "blocking")


def solve_profiles(spec: Spec) -> Profiles:
    """Half a tooth of every wheel of the pairs of a spec; lengths in metres."""
    return solved(spec, "profile")


def solve_wheel(spec: Spec) -> SingleWheel:
    """A wheel without a mate: circles, limits of its shift, measures, half a tooth; lengths in metres."""
    return solved(spec, "wheel")
