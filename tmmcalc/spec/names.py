"""Names of elements that a spec leaves without one: what tables, messages and overrides call them."""

from __future__ import annotations

from collections.abc import Callable, Sequence

Names = Sequence[str | None]  # as the spec gives them


def load_names(names: Names, links: Sequence[object]) -> list[str]:
    """Q and the link, with a prime for each name that is taken.

    >>> load_names([None, "Q5", None], [5, 3, 5])
    ["Q5'", 'Q5', "Q5''"]
    """
    found: list[str] = []
    own = set(names)
    for given, link in zip(names, links, strict=True):
        name = given or f"Q{link}"
        while given is None and (name in own or name in found):
            name += "'"
        found.append(name)
    return found


def spring_names(names: Names) -> list[str]:
    """Springs by their number in the spec."""
    return [name or f"spring {i}" for i, name in enumerate(names, 1)]


def shaft_names(names: Names) -> list[str]:
    """Shafts by their number in the spec."""
    return [name or f"shaft {i}" for i, name in enumerate(names, 1)]


def transient_names(names: Names) -> list[str]:
    """The first is "transient" unless another is called so, the others have their number."""
    free = "transient" not in names
    return [name or ("transient" if i == 1 and free else f"transient {i}") for i, name in enumerate(names, 1)]


def pair_names(names: Names) -> list[str]:
    """Pairs by their number in the spec; a single one needs no name."""
    return [name or f"pair {i}" for i, name in enumerate(names, 1)] if len(names) > 1 else [names[0] or ""]


NUMBERED: dict[str, Callable[[Names], list[str]]] = {
    "springs": spring_names,
    "shafts": shaft_names,
    "transients": transient_names,
}
