"""Where functions on a grid pass zero: the crossed edges of the grid, and how they follow each other along a curve."""

from __future__ import annotations

from collections import defaultdict
from typing import NamedTuple

import numpy as np

from tmmcalc.cams.laws.law import Indices, Values


class Crossed(NamedTuple):
    """Edges of a grid that a zero line crosses, and its lines through them."""

    inside: Indices  # (n, 2) the node of each edge where the function is at least 0
    outside: Indices  # (n, 2) the other
    lines: list[list[int]]  # numbers of edges in their order; a closed line repeats its first


def crossed(values: Values) -> Crossed:
    """The zero lines of a function (nx, ny); in a cell with two of them the middle decides by the mean."""
    good = values >= 0
    numbers: dict[tuple[int, int, int], int] = {}
    inside: list[tuple[int, int]] = []
    outside: list[tuple[int, int]] = []

    def edge(i: int, j: int, along: int) -> int:
        key = (i, j, along)
        if key not in numbers:
            numbers[key] = len(numbers)
            one, other = (i, j), (i + 1 - along, j + along)
            inside.append(one if good[one] else other)
            outside.append(other if good[one] else one)
        return numbers[key]

    mixed = good[:-1, :-1].astype(int) + good[1:, :-1] + good[:-1, 1:] + good[1:, 1:]
    links: dict[int, list[int]] = defaultdict(list)
    for i, j in np.argwhere((mixed > 0) & (mixed < 4)).tolist():
        around = [(i, j, 0), (i + 1, j, 1), (i, j + 1, 0), (i, j, 1)]
        corners = [good[i, j], good[i + 1, j], good[i + 1, j + 1], good[i, j + 1]]
        cut = [edge(*around[k]) for k in range(4) if corners[k] != corners[(k + 1) % 4]]
        if len(cut) == 4 and (values[i : i + 2, j : j + 2].mean() >= 0) == bool(corners[0]):
            cut = [cut[0], cut[1], cut[2], cut[3]]
        elif len(cut) == 4:
            cut = [cut[3], cut[0], cut[1], cut[2]]
        for a, b in zip(cut[::2], cut[1::2], strict=True):
            links[a].append(b)
            links[b].append(a)
    shape = (-1, 2)
    return Crossed(np.array(inside, int).reshape(shape), np.array(outside, int).reshape(shape), _lines(links))


def _lines(links: dict[int, list[int]]) -> list[list[int]]:
    """Chains of linked edges; those with ends first, then the closed ones."""
    left = {a: list(b) for a, b in links.items()}
    found = []
    for start in [a for a, b in links.items() if len(b) == 1] + list(links):
        if not left[start]:
            continue
        line = [start]
        while left[line[-1]]:
            after = left[line[-1]].pop()
            left[after].remove(line[-1])
            line.append(after)
        found.append(line)
    return found
