"""What cannot be solved says what is lacking, where, and what to do."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

import tmmcalc
from linkage.loops.worked import case, class_four
from tmmcalc import Assembly, Input, Mechanism


def six(**changes: Any) -> Mechanism:
    """Six assemblies at position 0."""
    given, _ = case("A-C4-MODES")
    mechanism = class_four(given, 1.0, complex(*given["F"]) + 1)
    return replace(mechanism, assembly=Assembly(**changes))


def test_nothing_tells_the_assembly() -> None:
    with pytest.raises(tmmcalc.NoSolutionError, match="6 assemblies at angle_1 = 0 deg, and nothing tells") as error:
        tmmcalc.solve_kinematics(six())
    assert "--assemblies lists them" in str(error.value)


def test_a_sketch_between_two_assemblies() -> None:
    """A point as far from two of the places of C, on their bisector."""
    listing = tmmcalc.list_assemblies(six())
    one, two = (assembly.points["C"] for assembly in listing.assemblies[:2])
    with pytest.raises(tmmcalc.NoSolutionError, match="equally near to the assemblies 1 and 2"):
        tmmcalc.solve_kinematics(six(sketch={"C": (one + two) / 2}))


def test_a_number_that_is_too_large() -> None:
    with pytest.raises(tmmcalc.UsageError, match="there is no assembly 7: at angle_1 = 0 deg the group has 6"):
        tmmcalc.solve_kinematics(six(variants={(2, 3, 4, 5): 7}))


def test_no_assembly_there() -> None:
    given, expected = case("A-C4-RANGE")
    mechanism = class_four(given, 0.1, 0.1 + expected["AF_max"] + 1e-3)
    with pytest.raises(tmmcalc.NoSolutionError, match="no assembly exists at angle_1 = 0 deg"):
        tmmcalc.solve_kinematics(mechanism)


def test_nothing_tells_where_the_assembly_is_chosen() -> None:
    mechanism = replace(six(variants={(2, 3, 4, 5): 1}), input=Input("O", 1.0))
    with pytest.raises(tmmcalc.NoSolutionError, match=r"neither assembly\.at nor input\.start"):
        tmmcalc.solve_kinematics(mechanism)


def test_the_list_ends_where_nothing_tells() -> None:
    listing = tmmcalc.list_assemblies(six())
    assert listing.undecided == "IV(2,3,4,5)"
    assert [one.variant for one in listing.assemblies] == [1, 2, 3, 4, 5, 6]
    assert not any(one.taken for one in listing.assemblies)
