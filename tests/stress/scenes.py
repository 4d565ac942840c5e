"""Small scenes for the ladders."""

from __future__ import annotations

from pathlib import Path

from tmmcalc.pipeline.runner import run
from tmmcalc.project.loader import Variants
from tmmcalc.stress.scene import Scene

CONFIGS = Path(__file__).parents[2] / "configs"


def variants(name: str, *overrides: str) -> Variants:
    file = CONFIGS / f"{name}.toml"
    return Variants(file.read_text(encoding="utf-8"), str(file), file.parent, overrides)


def scene(name: str, *overrides: str, target: str | None = None) -> Scene:
    source = variants(name, *overrides)
    return Scene(source.data, source.of, run(source.spec(), target=target, keep_going=True), target)
