"""What is said where a command is given no spec: those of the folder, or how one is made."""

from __future__ import annotations

import re
from pathlib import Path
from shlex import quote

from tmmcalc.core.errors import UsageError
from tmmcalc.project.root import Spec

SHOWN = 8  # specs that are named
LARGEST = 1_000_000  # bytes of a file that is looked into


def no_spec(command: str) -> UsageError:
    """The error of a command, such as ``tmmcalc flywheel``, that is to be given a spec."""
    there = specs_in(Path())
    if not there:
        remedy = "this folder has none: tmmcalc init shaper -o my.toml writes one, tmmcalc init --list names others"
    else:
        more = f" and {len(there) - SHOWN} more" if len(there) > SHOWN else ""
        remedy = f"this folder has {', '.join(there[:SHOWN])}{more}; write e.g. {command} {quote(there[0])}"
    return UsageError("no spec is named", where=command, remedy=remedy)


def specs_in(folder: Path) -> list[str]:
    """Names of the TOML files of a folder that have a table of a spec; faults in them do not matter."""
    header = re.compile(rf"^\s*\[\[?\s*({'|'.join(Spec.model_fields)})\s*[].]", re.MULTILINE)
    return sorted(file.name for file in folder.glob("*.toml") if header.search(_text(file)))


def _text(file: Path) -> str:
    """What stands in a file; nothing where that cannot be read or is too long for a spec."""
    try:
        return file.read_text(encoding="utf-8", errors="replace") if file.stat().st_size <= LARGEST else ""
    except OSError:
        return ""
