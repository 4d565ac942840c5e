"""The hash: equal for equal inputs, different for anything that could change a result."""

from __future__ import annotations

import math
import os
import subprocess
import sys
from dataclasses import dataclass, replace
from enum import Enum

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmmcalc.linkage.model import Assembly, Input, Joint, Link, Mechanism
from tmmcalc.pipeline.hashing import content_hash, stage_hash

from . import toy


class Colour(Enum):
    RED = 1
    BLUE = 2


@dataclass(frozen=True)
class A:
    x: float


@dataclass(frozen=True)
class B:
    x: float


DIFFERENT = [
    None, True, False, 1, 0, 1.0, 0.0, -0.0, math.nan, math.inf, "", "1", "1.0", b"1", 1 + 0j, 0j, -0j,
    complex(0.0, -0.0), (), (1,), ((1,),), (1, 2), (12,), ("a", "b"), ("ab",), ("a", ("b",)), {}, {"a": 1},
    {"a": 1, "b": 2}, {"a": {"b": 2}}, {(1, 2): 1}, frozenset(), frozenset({1}), A(1.0), A(-1.0), B(1.0),
    Colour.RED, Colour.BLUE, math.nextafter(1.0, 2.0),
    np.array([1.0, 2.0]), np.array([[1.0, 2.0]]), np.array([1, 2]), np.array([1.0, 2.0], dtype=np.float32),
    np.array(1.0), np.array([0.0]), np.array([-0.0]),
]  # fmt: skip


def test_different_values_have_different_hashes():
    assert len({content_hash(value) for value in DIFFERENT}) == len(DIFFERENT)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ((1, 2), [1, 2]),
        (1.5, np.float64(1.5)),
        (3, np.int64(3)),
        (True, np.bool_(True)),
        (frozenset({"b", "a"}), {"a", "b"}),
        (np.arange(6.0).reshape(2, 3), np.asfortranarray(np.arange(6.0).reshape(2, 3))),
        (np.arange(3.0), np.arange(6.0)[::2] / 2),
    ],
)
def test_equal_values_have_equal_hashes(one, other):
    assert content_hash(one) == content_hash(other)


def test_order_of_a_dict_counts_but_order_of_settings_does_not():
    assert content_hash({"a": 1, "b": 2}) != content_hash({"b": 2, "a": 1})
    stage = toy.TOY["path"]
    one = stage_hash(stage, 1, {"a": 1, "b": 2}, {})
    assert one == stage_hash(stage, 1, {"b": 2, "a": 1}, {})


@given(st.floats(), st.floats())
def test_floats_hash_equal_only_if_they_are_the_same_number(x: float, y: float):
    same = repr(x) == repr(y)
    assert (content_hash((x,)) == content_hash((y,))) == same


def test_everything_that_a_result_depends_on_counts():
    stage = toy.TOY["path"]
    base = (stage, (25, False), {"method": "closed"}, {"geometry": "ab"}, "0.1.0")
    changed = [
        (replace(stage, name="other"), *base[1:]),
        (stage, (26, False), *base[2:]),
        (*base[:2], {"method": "newton"}, *base[3:]),
        (*base[:3], {"geometry": "ac"}, base[4]),
        (*base[:4], "0.1.1"),
    ]
    hashes = {stage_hash(*arguments) for arguments in (base, *changed)}
    assert len(hashes) == 1 + len(changed)


def test_a_mechanism_can_be_hashed_and_its_numbers_count():
    links = (Link(1, {"O": 0j, "A": 0.2 + 0j}),)
    joints = (Joint("O", "revolute", (0, 1), (0j, 0j)),)
    one = Mechanism(Link(0, {"O": 0.62j}), links, joints, Input("O", 5.76), assembly=Assembly({}, {(2, 3): 1}))
    other = replace(one, input=Input("O", 5.77))
    flipped = replace(one, assembly=Assembly({}, {(2, 3): -1}))
    assert len({content_hash(m) for m in (one, other, flipped)}) == 3


@pytest.mark.parametrize("value", [object(), len, A, ..., np.array([object()]), {"a": [object()]}, np.longdouble(1)])
def test_what_is_not_plain_is_refused(value):
    with pytest.raises(TypeError, match="not a plain value"):
        content_hash(value)


def test_hash_does_not_depend_on_the_process():
    code = "from tmmcalc.pipeline.hashing import content_hash as h; print(h(({'b', 'a', 'c'}, 'x', -0.0, 1j)))"
    seen = {
        subprocess.check_output([sys.executable, "-c", code], env={**os.environ, "PYTHONHASHSEED": seed})
        for seed in ("1", "2")
    }
    assert seen == {f"{content_hash(({'b', 'a', 'c'}, 'x', -0.0, 1j))}\n".encode()}
