"""What cannot be solved says what is lacking, where, and what to do."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import pytest

import tmmcalc
from linkage.loops.worked import case, class_four, class_three
from linkage.scenes import bar, four_bar, pin
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
    assert "nothing tells which one is meant" in listing.reason


def test_the_list_says_why_a_number_names_nothing() -> None:
    listing = tmmcalc.list_assemblies(six(variants={(2, 3, 4, 5): 7}))
    assert (listing.undecided, len(listing.assemblies)) == ("IV(2,3,4,5)", 6)
    assert "there is no assembly 7" in listing.reason


def test_the_list_says_that_a_dyad_does_not_reach() -> None:
    mechanism = replace(four_bar(1, 2, 1, 5), input=Input("O", 1.0, start=math.pi))
    listing = tmmcalc.list_assemblies(mechanism)
    assert (listing.undecided, listing.assemblies) == ("RRR(2,3)", ())
    assert "no assembly variant of RRR(2,3) exists at angle_1 = 180 deg" in listing.reason


def test_the_listed_and_the_solved_assembly_are_one() -> None:
    """With a sketch of an extreme start, too, which each variant reads at its own extreme."""
    for sign in (1, -1):
        base = replace(four_bar(1, 6, 3, 7, variant=sign), input=Input("O", 1.0))
        drawn = tmmcalc.solve_kinematics(base)
        place = complex(drawn.trace.r[drawn.trace.point_names.index("B"), 0])
        sketched = replace(base, assembly=Assembly(sketch={"B": place + 0.1, "A": 0.5 + 0j}))
        listing = tmmcalc.list_assemblies(sketched)
        assert listing.x == pytest.approx(drawn.x[0], abs=1e-12)
        assert [one.variant for one in listing.assemblies if one.taken] == [sign]


def test_a_singular_assembly_is_no_start() -> None:
    """Both legs of a parallelogram's plate and its third one are parallel: the plate may go two ways."""
    legs = {"leg_lengths": [1.0, 1.0, 1.0], "platform_local": {"P1": [0, 0], "P2": [1, 0], "P3": [2, 0]}}
    mechanism = class_three(legs | {"Q2": [1.2, 0], "Q3": [2.2, 0]}, 0.2, variants={(2, 3, 4, 5): 1})
    with pytest.raises(tmmcalc.SingularityError, match="a singular position, from which the motion can go on in two"):
        tmmcalc.solve_kinematics(mechanism)


@pytest.mark.parametrize(
    ("changes", "text"),
    [
        ({"joints": (pin("O", 0, 1), pin("O", 1, 2))}, "two joints have the name O"),
        ({"links": (bar(1), bar(1))}, "two links have the number 1"),
        ({"links": (bar(0), bar(1))}, "two links have the number 0, the frame's"),
        ({"joints": (pin("O", 0, 1), pin("A", 1, 9))}, "joint A is at link 9, which does not exist"),
        ({"input": Input("X", 1.0)}, "the input is at joint X, which does not exist"),
    ],
    ids=["joints", "links", "frame", "no link", "no joint"],
)
def test_names_that_mean_two_things_or_none(changes: dict[str, Any], text: str) -> None:
    with pytest.raises(tmmcalc.UsageError, match=text):
        replace(six(), **changes)
