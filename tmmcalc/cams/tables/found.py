"""What the stages of cams found as keys of ``[cam]``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.errors import UsageError
from tmmcalc.spec.rewrite import Change, Found

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tmmcalc.cams.optimum.results import CamOptimum, Option
    from tmmcalc.cams.room import CamTables
    from tmmcalc.cams.synthesis.results import Synthesis
    from tmmcalc.cams.tables.cam import CamTable

_TRIANGLE = ("start_angle", "base_radius", "centre_distance", "rocker_length")  # three of them settle a rocker


def of_synthesis(spec: CamTables, result: Synthesis, choose: int | None = None) -> Found:
    """The sizes that were not given; raises `UsageError` if all were."""
    assert spec.cam is not None
    changes = tuple(_sizes(spec.cam, result))
    if not changes:
        rule = "nothing was sought: all sizes of the cam are given"
        raise UsageError(rule, where="--spec", remedy="leave --spec out, or a size, such as start_distance")
    return Found(changes)


def _sizes(table: CamTable, result: Synthesis) -> Iterator[Change]:
    follower = result.follower
    if follower.kind == "oscillating":
        yield from _triangle(table, result)
    elif table.start_distance is None and table.base_radius is None:
        yield Change(("cam", "start_distance"), follower.start, "mm")
        if follower.kind == "translating" and table.offset is None:
            yield Change(("cam", "offset"), follower.sense * follower.offset + 0.0, "mm")
    if follower.kind != "flat" and table.roller_radius is None:
        yield Change(("cam", "roller_radius"), follower.roller, "mm")


def _triangle(table: CamTable, result: Synthesis) -> Iterator[Change]:
    """So many sizes of cam axis, pivot and roller as settle the rocker together with those that are given."""
    follower = result.follower
    found = {
        "rocker_length": (follower.rocker, "mm"),
        "centre_distance": (follower.centres, "mm"),
        "start_angle": (follower.start, "deg"),
    }
    given = [key for key in _TRIANGLE if getattr(table, key) is not None]
    for key in [key for key in found if key not in given][: len(_TRIANGLE) - 1 - len(given)]:
        value, unit = found[key]
        yield Change(("cam", key), value, unit)


def of_optimum(spec: CamTables, result: CamOptimum, choose: int | None = None) -> Found:
    """The lowest mechanism in whole steps; its search goes, and what would settle a size twice."""
    assert spec.cam is not None
    chosen = result.chosen
    if result.kind == "oscillating":
        return _smallest(result)
    changes = [Change(("cam", "start_distance"), chosen.start, "mm")]
    if result.kind != "flat":
        changes.append(Change(("cam", "roller_radius"), chosen.roller, "mm"))
    if result.offset and spec.cam.offset is None:
        changes.append(Change(("cam", "offset"), result.offset, "mm"))
    changes.append(Change(("cam", "guide", "top"), chosen.height, "mm"))
    changes += _of_shown(result)
    gone = (("base_radius",), ("guide", "length"), ("optimum",))
    return Found((*changes, *(Change(("cam", *key)) for key in gone)), ends=("cam_optimum",))


def _smallest(result: CamOptimum) -> Found:
    """The triangle of the smallest mechanism with a rocker by its three lengths, and the roller."""
    chosen = result.chosen
    sizes = {
        "centre_distance": chosen.height,
        "rocker_length": chosen.length,
        "base_radius": chosen.start,
        "roller_radius": chosen.roller,
    }
    changes = [*(Change(("cam", key), size, "mm") for key, size in sizes.items()), *_of_shown(result)]
    gone = (("start_angle",), ("optimum",))
    return Found((*changes, *(Change(("cam", *key)) for key in gone)), ends=("cam_optimum",))


def _of_shown(result: CamOptimum) -> Iterator[Change]:
    """What the option that is shown changes, where it is not what is asked."""
    if result.shown:
        option = next(each for each in result.options if each.changes == result.shown)
        yield from _of_option(result.options[0], option)


def _of_option(asked: Option, shown: Option) -> Iterator[Change]:
    """What an option of the design game changes."""
    if shown.law != asked.law:
        yield Change(("cam", "law"), shown.law)
        yield from (Change(("cam", key)) for key in ("rise_law", "return_law"))
    if shown.safety != asked.safety:
        yield Change(("cam", "spring", "method"), "safety")
        yield Change(("cam", "spring", "safety"), shown.safety)
    if shown.allowed != asked.allowed:
        yield Change(("cam", "requirements", "contact"), shown.allowed, "MPa")
    if shown.ratio != asked.ratio:
        yield Change(("cam", "requirements", "roller_ratio"), shown.ratio)
