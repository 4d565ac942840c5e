"""Ranges of numeric keys: what they mean, what is refused."""

from __future__ import annotations

import pytest

from tmmcalc import UsageError
from tmmcalc.spec.variants import axis, count, grid, is_range

DATA = {"crank": {"speed": "55 rpm", "links": [{"id": 3, "mass": 20}]}, "n": 4}


@pytest.mark.parametrize(
    ("text", "name", "values"),
    [
        ("n=1:2:5", "n", (1.0, 1.25, 1.5, 1.75, 2.0)),
        ("n=2:1:3", "n", (2.0, 1.5, 1.0)),
        ("n=0.1:0.7:7", "n", (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7)),
        ("n=3,1,2e-3", "n", (3.0, 1.0, 0.002)),
        ("crank.speed=*0.9:1.1:3", "crank.speed[rpm]", (49.5, 55.0, 60.5)),
        ("crank.links[id=3].mass=*1,2", "crank.links[id=3].mass", (20.0, 40.0)),
        ("crank.speed=50 rpm:70 rpm:3", "crank.speed[rpm]", (50.0, 60.0, 70.0)),
        ('crank.speed="50 rpm":"70 rpm":3', "crank.speed[rpm]", (50.0, 60.0, 70.0)),
    ],
)
def test_a_range(text: str, name: str, values: tuple[float, ...]) -> None:
    found = axis(text, DATA)
    assert is_range(text)
    assert (found.name, found.values) == (name, pytest.approx(values, rel=1e-15))


def test_the_ends_are_exact_and_every_value_is_an_override() -> None:
    found = axis("crank.speed=0.1 rpm:0.7 rpm:7", DATA)
    assert [found.assignment(value) for value in found.values[:3]] == [
        'crank.speed="0.1 rpm"',
        'crank.speed="0.2 rpm"',
        'crank.speed="0.3 rpm"',
    ]
    assert axis("n=1:4:4", DATA).assignment(3.0) == "n=3", "a key that takes whole numbers takes this"


@pytest.mark.parametrize("text", ["n=4", 'n="a:b:c"', "n=[1, 2]", "n={ a = 1 }", "n=true", 'n="12 mm"'])
def test_a_plain_override_is_no_range(text: str) -> None:
    assert not is_range(text)
    with pytest.raises(UsageError, match="is no range"):
        axis(text, DATA)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("n=1:2:1", "whole number from 2"),
        ("n=1:2:2.5", "whole number from 2"),
        ("n=1:2:9999999", "whole number from 2"),
        ("n=1 mm:2 kg:3", "different units: 'mm' and 'kg'"),
        ("n=1 mm,2", "different units"),
        ("no.such=*1:2:3", "has no no"),
        ("crank=*1:2:3", "no number that could be multiplied"),
        ("=1:2:3", "path cannot be read"),
        ("n=-1e400:1:3", "a number too large"),
        ("n=1e308,-1e999", "a number too large"),
    ],
)
def test_what_is_refused(text: str, message: str) -> None:
    with pytest.raises(UsageError, match=message):
        axis(text, DATA)


def test_the_last_axis_runs_fastest() -> None:
    axes = [axis("n=1,2", DATA), axis("crank.speed=5,6,7", DATA)]
    assert list(grid(axes)) == [(1, 5), (1, 6), (1, 7), (2, 5), (2, 6), (2, 7)]
    assert count(axes) == 6
