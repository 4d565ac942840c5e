"""Names of shafts and motions that a spec leaves without one: what tables, messages and overrides call them."""

from __future__ import annotations

from collections.abc import Sequence


def shaft_names(names: Sequence[str | None]) -> list[str]:
    """Shafts by their number in the spec."""
    return [name or f"shaft {i}" for i, name in enumerate(names, 1)]


def transient_names(names: Sequence[str | None]) -> list[str]:
    """The first is "transient" unless another is called so, the others have their number."""
    free = "transient" not in names
    return [name or ("transient" if i == 1 and free else f"transient {i}") for i, name in enumerate(names, 1)]
