"""The files that ``tmmcalc gears profile`` draws: flags, outlines, bytes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tmmcalc.cli.exporting import Files, check_files, contents_of
from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.report.drawing.order import within_turns

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from tmmcalc.gears.meshing.members import Toothed
    from tmmcalc.gears.meshing.outlines import Track
    from tmmcalc.gears.meshing.results import Pairs

FINENESS = 1e-4  # chord tolerance in modules


@record
class Drawn:
    """What is to be drawn into which files."""

    files: Files
    tolerance: float | None  # [m]; None: FINENESS
    whole: bool
    phase: float  # [rad]


def length_of(text: str, flag: str, example: str) -> float:
    """The length [m] of a flag; raises `UsageError` unless it is one above zero."""
    size = _quantity(text, "length", flag, example)
    if not size > 0:
        raise UsageError(f"{text!r} is not above zero", where=flag, remedy=f"write e.g. {flag} '{example}'")
    return size


def angle_of(text: str | None) -> float:
    """The angle [rad] of --phase; raises as `within_turns` does."""
    return 0.0 if text is None else within_turns(_quantity(text, "angle", "--phase", "5 deg"), "--phase")


def _quantity(text: str, dimension: Any, flag: str, example: str) -> float:
    from tmmcalc.spec.units import UnitError, parse

    try:
        return parse(text, dimension)
    except UnitError as error:
        raise UsageError(error.message, where=flag, remedy=f"write e.g. {flag} '{example}'") from None


def check_flags(drawn: Drawn, wheel: str | None, tolerance: str | None, phase: str | None) -> None:
    """Refuse flags without effect, and places where no file can be, before anything is computed."""
    idle = {"--tolerance": tolerance is not None, "--tooth": not drawn.whole, "--phase": phase is not None}
    check_files(drawn.files, idle, "--svg, --dxf or --outline")
    if wheel is not None and phase is not None:
        raise UsageError("one wheel is not in mesh", where="--phase", remedy="leave --wheel or --phase out")


def tracks_of(pairs: Pairs | None, chosen: Sequence[Toothed], drawn: Drawn) -> tuple[Track, ...]:
    """All pairs in mesh, or without pairs the chosen wheels; several ones stand beside each other.

    Wheels without a profile, of which the document tells, are left out; raises `NoSolutionError` if no other is there.
    """
    if not drawn.files:
        return ()
    from tmmcalc.gears.meshing.halftooth import fault_of
    from tmmcalc.gears.meshing.meshoutlines import beside, mesh_tracks, require_some
    from tmmcalc.gears.meshing.outlines import track

    if pairs is None:
        sound = [one for one in chosen if fault_of(one) is None] or chosen
        return beside([[track(one, drawn.tolerance or FINENESS * one.module, whole=drawn.whole)] for one in sound])
    require_some(pairs.pairs)
    return beside(
        [
            mesh_tracks(found, drawn.tolerance or FINENESS * found.task.module, drawn.phase, drawn.whole)
            for found in pairs.pairs
        ]
    )


def drawn_bytes(tracks: Sequence[Track], drawn: Drawn, heading: str) -> dict[Path, bytes]:
    """The bytes of all files."""
    if not drawn.files:
        return {}
    from tmmcalc.gears.files import outline_csv, outlines

    finest = drawn.tolerance or FINENESS * min(track.member.module for track in tracks)
    return contents_of(drawn.files, heading, finest, lambda: outlines(tracks), lambda: outline_csv(tracks))
