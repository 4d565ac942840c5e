"""Keys of a TOML text take other values, and whatever is not changed stays, byte for byte."""

from __future__ import annotations

import math
import random
import tomllib
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from properties import examples
from sparing import sparing

from tmmcalc.core.errors import UsageError
from tmmcalc.spec.rewrite import Change, changed, rewritten, toml, without
from tmmcalc.spec.source import Source
from tmmcalc.spec.units import parse, written

CONFIGS = Path(__file__).parents[2] / "configs"

SPEC = """\
# head
[cam]                       # of the press
follower = "translating"    # a roller
  stroke = "3 cm"
base_radius = "40 mm"       # mine
phases = [ 1, # rise
  2 ]

# about the motor
[motor]
power = 1

[cam.limits]
radius = 0.003
# the end
"""


def test_new_values_and_keys_stand_in_their_tables() -> None:
    changes = [
        Change(("cam", "base_radius"), 0.0423, "m"),
        Change(("cam", "roller"), 0.008, "mm"),
        Change(("cam", "limits", "radius"), 0.0041, "mm"),
        Change(("cam", "guide", "top"), 0.1, "m"),
    ]
    expected = SPEC.replace('"40 mm"       # mine', '"42.3 mm"       # mine')
    # in the first unit that the table writes
    expected = expected.replace("  2 ]\n", '  2 ]\nroller = "0.8 cm"\n')
    # a bare number stays one
    expected = expected.replace("radius = 0.003\n", 'radius = 0.0041\n\n[cam.guide]\ntop = "10 cm"\n\n')
    assert rewritten(SPEC, changes) == expected
    assert tomllib.loads(expected) == changed(tomllib.loads(SPEC), changes)


def test_what_goes_stays_as_a_comment() -> None:
    made = rewritten(SPEC, [Change(("cam", "phases")), Change(("cam", "base_radius")), Change(("cam", "limits"))])
    expected = SPEC
    for line in ("base_radius", "phases", "  2 ]", "[cam.limits]", "radius = 0.003"):
        expected = expected.replace(f"\n{line}", f"\n# {line}")
    assert made == expected


def test_tables_take_the_place_of_one_that_goes() -> None:
    text = "[synthesis]\nspeed = 1 # c\n# inner\n[synthesis.k]\nb = 1\n\n# about it\n[motor]\np = 1\n"
    made = rewritten(text, [Change(("synthesis",))], "[mechanism]\na = 1\n")
    assert made == (
        "# [synthesis]\n# speed = 1 # c\n# inner\n# [synthesis.k]\n# b = 1\n\n[mechanism]\na = 1\n"
        "\n# about it\n[motor]\np = 1\n"
    )


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("[cam]\r\na = 1\r\n\r\n[x]\r\nb = 1", "[cam]\r\na = 1\r\nnew = 2\r\n\r\n[x]\r\nb = 1"),
        ("cam.a = 1\n[x]\nb = 1\n", "cam.a = 1\ncam.new = 2\n[x]\nb = 1\n"),
        ("cam = { a = 1 } # c\n", "cam = { a = 1, new = 2 } # c\n"),
        ("cam = {}\n", "cam = { new = 2 }\n"),
        ("[cam]", "[cam]\nnew = 2\n"),
        ("[cam] # empty\n\n# of x\n[x]\n", "[cam] # empty\nnew = 2\n\n# of x\n[x]\n"),
        ("[x]\nb = 1\n", "[x]\nb = 1\n\n[cam]\nnew = 2\n"),
        ("[cam.sub]\nb = 1\n# end\n", "[cam.sub]\nb = 1\n\n[cam]\nnew = 2\n\n# end\n"),
        ("[cam]\na = 1\n[x]\nb = 1\n[cam.sub]\nc = 1\n", "[cam]\na = 1\nnew = 2\n[x]\nb = 1\n[cam.sub]\nc = 1\n"),
        ("[cam]\n\ta = 1 # \u2028 a line to some\n", "[cam]\n\ta = 1 # \u2028 a line to some\n\tnew = 2\n"),
    ],
)
def test_however_a_spec_is_written(text: str, wanted: str) -> None:
    assert rewritten(text, [Change(("cam", "new"), 2)]) == wanted


@pytest.mark.parametrize(
    ("text", "path", "wanted"),
    [
        ("cam = { a = 1, b = 2, c = 3 }\n", ("cam", "b"), "cam = { a = 1, c = 3 }\n"),
        ("cam = { a = 1, b = 2 }\n", ("cam", "b"), "cam = { a = 1 }\n"),
        ("cam.a = 1\ncam.b = 2\n", ("cam", "b"), "cam.a = 1\n# cam.b = 2\n"),
        ("cam = 1 # c\n", ("cam",), "# cam = 1 # c\n"),
        ("[[c]]\na = 1\n[[c]]\na = 2\n", ("c", 0), "# [[c]]\n# a = 1\n[[c]]\na = 2\n"),
    ],
)
def test_however_what_goes_is_written(text: str, path: tuple[str | int, ...], wanted: str) -> None:
    assert rewritten(text, [Change(path)]) == wanted


def test_a_new_table_of_an_element_of_a_list() -> None:
    text = "[[c]]\na = 1\n[c.in]\nb = 1\n\n[[c]]\na = 2\n"
    made = rewritten(text, [Change(("c", 0, "sub", "x"), 5)])
    assert made == "[[c]]\na = 1\n[c.in]\nb = 1\n\n[c.sub]\nx = 5\n\n[[c]]\na = 2\n"


def test_several_elements_of_a_list_go() -> None:
    text = "[[c]]\na = 1\n[[c]]\na = 2\n[[c]]\na = 3\n"
    assert tomllib.loads(rewritten(text, [Change(("c", 0)), Change(("c", 2))])) == {"c": [{"a": 2}]}


def test_what_cannot_be_written_is_refused() -> None:
    with pytest.raises(UsageError, match="cannot take old, loads"):
        rewritten("loads = [ { a = 1 } ]\n", [Change(("old",))], "[[loads]]\na = 2\n")


@given(st.floats(1e-9, 1e9), st.sampled_from(["mm", "deg", "kg*m^2", "rpm", "MPa", "km/h"]))
@examples(200)
def test_a_quantity_is_written_with_all_its_digits(value: float, unit: str) -> None:
    from tmmcalc.spec.units import dimension_of

    dimension = dimension_of(f"1 {unit}") or ""
    text = written(value, unit)
    assert parse(text, dimension) == value
    shorter = f"{float(text.split()[0]):.14g} {unit}"
    assert len(text) <= max(len(shorter), 30)


def test_round_numbers_are_written_short() -> None:
    assert [written(x, "mm") for x in (0.0423, 0.0, -0.0132, 1e-12)] == ["42.3 mm", "0 mm", "-13.2 mm", "1E-9 mm"]
    assert written(math.pi / 2, "deg") == "90 deg"
    assert toml({"a b": [1.5, "x\n"]}) == '{ "a b" = [1.5, "x\\n"] }'


@pytest.mark.parametrize("end", ["\n", "\r\n"])
@sparing(
    "name", ["course-project", "shaper", "feasibility", "four-dyads", "gears-pairs", "manipulator"], every=3, first=1
)
def test_any_keys_of_ready_specs(name: str, end: str) -> None:
    """Random keys take other values, go or come; what is read of the text is the document with these changes."""
    text = (CONFIGS / f"{name}.toml").read_text().replace("\n", end)
    source, chance = Source(text), random.Random(name)
    keys = [path for path in source.values if not isinstance(path[-1], int)]
    for _ in range(20):
        one, two, three, four = chance.sample(keys, 4)
        home = chance.choice(source.headers).path
        values = (1.5, "x", [1, 2], {"a": 1}, True)
        changes = [Change(one, chance.choice(values)), Change(two, chance.choice(values)), Change(three), Change(four)]
        changes += [Change((*home, "new"), 3), Change((*home, "sub", "deep"), 3)]
        paths = [change.path for change in changes]
        if any(a is not b and a[: len(b)] == b for a in paths for b in paths):
            continue
        made = rewritten(text, changes)
        assert made.count("\n") == made.count(end)
        comments = [line for line in text.split(end) if line.startswith("#")]
        assert [line for line in made.split(end) if line in comments] == comments


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("# of all\na = 1\n\n# of the class\n[class]\nx = 1  # one\n\n[b]\ny = 2\n", "# of all\na = 1\n\n[b]\ny = 2\n"),
        ("[b]\ny = 2\n\n[class]\nx = 1\n# its own\n\n[[class.drawn]]\nof = 'a'\n", "[b]\ny = 2\n"),
        ("[[class.drawn]]\nz = [\n  1,\n]\n\n# of b\n[b]\ny = 2\n[class.more]\nw = 1\n", "# of b\n[b]\ny = 2\n"),
        ("class.x = 1\nb = 2\nclass.y = [\n 1,\n]\n", "b = 2\n"),
        ("b = 2\r\n[class]\r\nx = 1\r\n", "b = 2\r\n"),
        ("class = { x = 1 }\n[classes]\nx = 1\n", "[classes]\nx = 1\n"),
        ("b = 2\n", "b = 2\n"),
    ],
)
def test_a_table_goes_with_its_comments(text: str, left: str) -> None:
    assert without(text, "class") == left
