"""A design that was found, as what stands in the place of the spec's own numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.design.optimize.scene import Optimum
from tmmcalc.spec.override import apply
from tmmcalc.spec.rewrite import Change, Found, value_at

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def found_of(result: Optimum, spec: Spec, choose: int | None = None) -> Found:
    """The changes of a spec that make design ``choose`` of it, from 1."""
    written = spec._written
    assert written is not None
    number = choose or 1
    document, paths = apply(written.document, result.designs[number - 1].assignments)
    of = f"design {number} of {len(result.designs)}" if len(result.designs) > 1 else ""
    return Found(tuple(Change(path, value_at(document, path)) for path in paths), of=of)
