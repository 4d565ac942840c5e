"""What is drawn: by the published generator, each value as likely, exact, the same wherever it is drawn."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from pathlib import Path

import pytest

from tmmcalc.batch.reading import frame_of
from tmmcalc.classroom.draws import Drawn, Stream, assignments, candidate, drawn_of, number_of_all, spans
from tmmcalc.core.errors import SpecError
from tmmcalc.project import load_spec

CONFIGS = Path(__file__).parents[2] / "configs"
SHAPER = CONFIGS / "assignment-shaper.toml"


def drawn(file: Path) -> tuple[Drawn, ...]:
    """What an assignment draws."""
    spec = load_spec(file)
    assert spec.class_ is not None
    keys = [key for table in spec.class_.drawn for key in table.of]
    return drawn_of(spec, frame_of(file, (), keys, []).axes)


def test_words_are_those_of_splitmix64() -> None:
    """Steele, Lea, Flood, 2014: the first words of Vigna's splitmix64.c for these two seeds."""
    stream = Stream(1234567)
    assert [stream.word() for _ in range(5)] == [
        6457827717110365317,
        3203168211198807973,
        9817491932198370423,
        4593380528125082431,
        16408922859458223821,
    ]
    assert Stream(0).word() == 0xE220A8397B1DCDAF


@pytest.mark.parametrize("count", [1, 2, 7, 24, 1000])
def test_numbers_below_are_as_likely(count: int) -> None:
    """Pearson's statistic of 40 a cell is within six standard deviations of its mean."""
    each = 40
    stream = Stream.of(7, count)
    found = Counter(stream.below(count) for _ in range(each * count))
    assert {*found} <= {*range(count)}
    statistic = sum((found[k] - each) ** 2 / each for k in range(count))
    assert abs(statistic - (count - 1)) <= 6 * (2 * count) ** 0.5


def test_words_that_would_favour_some_are_passed_over() -> None:
    """Of 2^64 words 2^64 mod (2^63 + 1) = 2^63 - 1 are too many: about half of all are drawn again."""
    count = 2**63 + 1
    passed = 0
    for seed in range(200):
        stream, other = Stream.of(seed, 0), Stream.of(seed, 0)
        value = stream.below(count)
        while (word := other.word()) != value:
            assert word >= count
            passed += 1
    assert 120 <= passed <= 290


def test_neighbours_have_nothing_in_common() -> None:
    """Bits of the first words of neighbouring candidates, and of neighbouring seeds, differ as often as not."""
    for pairs in (
        [(Stream.of(7, n).word(), Stream.of(7, n + 1).word()) for n in range(400)],
        [(Stream.of(n, 3).word(), Stream.of(n + 1, 3).word()) for n in range(400)],
    ):
        share = sum((one ^ other).bit_count() for one, other in pairs) / (64 * len(pairs))
        assert abs(share - 0.5) < 0.02


def test_candidates_are_frozen() -> None:
    """A seed that has been given out must not mean other numbers in a later version."""
    every = drawn(SHAPER)
    told = [[str(value) for value in candidate(every, 7, number).values] for number in (0, 1, 1000)]
    assert told == [
        ["170", "460", "1040", "65", "220", "5500"],
        ["200", "700", "1000", "55", "200", "9000"],
        ["160", "520", "980", "45", "210", "6500"],
    ]
    assert assignments(every, candidate(every, 7, 0).values) == (
        'mechanism.links[id=1].points.A[0]="170 mm"',
        'mechanism.fixed.O[1]="460 mm"',
        'mechanism.links[id=3].points.C[0]="1040 mm"',
        'mechanism.input.speed="65 rpm"',
        "mechanism.links[id=5].mass=220",
        'loads[name=Q5].force="5500 N"',
    )


def test_values_are_multiples_within_their_limits_and_relations_exact() -> None:
    every = drawn(SHAPER)
    seen = [set[Fraction]() for _ in every]
    for number in range(3000):
        values = candidate(every, 3, number).values
        crank, distance = values[:2]
        assert Fraction(5, 2) * crank <= distance <= Fraction(7, 2) * crank
        assert distance % 20 == 0
        assert crank % 10 == 0
        for own, value in zip(seen, values, strict=True):
            own.add(value)
    assert seen[0] == {*map(Fraction, range(160, 241, 10))}
    assert seen[1] == {*map(Fraction, range(400, 841, 20))}
    assert seen[3] == {*map(Fraction, range(40, 66, 5))}
    assert [each.count for each in every] == [9, None, 6, 6, 7, 9]
    assert number_of_all(every) is None
    assert spans(every)[1] == (400, 840)


MECHANISM = """
[mechanism.grid]
positions = 12
[mechanism.input]
joint = "O"
speed = 6
[mechanism.fixed]
O = [0, 0]
C = [0.4, 0]
[[mechanism.links]]
id = 1
points = { O = [0, 0], A = ["100 mm", 0] }
[[mechanism.links]]
id = 2
points = { A = [0, 0], B = [0.35, 0] }
[[mechanism.links]]
id = 3
points = { C = [0, 0], B = ["30 cm", 0] }
[[mechanism.joints]]
name = "O"
kind = "revolute"
links = [0, 1]
[[mechanism.joints]]
name = "A"
kind = "revolute"
links = [1, 2]
[[mechanism.joints]]
name = "B"
kind = "revolute"
links = [2, 3]
[[mechanism.joints]]
name = "C"
kind = "revolute"
links = [3, 0]
[mechanism.assembly]
variants = { "2-3" = 1 }
[[class.asked]]
result = "kinematics.omega_3@1"
"""


def of(tmp_path: Path, text: str) -> tuple[Drawn, ...]:
    file = tmp_path / "own.toml"
    file.write_text(f"{MECHANISM}\n{text}", encoding="utf-8")
    return drawn(file)


def test_units_are_converted_exactly(tmp_path: Path) -> None:
    """Limits in other units, keys in three ways of writing, a relation between two units."""
    every = of(
        tmp_path,
        """
[[class.drawn]]
of = "mechanism.links[id=1].points.A[0]"
at_least = "0.07 m"
at_most = "13 cm"
step = "7 mm"
[[class.drawn]]
of = "mechanism.links[id=2].points.B[0]"
times = "mechanism.links[id=1].points.A[0]"
at_least = 3.3
at_most = 3.4
step = "1 mm"
[[class.drawn]]
of = "mechanism.links[id=3].points.B[0]"
times = "mechanism.links[id=2].points.B[0]"
at_least = 1
at_most = 1.1
step = "1 cm"
[[class.drawn]]
of = "mechanism.input.speed"
among = ["60 rpm", "90 rpm"]
""",
    )
    assert [(each.unit, each.low, each.high, each.step) for each in every[:3]] == [
        ("mm", 70, 130, 7),
        ("m", Fraction(33, 10), Fraction(34, 10), Fraction(1, 1000)),
        ("cm", 1, Fraction(11, 10), 1),
    ]
    texts = set()
    for number in range(500):
        found = candidate(every, 1, number)
        if not found.missing:
            crank, rod, rocker, _ = found.values
            assert Fraction(33, 10) * crank <= 1000 * rod <= Fraction(34, 10) * crank
            assert 100 * rod <= rocker <= 110 * rod
            texts.add(assignments(every, found.values)[0].partition("=")[2].split("=")[-1])
    assert texts == {f'"{k} mm"' for k in range(70, 131, 7)}
    # 2 pi and 3 pi rad/s, to the last digit of a number of the machine
    assert [float(value) for value in every[3].among] == [6.283185307179586, 9.42477796076938]


def test_a_relation_may_leave_no_value(tmp_path: Path) -> None:
    every = of(
        tmp_path,
        """
[[class.drawn]]
of = "mechanism.links[id=1].points.A[0]"
among = ["100 mm", "104 mm"]
[[class.drawn]]
of = "mechanism.links[id=2].points.B[0]"
times = "mechanism.links[id=1].points.A[0]"
at_least = 3
at_most = 3.01
step = "100 mm"
""",
    )
    found = {candidate(every, 1, number).values: candidate(every, 1, number).missing for number in range(50)}
    assert found == {(100, Fraction(3, 10)): "", (104,): "mechanism.links[id=2].points.B[0]"}


def test_a_factor_of_a_given_number(tmp_path: Path) -> None:
    own = of(
        tmp_path,
        """
[[class.drawn]]
of = "mechanism.links[id=2].points.B[0]"
times = "mechanism.fixed.C[0]"
at_least = 0.9
at_most = 1.1
step = "10 mm"
""",
    )[0]
    assert own.limits(()) == (Fraction(36, 100), Fraction(44, 100))
    assert own.count == 9


def test_factors_of_a_given_number_have_to_leave_a_multiple(tmp_path: Path) -> None:
    text = """[[class.drawn]]
of = "mechanism.links[id=2].points.B[0]"
times = "mechanism.fixed.C[0]"
at_least = 1
at_most = 1.001
step = "7 mm"
"""
    with pytest.raises(SpecError, match="has no value between its limits"):
        of(tmp_path, text)
