"""The designs that were found as ready specs."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from tmmcalc.core.atomic import replace_file
from tmmcalc.design.optimize.scene import Optimum
from tmmcalc.project.loader import Variants, read_text
from tmmcalc.spec.override import apply

_FILES = ("file", "catalogue")  # keys that name a file beside the spec


def write_ready(result: Optimum, file: Path, fixed: Sequence[str], out: Path) -> list[Path]:
    """Write each design as a spec, to ``out`` or, of a front, to ``out`` with its number; return the files.

    Comments of the spec are not in them; files that it names are named from where they stand.
    """
    data = Variants(read_text(file), str(file), file.parent, fixed).data
    written = []
    for number, design in enumerate(result.designs, 1):
        name = out if len(result.objectives) == 1 else out.with_stem(f"{out.stem}-{number}")
        own, _ = apply(data, design.assignments)
        replace_file(name, _toml(_moved(own, file.parent, name.parent)))
        written.append(name)
    return written


def _toml(data: dict[str, Any]) -> bytes:
    import tomli_w

    return tomli_w.dumps(data).encode()


def _moved(part: Any, home: Path, there: Path) -> Any:
    """The document with the files that it names as they are called from another folder."""
    if isinstance(part, list):
        return [_moved(each, home, there) for each in part]
    if not isinstance(part, dict):
        return part
    return {
        key: _called(value, home, there)
        if key in _FILES and isinstance(value, str) and (home / value).is_file()
        else _moved(value, home, there)
        for key, value in part.items()
    }


def _called(name: str, home: Path, there: Path) -> str:
    return Path(os.path.relpath(home / name, there)).as_posix()
