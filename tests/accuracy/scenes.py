"""Studies of ready specs, each setting run once."""

from __future__ import annotations

from pathlib import Path

from tmmcalc import load_spec
from tmmcalc.accuracy.solve import solve_accuracy
from tmmcalc.core.studies.measure import Clock
from tmmcalc.core.studies.study import Series, Study

CONFIGS = Path(__file__).parents[2] / "configs"
ONCE = Clock(repeats=1, budget=0.0)


def studies_of(name: str, stage: str, *overrides: str) -> dict[str, Study]:
    """Those of a stage, by quantity."""
    found = solve_accuracy(load_spec(CONFIGS / f"{name}.toml", overrides), stage, ONCE)
    return {study.quantity: study for study in found.studies}


def study_of(name: str, stage: str, *overrides: str) -> Study:
    """The only one of a stage."""
    (found,) = studies_of(name, stage, *overrides).values()
    return found


def series_of(study: Study, name: str) -> Series:
    """The first method whose name begins so."""
    return next(series for series in study.series if series.method.startswith(name))


def errors_in(series: Series) -> list[float]:
    """Of the settings with a result."""
    return [point.error for point in series.points if point.error is not None]


def errors_of(study: Study, name: str) -> list[float]:
    """Of the settings of a method."""
    return errors_in(series_of(study, name))
