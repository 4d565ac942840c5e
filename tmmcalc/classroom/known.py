"""The mistakes that the program knows: those of all rooms, and those that may be made in any subject.

A mistake is a new module in a folder ``mistakes``; its name is that of the room, or ``classroom``, and of its file.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib import import_module
from pathlib import Path

import tmmcalc
from tmmcalc.core.mistake import Mistake
from tmmcalc.rooms import ROOMS

HOUSE = Path(tmmcalc.__file__).parent
HOMES = (*(room.name for room in ROOMS), "classroom")


@cache
def known() -> Mapping[str, Mistake]:
    """All mistakes by name, the commoner ones first."""
    names = (
        f"{home}.{file.stem}"
        for home in HOMES
        for file in sorted((HOUSE / home / "mistakes").glob("*.py"))
        if file.stem != "__init__"
    )
    found = {name: _mistake(name) for name in names}
    return dict(sorted(found.items(), key=lambda each: each[1].common))


def _mistake(name: str) -> Mistake:
    home, _, file = name.partition(".")
    mistake: Mistake = import_module(f"tmmcalc.{home}.mistakes.{file}").MISTAKE
    return mistake
