"""The ready specs with a linkage, and what their notes say."""

from __future__ import annotations

import tomllib
from functools import cache
from pathlib import Path

from tmmcalc.note.assembled import Assembler, Checked, Written
from tmmcalc.pipeline.picturing import NONE, chapter_of
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.drawing.order import POSITIONS
from tmmcalc.report.manuscript import Block

CONFIGS = Path(__file__).parent.parent.parent / "configs"
CHAPTERS = ("structure", "kinematics", "forces")
LINKAGES = [
    file.stem
    for file in sorted(CONFIGS.glob("*.toml"))
    if tomllib.loads(file.read_text(encoding="utf-8")).get("links")
    or tomllib.loads(file.read_text(encoding="utf-8")).get("mechanism", {}).get("links")
]


@cache
def blocks(name: str) -> tuple[Block, ...]:
    """The chapters of a ready spec in English."""
    return tuple(told(name))


def told(name: str, positions: str | None = None) -> list[Block]:
    """The chapters of a ready spec in the language in force."""
    done = run(load_spec(CONFIGS / f"{name}.toml"), target=CHAPTERS)
    flags = {**NONE, POSITIONS: positions}
    stages = [stage for stage in CHAPTERS if stage in done.outcomes]
    return [block for stage in stages for block in chapter_of(stage, done.spec, done.results, flags)]


def lines(name: str) -> list[Checked]:
    """The lines of a note, worked out."""
    assembler = Assembler()
    assembler.written(blocks(name))
    return assembler.lines


def written(name: str) -> list[Written]:
    """The note in the language in force."""
    return Assembler().written(told(name))
