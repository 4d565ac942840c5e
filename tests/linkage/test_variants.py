"""Which assembly variant is taken: signs, sketches, and what neither tells."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from transforms import moved, renumbered

from linkage.scenes import crank_slider, four_bar, full_turn, shaper, slotted, with_input, yoke
from tmmcalc import AssemblyError, Kinematics, NoSolutionError, UsageError, solve_kinematics
from tmmcalc.linkage.model import Assembly, Input, Mechanism


def with_sketch(mechanism: Mechanism, at: float | None = None, **points: complex) -> Mechanism:
    return replace(mechanism, assembly=Assembly(sketch={name: complex(p) for name, p in points.items()}, at=at))


def place(result: Kinematics, name: str) -> complex:
    return complex(result.trace.r[result.trace.point_names.index(name), 0])


def test_signs_as_they_are_defined() -> None:
    """+1 is: RRR, B left of the line from A to C; RRP, B ahead of A along the guide; RPR, A ahead of the pivot."""
    for sign in (1, -1):
        result = solve_kinematics(full_turn(four_bar(1, 6, 3, 7, variant=sign), 0.3))
        a, b = place(result, "A"), place(result, "B")
        assert ((7 - a).conjugate() * (b - a)).imag * sign > 0
        result = solve_kinematics(full_turn(crank_slider(0.1, 0.3, variant=sign), 0.3))
        assert (place(result, "B") - place(result, "A")).real * sign > 0
        result = solve_kinematics(full_turn(slotted(0.1, 0.3, 0.05, variant=sign), 0.3))
        assert result.trace.s[0, 0] * sign > 0


def test_the_order_of_the_links_turns_the_sign_of_rrr() -> None:
    mechanism = full_turn(four_bar(1, 6, 3, 7), 0.3)
    one = solve_kinematics(replace(mechanism, assembly=Assembly(variants={(2, 3): 1})))
    two = solve_kinematics(replace(mechanism, assembly=Assembly(variants={(3, 2): -1})))
    assert place(one, "B") == place(two, "B")
    other = solve_kinematics(renumbered(mechanism, {2: 3, 3: 2}))
    assert place(other, "B") == pytest.approx(place(one, "B"), abs=1e-14)


def test_a_sign_that_names_no_dyad_or_no_variant() -> None:
    with pytest.raises(UsageError, match="links 1 and 2 are not a group"):
        solve_kinematics(replace(full_turn(four_bar(1, 6, 3, 7)), assembly=Assembly(variants={(1, 2): 1})))
    with pytest.raises(UsageError, match="has one assembly only"):
        solve_kinematics(replace(full_turn(yoke(0.1)), assembly=Assembly(variants={(2, 3): -1})))


@pytest.mark.parametrize("sign", [1, -1])
def test_a_sketch_at_position_0_or_elsewhere(sign: int) -> None:
    mechanism = full_turn(four_bar(1, 6, 3, 7), 0.3)
    assert set(solve_kinematics(with_sketch(mechanism, B=6 + 3j * sign)).variants.values()) == {sign}
    assert set(solve_kinematics(with_sketch(mechanism, at=3.0, B=5 + 3j * sign)).variants.values()) == {sign}


def test_a_pin_that_the_links_before_place_says_nothing_of_a_variant() -> None:
    """C is a point of the slotted link; the rod's variant stays +1, right, whatever is drawn of C."""
    result = solve_kinematics(with_sketch(shaper(), C=0.33 + 0.965j))
    assert result.variants == {"RPR(2,3)": 1, "RRP(4,5)": 1}
    assert solve_kinematics(with_sketch(shaper(), A=0.19 + 0.555j)).variants == result.variants
    left = solve_kinematics(with_sketch(shaper(), D=0.05 + 1j))
    assert left.variants["RRP(4,5)"] == -1


def test_a_slot_without_offset_takes_the_plus_where_the_sketch_shows_both() -> None:
    result = solve_kinematics(with_sketch(with_input(slotted(0.1, 0.25), start=0.2), A=0.25 + 0.1j))
    assert result.variants == {"RPR(2,3)": 1}


def test_a_sketch_on_the_line_of_symmetry_does_not_tell() -> None:
    with pytest.raises(NoSolutionError, match="equally near to both variants"):
        solve_kinematics(with_sketch(full_turn(four_bar(1, 6, 3, 7)), B=4.0))


def test_a_sketch_with_an_extreme_start_is_read_at_the_extreme_of_each_variant() -> None:
    for sign in (1, -1):
        base = moved(with_input(four_bar(1, 6, 3, 7, variant=sign), start=None), 0.4, 0j)
        drawn = solve_kinematics(base)
        sketch = {"B": place(drawn, "B") + 0.1 - 0.05j}
        again = solve_kinematics(with_sketch(base, **sketch))
        assert again.variants == drawn.variants
        assert again.x[0] == pytest.approx(drawn.x[0], abs=1e-13)


def test_where_no_variant_has_an_extreme_the_reason_is_told() -> None:
    """Not that the sketch fits nothing, but why there is no extreme to read it at."""
    with pytest.raises(NoSolutionError, match="never reverses"):
        solve_kinematics(with_sketch(with_input(slotted(0.1, 0.25, 0.02), start=None), K=0.5))
    with pytest.raises(AssemblyError, match="cannot make a full turn"):
        solve_kinematics(with_sketch(with_input(four_bar(3, 2, 2.5, 4), start=None), B=3 + 1j))


def test_no_variant_reaches_the_sketch() -> None:
    mechanism = with_sketch(with_input(crank_slider(0.1, 0.15, 0.08), start=-math.pi / 2), B=0.1)
    with pytest.raises(NoSolutionError, match="no assembly variant of RRP"):
        solve_kinematics(mechanism)


@pytest.mark.parametrize(
    ("assembly", "severity", "text"),
    [
        (Assembly(sketch={"B": 300 + 50j}), "warning", "are its units right?"),
        (Assembly(sketch={"A": 0.1 + 0j}), "note", "decides nothing"),
        (Assembly(sketch={"B": 0.35 - 0.2j}, variants={(2, 3): 1}), "warning", "nearer to the variant -1 of RRR(2,3)"),
        (Assembly(sketch={"B": 0.35 + 0.2j}), "", ""),
    ],
    ids=["units", "useless", "against the sign", "good"],
)
def test_odd_sketches_are_told(assembly: Assembly, severity: str, text: str) -> None:
    mechanism = replace(four_bar(0.1, 0.35, 0.25, 0.4 + 0j), assembly=assembly)
    told = [grade for grade in solve_kinematics(mechanism).grades if grade.where == "assembly.sketch"]
    assert [grade.severity for grade in told] == ([severity] if severity else [])
    assert all(text in grade.message for grade in told)


def test_a_sketch_read_where_nothing_assembles_is_told() -> None:
    mechanism = full_turn(four_bar(0.1, 0.35, 0.25, 0.4 + 0j), 0.3)
    long_crank = replace(four_bar(0.5, 0.35, 0.25, 0.4 + 0j), input=Input("O", 1.0, start=0.1))
    sketch = Assembly(sketch={"B": 0.35 + 0.2j}, variants={(2, 3): 1}, at=math.pi)
    ranged = replace(long_crank, grid=replace(long_crank.grid, span=0.05), assembly=sketch)
    told = [grade.message for grade in solve_kinematics(ranged).grades if grade.where == "assembly.sketch"]
    assert told == ["was not compared: the mechanism does not assemble where it was read"]
    assert solve_kinematics(mechanism).grades == ()
