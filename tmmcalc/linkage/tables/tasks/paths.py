"""From the tables ``[[paths]]`` to what is asked of the paths of points."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.linkage.paths.task import WantedPath
from tmmcalc.linkage.tables.names import path_names

if TYPE_CHECKING:
    from tmmcalc.linkage.room import LinkageTables


def to_paths(spec: LinkageTables) -> tuple[WantedPath, ...]:
    """The wanted paths of the spec."""
    names = path_names([table.name for table in spec.paths], [table.point for table in spec.paths])
    return tuple(
        WantedPath(
            name=name,
            point=table.point,
            through=tuple(complex(*point) for point in table.through),
            at=tuple(table.at or ()),
            turn=table.turn,
            shift=complex(*table.shift),
        )
        for name, table in zip(names, spec.paths, strict=True)
    )
