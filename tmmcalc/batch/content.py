"""What a task depends on: its own fields, and what stands in the files that its spec names."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from functools import lru_cache
from pathlib import Path
from typing import Any

from tmmcalc._version import __version__
from tmmcalc.batch.task import Task
from tmmcalc.core.files import read_file
from tmmcalc.pipeline.hashing import FORMAT, content_hash


def key_of(task: Task) -> str:
    """Hash of all that the table depends on: program, spec, the files that it names, points, what is asked."""
    variants = task.variants()
    files = _contents(files_of(variants.data, variants.folder), variants.folder)
    axes = [(axis.key, axis.unit, axis.values) for axis in task.axes]
    asked = task.targets, task.patterns, task.tolerance
    return content_hash(
        ("sweep", FORMAT, __version__, repr(variants.data), files, axes, task.listed, task.labels, asked)
    )


def hash_of_files(task: Task) -> str:
    """Hash of the files that the spec names, as they are now; empty where it names none."""
    folder = Path(task.folder)
    names = _named(task.text, task.file, task.fixed)
    return content_hash(_contents(_there(names, folder), folder)) if names else ""


def files_of(data: Any, folder: Path) -> list[str]:
    """Files that a document names and that are there, as it names them."""
    return _there(_names(data), folder)


def _there(names: Iterable[str], folder: Path) -> list[str]:
    return [name for name in names if (folder / name).is_file()]


def _contents(names: Iterable[str], folder: Path) -> list[tuple[str, bytes]]:
    found = []
    for name in names:
        with suppress(OSError):  # what cannot be read is told where the spec is read
            found.append((name, read_file(folder / name)))
    return found


@lru_cache(maxsize=4)  # a spec is read once, its files before every block
def _named(text: str, file: str, fixed: tuple[str, ...]) -> tuple[str, ...]:
    from tmmcalc.project.loader import Variants

    return tuple(_names(Variants(text, file, Path(), fixed).data))


def _names(data: Any) -> Iterator[str]:
    parts = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    for key, value in parts:
        if key in ("file", "catalogue") and isinstance(value, str):
            yield value
        else:
            yield from _names(value)
