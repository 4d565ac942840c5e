"""Other rows than those of ``[cam]`` and ``[indexing]``: many equal steps, for what moves smoothly."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tmmcalc.cams.program import TURN

if TYPE_CHECKING:
    from tmmcalc.cams.room import CamTables


def with_positions(spec: CamTables, count: int) -> CamTables:
    """The spec with so many equal steps of the turn of its cam."""
    assert spec.cam is not None
    cam = spec.cam.model_copy(update={"steps": None, "step": TURN / count})
    whole: Any = spec  # the root of the spec, which is put together of the rooms
    dense: CamTables = whole.model_copy(update={"cam": cam})
    return dense


def with_parts(spec: CamTables, count: int) -> CamTables:
    """The spec with so many equal parts of the step of its indexing drive."""
    assert spec.indexing is not None
    whole: Any = spec
    dense: CamTables = whole.model_copy(update={"indexing": spec.indexing.model_copy(update={"steps": count})})
    return dense
