from __future__ import annotations

import tomllib
from collections.abc import Iterator
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from properties import examples

from tmmcalc.spec.source import Source

TEXT = '''\
# comment with [brackets] and "quotes"
title = "x" # tail = 1
a.b . "c.d" = 1
"q\\u0041" = { in = 1, deep = { er = [1, 2] } }

[ t . 'u v' ]
long = """
[not.a.table]
key = 3
"""
raw = \'\'\'
[[no]]\'\'\'\'
list = [ # comment ]
  1,
  [2,
   "]"],
  { k = "}" },
]
after = 1979-05-27 07:32:00 # date

[[rows]]
x = 1
[rows.sub]
y = 2
[[rows]]
x = 3
  [[rows.inner]]
  z = """a"""""
  [[rows.inner]]
  z = 4
[late.early]
[late]
v = 1
'''


@pytest.mark.parametrize(
    ("path", "line"),
    [
        (("title",), 2),
        (("a", "b", "c.d"), 3),
        (("a",), 3),
        (("qA", "deep", "er", 1), 4),
        (("t", "u v"), 6),
        (("t", "u v", "long"), 7),
        (("t", "u v", "raw"), 11),
        (("t", "u v", "list"), 13),
        (("t", "u v", "list", 0), 14),
        (("t", "u v", "list", 1, 1), 16),
        (("t", "u v", "list", 2, "k"), 17),
        (("t", "u v", "after"), 19),
        (("rows",), 21),
        (("rows", 0, "x"), 22),
        (("rows", 0, "sub", "y"), 24),
        (("rows", 1), 25),
        (("rows", 1, "inner", 0, "z"), 28),
        (("rows", 1, "inner", 1), 29),
        (("late",), 32),
        (("late", "early"), 31),
        (("late", "absent", 3), 32),
        (("absent",), None),
        ((), None),
    ],
)
@pytest.mark.parametrize("form", ["lf", "crlf", "bom"])
def test_line_of(path: tuple[str | int, ...], line: int | None, form: str) -> None:
    tomllib.loads(TEXT)
    text = {"lf": TEXT, "crlf": TEXT.replace("\n", "\r\n"), "bom": "\ufeff" + TEXT}[form]
    assert Source(text).line_of(path) == line


KEYS = st.sampled_from(["a", "b-1", "x y", "k'", "é", "a.b", "#", "=", "[0]", '"', "3"])
STRINGS = st.sampled_from(
    ['""', '"a]#"', "'}\"'", '"""\n[t]\n# x"""', "'''\n\\'''''", '"\\""', '"""\\""""', '"""a"""""']
)
SCALARS = st.one_of(STRINGS, st.sampled_from(["1", "-2.5e3", "true", "1979-05-27T07:32:00Z", "07:32:00", "inf"]))
GAPS = st.sampled_from(["", " ", "\n", " # ]},\n", "\n\n\t"])


def quoted(key: str) -> str:
    return key if key in ("a", "b-1", "3") else f"'{key}'" if "'" not in key else f'"{key}"'


@st.composite
def arrays(draw: st.DrawFn, values: st.SearchStrategy[str]) -> str:
    items = draw(st.lists(st.tuples(GAPS, values, GAPS), max_size=3))
    tail = draw(GAPS)
    return "[" + ",".join(a + value + b for a, value, b in items) + ("," + tail if items else tail) + "]"


@st.composite
def inline_tables(draw: st.DrawFn, values: st.SearchStrategy[str]) -> str:
    pairs = draw(st.lists(st.tuples(KEYS, values), max_size=3, unique_by=lambda pair: pair[0]))
    return "{ " + ", ".join(f"{quoted(key)} = {value}" for key, value in pairs) + " }"


VALUES = st.recursive(SCALARS, lambda inner: st.one_of(arrays(inner), inline_tables(inner)), max_leaves=6)


@st.composite
def documents(draw: st.DrawFn) -> str:
    lines = []
    for _ in range(draw(st.integers(0, 8))):
        keys = " . ".join(quoted(key) for key in draw(st.lists(KEYS, min_size=1, max_size=3)))
        header = draw(st.sampled_from(["[{}]", "[[{}]]", "[ {} ] # [x]", None, None, None]))
        lines.append(header.format(keys) if header else f"{keys} = {draw(VALUES)} # tail")
        lines.extend(draw(st.sampled_from([[], [""], ["# [c] = 1"]])))
    return draw(st.sampled_from(["\n", "\r\n"])).join(lines)


def leaves(value: Any, path: tuple[str | int, ...] = ()) -> Iterator[tuple[str | int, ...]]:
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, item in items:
        yield (*path, key)
        yield from leaves(item, (*path, key))


@pytest.mark.slow
@examples(400)
@given(documents())
def test_every_path_has_the_line_of_its_key(text: str) -> None:
    try:
        document = tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        return
    source = Source(text)
    lines = text.split("\n")
    paths = list(leaves(document))
    assert set(source.begins) == set(paths)
    for path in paths:
        line, column = source.place_of(path) or (0, 0)
        assert line == source.line_of(path)
        assert not lines[line - 1][column - 1].isspace()
        if isinstance(path[-1], str):
            assert quoted(path[-1]) in lines[line - 1][column - 1 :]
