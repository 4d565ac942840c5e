"""Pictures of results, for people. matplotlib is needed only here, and only when a picture is drawn."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path

from tmmcalc.errors import UsageError
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Kinematics

FORMATS = ("svg", "png", "pdf")


def draw_kinematics(
    mechanism: Mechanism,
    result: Kinematics,
    file: Path,
    *,
    positions: Sequence[int] | None = None,
    polygons: int | None = None,
) -> None:
    """Draw the scheme in its positions, the diagrams of the outputs, and the vector polygons of one position.

    The format follows the suffix: svg, png or pdf. ``positions`` are indices of positions to draw, the first with
    main lines, the others thin; by default the middle of the working stroke (or else a quarter of the way) among
    up to 24. ``polygons`` is the index of the position whose polygons stand on a second sheet below.

    Equal inputs give equal bytes; the file is written in one step, and left alone if it has these bytes already.
    Raises `UsageError` for another suffix, a position that the result does not have, a missing matplotlib, or a
    file that cannot be written.
    """
    form = file.suffix.lower().removeprefix(".")
    if form not in FORMATS:
        raise UsageError(
            f"no picture format for the suffix {file.suffix!r} of {file.name}",
            where="plot",
            remedy=f"formats: {', '.join(FORMATS)}",
        )
    _check_positions(result, [*(positions or ()), *([] if polygons is None else [polygons])])
    if find_spec("matplotlib") is None:
        raise UsageError('pictures need matplotlib: pip install "tmmcalc[plot]"')
    from tmmcalc.pipeline.atomic import replace_file
    from tmmcalc.report.pictures.page import kinematics_page

    replace_file(file, kinematics_page(mechanism, result, form, positions, polygons))


def _check_positions(result: Kinematics, positions: Sequence[int]) -> None:
    count = len(result.x)
    for k in positions:
        if not 0 <= k < count:
            raise UsageError(f"there is no position {k}", where="plot", remedy=f"indices: 0 to {count - 1}")
