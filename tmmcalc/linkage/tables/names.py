"""Names of loads, springs and paths that a spec leaves without one: what tables, messages and overrides call them."""

from __future__ import annotations

from collections.abc import Sequence


def load_names(names: Sequence[str | None], links: Sequence[object]) -> list[str]:
    """Q and the link, with a prime for each name that is taken.

    >>> load_names([None, "Q5", None], [5, 3, 5])
    ["Q5'", 'Q5', "Q5''"]
    """
    return _distinct(names, [f"Q{link}" for link in links])


def path_names(names: Sequence[str | None], points: Sequence[object]) -> list[str]:
    """Paths by their points, with a prime for each name that is taken.

    >>> path_names([None, "line", None], ["P", "P", "P"])
    ['P', 'line', "P'"]
    """
    return _distinct(names, [str(point) for point in points])


def _distinct(names: Sequence[str | None], otherwise: Sequence[str]) -> list[str]:
    found: list[str] = []
    own = set(names)
    for given, usual in zip(names, otherwise, strict=True):
        name = given or usual
        while given is None and (name in own or name in found):
            name += "'"
        found.append(name)
    return found


def spring_names(names: Sequence[str | None]) -> list[str]:
    """Springs by their number in the spec."""
    return [name or f"spring {i}" for i, name in enumerate(names, 1)]
