"""Groups of all classes, their names and order; the reasons why links and joints are not a mechanism."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from properties import examples
from random_mechanisms import KINDS, RandomMechanism, build, scenes
from transforms import renumbered, swapped

from tmmcalc import StructureError, solve_structure
from tmmcalc.linkage.model import Input, Joint, Link, Mechanism

STABLE = examples(60, derandomize=True, database=None)
CHAIN = st.lists(st.sampled_from(KINDS), min_size=1, max_size=8)


def scheme(links: int, *joints: str, driver: str = "01") -> Mechanism:
    """A mechanism without metric: joints such as ``01`` (revolute of links 0 and 1) or ``30P``."""
    made = tuple(
        Joint(text, "prismatic" if text.endswith("P") else "revolute", (int(text[0]), int(text[1])), (0j, 0j))
        for text in joints
    )
    return Mechanism(Link(0), tuple(Link(k + 1) for k in range(links)), made, Input(driver, 1.0))


FOUR_BAR = ("01", "12", "23", "30")


@pytest.mark.parametrize(
    ("joints", "links", "formula"),
    [
        (FOUR_BAR, 3, "I(0,1) -> II RRR(2,3)"),
        (("01", "12", "23", "30P"), 3, "I(0,1) -> II RRP(2,3)"),
        (("01", "12P", "23", "30"), 3, "I(0,1) -> II RRP(3,2)"),
        (("01", "12", "23P", "30"), 3, "I(0,1) -> II RPR(2,3)"),
        (("01", "12P", "23", "30P"), 3, "I(0,1) -> II PRP(2,3)"),
        (("01", "12", "23P", "30P"), 3, "I(0,1) -> II RPP(2,3)"),
        (("01", "12P", "23P", "30"), 3, "I(0,1) -> II RPP(3,2)"),
    ],
)
def test_the_five_dyads(joints: tuple[str, ...], links: int, formula: str) -> None:
    structure = solve_structure(scheme(links, *joints))
    assert structure.formula == formula
    assert structure.mobility == 1
    assert structure.class_number == 2


def test_a_triad_with_a_basic_link() -> None:
    """Basic link 2 of three inner joints, arms 3, 4, 5 to the crank and twice to the frame: class III, order 3."""
    structure = solve_structure(scheme(5, "01", "13", "23", "24", "25", "40", "50"))
    (group,) = structure.groups
    assert group.name == "III(2,3,4,5)"
    assert structure.formula == "I(0,1) -> III(2,3,4,5)"
    assert set(group.outer) == {"13", "40", "50"}
    assert set(group.inner) == {"23", "24", "25"}


def test_a_contour_of_four_joints() -> None:
    """Links 2, 3, 4, 5 close a contour; 2 hangs on the crank, 4 on the frame: class IV, order 2."""
    (group,) = solve_structure(scheme(5, "01", "12", "23", "34", "45", "52", "40")).groups
    assert (group.name, group.order, group.outer) == ("IV(2,3,4,5)", 2, ("12", "40"))


def test_a_contour_of_six_joints() -> None:
    """Contour 2-3-4-5-6-7; three of its links have an outer joint, three are binary: class VI needs order 3."""
    joints = ("01", "12", "23", "34", "45", "56", "67", "72", "40", "60")
    (group,) = solve_structure(scheme(7, *joints)).groups
    assert (group.class_number, group.order, group.name) == (6, 3, "VI(2,3,4,5,6,7)")


def test_the_class_may_depend_on_the_driver() -> None:
    """Stephenson's chain: class III from one side, dyads only from the other."""
    joints = ("01", "12", "23", "34", "25", "30", "54", "40")
    one = ("01", "13", "23", "24", "25", "40", "50")
    assert solve_structure(scheme(5, *one)).class_number == 3
    other = solve_structure(scheme(5, *one, driver="40"))
    assert other.class_number == 2
    assert len(other.groups) == 2
    with pytest.raises(StructureError, match="excess"):
        solve_structure(scheme(5, *joints))


def test_a_drive_between_two_moving_links_is_part_of_their_group() -> None:
    """A boom held by a rack: the triangle of boom, rack and its carrier is one group."""
    structure = solve_structure(scheme(3, "10", "20", "32P", "31", driver="32P"))
    assert structure.formula == "II D(1,2,3)"
    assert structure.driven is not None
    assert structure.driven.drive == "32P"
    assert structure.driven.outer == ("10", "20")


@pytest.mark.parametrize(
    ("links", "joints", "words"),
    [
        (3, (*FOUR_BAR, "20"), ["excess constraints", "links 1, 2, 3", "W = 3n - 2p = 3*3 - 2*5 = -1"]),
        (3, ("01", "12", "23"), ["missing constraints", "W = 3n - 2p = 3*3 - 2*3 = 3"]),
        (4, FOUR_BAR, ["link 4 floats: no joint names it"]),
        (4, (*FOUR_BAR, "34"), ["missing constraints", "link 4"]),
        (2, ("01", "12", "21"), ["links 2 and 1 are joined twice, by 12 and 21"]),
        (3, ("01", "12", "23", "30", "03P"), ["joined twice"]),
        (2, ("01", "12", "20"), ["excess constraints", "links 1, 2"]),
        (3, ("01", "12P", "23P", "30P"), ["prismatic joints alone close a loop"]),
        (5, ("01", "12", "23", "30", "24", "43", "45"), ["excess constraints", "link"]),
    ],
)
def test_what_is_not_a_mechanism_is_told_why(links: int, joints: tuple[str, ...], words: list[str]) -> None:
    with pytest.raises(StructureError) as refused:
        solve_structure(scheme(links, *joints))
    for word in words:
        assert word in str(refused.value)
    assert refused.value.exit_code == 3
    assert refused.value.remedy


def test_a_prismatic_loop_through_solved_links_is_seen() -> None:
    """A double slider on two fixed guides does not fix where it is: P-P-P with the frame."""
    with pytest.raises(StructureError, match="prismatic joints alone close a loop"):
        solve_structure(scheme(5, "01", "12", "23", "30", "04P", "45P", "50P"))


def test_a_mobility_of_one_that_hides_two_faults() -> None:
    """One part has a joint too many, another one too few: counting alone gives W = 1."""
    joints = ("01", "12", "23", "30", "24", "40", "05")
    mechanism = scheme(5, *joints)
    assert 3 * 5 - 2 * len(joints) == 1
    with pytest.raises(StructureError, match="excess constraints"):
        solve_structure(mechanism)


@given(CHAIN, st.integers(0, 2**32 - 1))
@STABLE
def test_chains_of_dyads_are_taken_apart_as_they_were_built(kinds: list[str], seed: int) -> None:
    scene = build(np.random.default_rng(seed), kinds)
    structure = solve_structure(scene.mechanism)
    assert structure.mobility == 1
    assert sorted(group.kind for group in structure.groups) == sorted(kinds)
    assert {frozenset(group.links) for group in structure.groups} == {frozenset(pair) for pair in scene.pairs}
    known = {0, structure.input_link}
    for group in structure.groups:
        assert set(group.source) == known
        outer = [scene.mechanism.joint(name) for name in group.outer]
        assert all(set(joint.links) <= known | set(group.links) for joint in outer)
        known |= set(group.links)


@given(scenes(), st.integers(0, 2**32 - 1))
@STABLE
def test_names_and_order_of_joints_do_not_matter(scene: RandomMechanism, seed: int) -> None:
    mechanism, rng = scene.mechanism, np.random.default_rng(seed)
    numbers = {
        link.id: int(k) + 1 for link, k in zip(mechanism.links, rng.permutation(len(mechanism.links)), strict=True)
    }
    other = renumbered(mechanism, numbers, rng=rng)
    for joint in mechanism.joints:
        other = swapped(other, joint.name) if joint.name != mechanism.input.joint else other
    one, two = solve_structure(mechanism), solve_structure(other)
    expected = {(group.kind, frozenset(numbers[k] for k in group.links)) for group in one.groups}
    assert {(group.kind, frozenset(group.links)) for group in two.groups} == expected


def test_the_order_of_assembly_is_the_dependence() -> None:
    """A chain of three four-bars listed backwards comes out in the order in which it can be put together."""
    joints = ("67", "70", "56", "45", "50", "34", "23", "30", "12", "01")
    groups = solve_structure(scheme(7, *joints)).groups
    assert [group.links for group in groups] == [(2, 3), (4, 5), (6, 7)]
    for before, after in pairwise(groups):
        assert set(before.links) <= set(after.source)
