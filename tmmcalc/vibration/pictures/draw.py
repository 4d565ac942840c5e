"""Pictures of the vibratory device and of the pendulum-rotor; as the other pictures in all that concerns files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from tmmcalc.report.drawing import check_matplotlib, form_of

FIGURES = {  # stage -> "module:function", called as function(result)
    "vibrator": "vibrator:vibrator_figure",  # modes, resonance curve, starts, paths of points
    "pendulum": "pendulum:pendulum_figure",  # mode shapes, Campbell diagram, path of the lower end
}


def draw_vibration(stage: str, result: Any, file: Path) -> None:
    """Draw the result of a stage of vibration."""
    form = form_of(file)
    check_matplotlib()
    from tmmcalc.core.stage import resolve
    from tmmcalc.report.drawing.page import write

    figure = resolve(f"tmmcalc.vibration.pictures.{FIGURES[stage]}")
    write(file, form, lambda: figure(result))
