"""Stage ``transloader``: speeds, loads and stresses of a grab transloader."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from tmmcalc.extras.tables.tasks.transloader import to_transloader
from tmmcalc.extras.transloader import Transloader, solve_transloader

inputs = to_transloader
solve = solve_transloader
kind = Transloader


def errors(result: Transloader) -> dict[str, Any]:
    """Estimates of its errors."""
    return {"numbers": result.error}


def details(spec: Any, results: Mapping[str, Any]) -> Mapping[str, Any]:
    """Facts by choice: every load and every limit by its name, the stress of every part by its case and kind."""
    found: Transloader = results["transloader"]
    stresses = {f"{each.part}.{each.case}.{each.kind}": each for each in found.checks}
    loads = {f"loads.{each.load}": each for each in found.loads}
    return {**loads, **{f"limits.{each.name}": each for each in found.limits}, **stresses}
