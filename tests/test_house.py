"""The house as its imports draw it: arrows point one way, between packages and rooms too, and no circle is closed.

Every import counts, those inside functions and those for type checkers alone as well.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from tmmcalc.rooms import ROOMS

ROOT = Path(__file__).parent.parent / "tmmcalc"

# From the ground up: a package imports from those below it, and from its own modules.
FLOORS = (
    "core",
    "spec",
    "naming",
    "report",
    "feasibility",
    "linkage",
    "gears",
    "machine",
    "cams",
    "vibration",
    "manipulators",
    "extras",
    "design.tables",
    "classroom.tables",
    "rooms",
    "project",
    "pipeline",
    "note",
    "accuracy",
    "batch",
    "design",
    "page",
    "stress",
    "classroom",
    "api",
    "cli",
)


def name_of(file: Path) -> str:
    """``tmmcalc.core.stage`` of its file."""
    parts = file.relative_to(ROOT.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


@cache
def house() -> dict[str, set[str]]:
    """What every module imports of the house."""
    files = {name_of(file): file for file in ROOT.rglob("*.py")}
    return {name: set(_imported(file, files)) - {name} for name, file in files.items()}


def _imported(file: Path, files: dict[str, Path]) -> Iterator[str]:
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names if alias.name in files)
        elif isinstance(node, ast.ImportFrom):
            assert not node.level, f"{file}: imports are absolute"
            home = node.module or ""
            if home.partition(".")[0] == "tmmcalc":
                assert home in files, f"{file}: there is no {home}"
                inner = (f"{home}.{alias.name}" for alias in node.names)
                yield from (each if each in files else home for each in inner)


def package(module: str) -> str:
    """Its floor; tables of what is asked of a design, of a class stand below, where specs are read, the rest above."""
    for home in ("design.tables", "classroom.tables"):
        if f"{module}.".startswith(f"tmmcalc.{home}."):
            return home
    return module.split(".")[1] if "." in module else ""


def test_every_package_has_its_floor() -> None:
    packages = {package(name) for name in house()} - {"", "_version", "__main__"}
    assert packages == {*FLOORS}
    assert {room.name for room in ROOMS} < packages


def test_arrows_point_one_way() -> None:
    floor = {name: number for number, name in enumerate(FLOORS)}
    back = [
        f"{name} -> {other}"
        for name, others in house().items()
        for other in others
        if package(name) in floor and package(other) in floor and floor[package(other)] > floor[package(name)]
    ]
    assert back == []


def test_there_is_no_circle() -> None:
    """Modules that import nothing more are taken away until none is left; what remains imports itself in a circle."""
    left = {name: {*others} for name, others in house().items() if not name.endswith("__init__")}
    while done := {name for name, others in left.items() if not others & left.keys()}:
        left = {name: others for name, others in left.items() if name not in done}
    assert left == {}


def test_manifests_import_no_theory() -> None:
    """They are read at every start: what they name is imported when it is used."""
    light = {"tmmcalc.core.manifest", "tmmcalc.core.stage", "tmmcalc.core.errors"}
    for room in ROOMS:
        tree = ast.parse((ROOT / room.name / "room.py").read_text(encoding="utf-8"))
        at_once = {node.module for node in tree.body if isinstance(node, ast.ImportFrom)}
        assert at_once - {"__future__", "typing"} <= light, room.name
