"""The files that ``tmmcalc gears profile`` draws: flags, outlines, bytes."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmmcalc.cli.messages import note_written
from tmmcalc.cli.work import check_place
from tmmcalc.errors import UsageError
from tmmcalc.records import record

if TYPE_CHECKING:
    from collections.abc import Sequence

    from tmmcalc.gears.meshing.members import Member
    from tmmcalc.gears.meshing.results import Pairs
    from tmmcalc.gears.meshing.tracks import Track

FINENESS = 1e-4  # chord tolerance in modules


@record
class Drawn:
    """What is to be drawn into which files."""

    svg: Path | None
    dxf: Path | None
    outline: Path | None
    tolerance: float | None  # [m]; None: FINENESS
    whole: bool
    phase: float  # [rad]

    @property
    def files(self) -> dict[str, Path]:
        """The files by their flags."""
        each = {"--svg": self.svg, "--dxf": self.dxf, "--outline": self.outline}
        return {flag: file for flag, file in each.items() if file is not None}


def length_of(text: str | None) -> float | None:
    """The length [m] of --tolerance; raises `UsageError` unless it is one above zero."""
    if text is None:
        return None
    size = _quantity(text, "length", "--tolerance", "0.5 um")
    if not size > 0:
        raise UsageError(f"{text!r} is not above zero", where="--tolerance", remedy="write e.g. --tolerance '1 um'")
    return size


def angle_of(text: str | None) -> float:
    """The angle [rad] of --phase."""
    return 0.0 if text is None else _quantity(text, "angle", "--phase", "5 deg")


def _quantity(text: str, dimension: Any, flag: str, example: str) -> float:
    from tmmcalc.spec.units import UnitError, parse

    try:
        return parse(text, dimension)
    except UnitError as error:
        raise UsageError(error.message, where=flag, remedy=f"write e.g. {flag} '{example}'") from None


def check_flags(drawn: Drawn, wheel: str | None, tolerance: str | None, phase: str | None) -> None:
    """Refuse flags without effect, and places where no file can be, before anything is computed."""
    for flag, file in drawn.files.items():
        check_place(file, flag)
    if len({file.resolve() for file in drawn.files.values()}) < len(drawn.files):
        raise UsageError("one file cannot have two formats", where=", ".join(drawn.files), remedy="name two files")
    idle = {"--tolerance": tolerance is not None, "--tooth": not drawn.whole, "--phase": phase is not None}
    if not drawn.files and any(idle.values()):
        flags = ", ".join(flag for flag, given in idle.items() if given)
        raise UsageError("there is no file to draw into", where=flags, remedy="add --svg, --dxf or --outline")
    if wheel is not None and phase is not None:
        raise UsageError("one wheel is not in mesh", where="--phase", remedy="leave --wheel or --phase out")
    if drawn.dxf is not None:
        from tmmcalc.report.gearfiles import require_dxf

        require_dxf()


def tracks_of(pairs: Pairs, chosen: Sequence[Member] | None, drawn: Drawn) -> tuple[Track, ...]:
    """The chosen wheels, or all pairs in mesh; several ones stand beside each other."""
    if not drawn.files:
        return ()
    from tmmcalc.gears.meshing.tracks import beside, mesh_tracks, track

    if chosen is not None:
        return beside([[track(one, drawn.tolerance or FINENESS * one.module, whole=drawn.whole)] for one in chosen])
    return beside(
        [
            mesh_tracks(found, drawn.tolerance or FINENESS * found.task.module, drawn.phase, drawn.whole)
            for found in pairs.pairs
        ]
    )


def contents_of(tracks: Sequence[Track], drawn: Drawn, heading: str) -> dict[Path, bytes]:
    """The bytes of all files, made before the first of them is written."""
    if not drawn.files:
        return {}
    from tmmcalc.report.gearfiles import dxf, outline_csv, svg

    made: dict[Path, bytes] = {}
    if drawn.svg is not None:
        finest = drawn.tolerance or FINENESS * min(track.member.module for track in tracks)
        made[drawn.svg] = svg(tracks, finest, heading)
    if drawn.dxf is not None:
        made[drawn.dxf] = dxf(tracks)
    if drawn.outline is not None:
        made[drawn.outline] = outline_csv(tracks)
    return made


def write(contents: dict[Path, bytes], quiet: bool) -> None:
    """Write the files, each in one step; one that has these bytes already is left alone."""
    from tmmcalc.pipeline.atomic import replace_file

    for file, data in contents.items():
        replace_file(file, data)
    if contents and not quiet:
        note_written(*contents)
