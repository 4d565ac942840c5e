"""The ready specs with a linkage, and the lines of their notes."""

from __future__ import annotations

import tomllib
from functools import cache
from pathlib import Path

from tmmcalc.note.assembled import Assembler, Checked
from tmmcalc.pipeline.picturing import chapter_of
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.manuscript import Block

CONFIGS = Path(__file__).parent.parent.parent / "configs"
CHAPTERS = ("structure", "kinematics", "forces")
LINKAGES = [
    file.stem
    for file in sorted(CONFIGS.glob("*.toml"))
    if tomllib.loads(file.read_text(encoding="utf-8")).get("mechanism", {}).get("links") is not None
]


@cache
def blocks(name: str) -> tuple[Block, ...]:
    """The chapters of a ready spec."""
    done = run(load_spec(CONFIGS / f"{name}.toml"), CHAPTERS)
    told = [stage for stage in CHAPTERS if stage in done.outcomes]
    return tuple(block for stage in told for block in chapter_of(stage, done.spec, done.results))


def lines(name: str) -> list[Checked]:
    """The lines worked out."""
    assembler = Assembler()
    assembler.written(blocks(name))
    return assembler.lines
