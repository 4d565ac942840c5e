"""The Python API of names: quantities and columns of a run, those by choice too, as every command names them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np

    from tmmcalc.pipeline.outcome import RunResult


def told(result: RunResult, *names: str) -> dict[str, float]:
    """The quantities of a run under names and wildcards, ``forces.max(R_A)``, by ``stage.quantity[unit]``.

    Without names they are all facts. What has no value in this scene is left out; what is by choice is computed when a
    name asks for it. Raises `UsageError` for a name that means nothing, with the nearest.
    """
    from math import isfinite

    from tmmcalc.naming.language import parse
    from tmmcalc.naming.scene import Scene
    from tmmcalc.naming.told import told as named
    from tmmcalc.naming.told import unknown

    asked, scene = [parse(name) for name in names], Scene(result.spec, result.results)
    found = {each.key: each.value for each in named(result.results, asked, scene)}
    met = [parse(key) for key in found]
    for name in asked:
        if not any(name.fits(each) for each in met):
            raise unknown(name, result.results, scene)
    return {key: value for key, value in found.items() if isfinite(value)}


def columns(result: RunResult, stage: str, *names: str) -> dict[str, np.ndarray[Any, Any]]:
    """Columns (n,) of the table of a stage by their headers, the names of the rows first; without names all of it.

    A name that no column of the table has chooses columns by choice; where these have no value stands NaN. Raises
    `UsageError` for a stage without a table, and for a name that means nothing, with the nearest.
    """
    from tmmcalc.core.errors import UsageError
    from tmmcalc.naming.scene import Scene
    from tmmcalc.pipeline.csvcolumns import by_choice, with_columns

    table = result.table(stage) if stage in result.outcomes else None
    if table is None:
        tables = [name for name in result.outcomes if result.table(name) is not None]
        raise UsageError(f"this run has no table of {stage!r}", remedy=f"tables: {', '.join(tables)}")
    own = {stage: result.outcomes[stage]}
    further = by_choice([name for name in names if name != table.header[0]], own, Scene(result.spec, result.results))
    whole = with_columns(table, further.get(stage, ()))
    wanted = whole.selected(names)
    return dict(zip(wanted.header, wanted.columns, strict=True)) if wanted else {}
