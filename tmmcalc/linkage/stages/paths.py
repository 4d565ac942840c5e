"""Stage ``paths``: how far the paths of points are from wanted ones."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.linkage.paths.results import Paths

if TYPE_CHECKING:
    from tmmcalc.linkage.model import Mechanism
    from tmmcalc.linkage.paths.task import WantedPath
    from tmmcalc.linkage.room import LinkageTables

solve = "tmmcalc.linkage.paths.solve:solve_paths"
kind = Paths
columns = "tmmcalc.linkage.paths.columns:path_columns"
declares = ()


def inputs(spec: LinkageTables) -> tuple[Mechanism, tuple[WantedPath, ...]]:
    """The linkage, and the wanted paths."""
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
    from tmmcalc.linkage.tables.tasks.paths import to_paths

    return to_linkage(spec.linkage), to_paths(spec)
