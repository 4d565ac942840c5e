"""The project spec: one TOML file, read, checked and turned into typed tables.

``load_spec(path)`` and ``parse_spec(text)`` return a ``Spec`` or raise a SpecError with all faults at once.
The names are loaded late: pydantic is imported only when a spec is read.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tmmcalc.project.loader import load_spec, parse_spec
    from tmmcalc.project.root import Spec

__all__ = ["Spec", "load_spec", "parse_spec"]

_HOME = {"Spec": "root", "load_spec": "loader", "parse_spec": "loader"}


def __getattr__(name: str) -> object:
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(f".{_HOME[name]}", __name__), name)
