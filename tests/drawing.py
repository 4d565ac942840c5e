"""Results drawn to files, as ``tmmcalc plot`` does."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from tmmcalc.cli.plot import ordered
from tmmcalc.report.drawing import draw


def draw_stage(stage: str, spec: Any, results: Mapping[str, Any], file: Path) -> None:
    """The picture of a stage, no flags given."""
    ordered(stage, spec, results, {}, file)


def draw_kinematics(mechanism: Any, result: Any, file: Path, *, positions: Any = None, polygons: Any = None) -> None:
    def figure() -> Any:
        from tmmcalc.linkage.pictures.kinematics import kinematics_drawing

        return kinematics_drawing(mechanism, result, positions, None if polygons is None else [polygons])

    draw(file, figure)


def draw_forces(
    mechanism: Any, loading: Any, kinematics: Any, result: Any, file: Path, *, polygons: Any = None
) -> None:
    def figure() -> Any:
        from tmmcalc.linkage.pictures.forces import forces_drawing

        return forces_drawing(mechanism, loading, kinematics, result, None if polygons is None else [polygons])

    draw(file, figure)


def draw_cam(stage: str, task: Any, result: Any, file: Path) -> None:
    def figure() -> Any:
        from importlib import import_module

        home = import_module(f"tmmcalc.cams.pictures.{stage}")
        return getattr(home, f"{stage.removeprefix('cam_')}_drawing")(task, result)

    draw(file, figure)


def drawn(stage: str, room: str, file: Path, *given: Any, **chosen: Any) -> None:
    """The figure of a stage of what it is drawn from."""

    def figure() -> Any:
        from importlib import import_module

        home = import_module(f"tmmcalc.{room}.pictures.{stage}")
        make = getattr(home, f"{stage}_drawing", None) or getattr(home, f"{stage}_figure")
        return make(*given, **chosen)

    draw(file, figure)
