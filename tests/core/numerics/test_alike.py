"""Constants of several variants: they answer what all answer alike, and trees of them are taken at any rows."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import pytest

from tmmcalc.core.numerics.alike import (
    Alike,
    MixedError,
    Rows,
    SeveralError,
    alike,
    groups,
    numbers,
    paths,
    rebuilt,
    shape_of,
)
from tmmcalc.linkage.model import Input, Link


class Pair(NamedTuple):
    first: float
    links: tuple[Link, ...]


TREE = Pair(2.0, (Link(1, {"A": 1 + 2j, "B": 0j}, "crank"), Link(2, {"C": 3j})))


def test_questions_that_all_answer_alike() -> None:
    several = alike([1.0, 2.0, 3.0])
    assert isinstance(several, Alike)
    assert several > 0
    assert several != 0
    assert (several * 2 > 1) if several else False
    with pytest.raises(MixedError):
        assert several > 2
    with pytest.raises(MixedError):
        assert alike([0.0, 1.0]) or 5.0


@pytest.mark.parametrize(
    "asks",
    [float, int, complex, hash, round, math.sqrt, math.floor, range, "{:g}".format, lambda x: round(x, 2)],
)
def test_what_takes_one_number_is_not_given_several(asks: Callable[[Any], Any]) -> None:
    with pytest.raises(SeveralError):
        asks(alike([1.0, 2.0]))


def test_the_number_of_one_variant_is_plain() -> None:
    assert type(Rows(alike([1.0, 2.5]))(1)) is float
    assert type(Rows(alike([1.0, 2j]))(1)) is complex


def test_several_of_one_row_are_a_number() -> None:
    one = Rows(alike([1.0, 2.5]))(np.array([1]))
    assert (float(one), int(one), complex(one), math.sqrt(one), f"{one:.2f}") == (2.5, 2, 2.5 + 0j, 2.5**0.5, "2.50")
    assert (round(one), hash(one)) == (2, hash(2.5))


def test_one_number_stays_a_number() -> None:
    assert type(alike([2.5, 2.5])) is float
    assert type(alike([1j, 1j])) is complex


def test_numbers_of_a_tree_and_back() -> None:
    assert numbers(TREE) == [2.0, 1 + 2j, 0j, 3j]
    assert list(paths(TREE)) == ["0", "1.0.points.A", "1.0.points.B", "1.1.points.C"]
    assert rebuilt(TREE, numbers(TREE)) == TREE
    assert rebuilt(TREE, [5.0, 1j, 2j, 3j]).links[0].points == {"A": 1j, "B": 2j}
    of = groups(TREE)
    assert of[1] == of[2] != of[3]


def test_shapes_differ_by_all_but_numbers() -> None:
    assert shape_of(TREE) == shape_of(rebuilt(TREE, [0.0, 0j, 0j, 0j]))
    assert shape_of(Input("O", 1.0)) != shape_of(Input("O", 1.0, start=0.0))
    assert shape_of(Link(1, {"A": 0j})) != shape_of(Link(1, {"B": 0j}))


def test_rows_of_a_tree() -> None:
    several = rebuilt(TREE, [2.0, alike([1.0, 2.0, 3.0]), 0j, 3j])
    own = Rows(several)(np.array([2, 2, 0]))
    assert own.links[0].points["A"].tolist() == [3.0, 3.0, 1.0]
    assert own.links[1] is several.links[1]
    assert isinstance(own, Pair)
    assert Rows(several)(np.array([1])[:, None, None]).links[0].points["A"].shape == (1, 1, 1)
    assert Rows(TREE)(np.array([0, 0])) is TREE
