"""The laws of technological loads, one a file, which joins by being here: `Law` says what it provides."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from importlib import import_module
from pkgutil import iter_modules

from tmmcalc.linkage.loadlaws.law import Law


@cache
def laws() -> dict[str, type[Law]]:
    """The laws by their keys in ``[[loads]]``, in the order of these."""
    for module in iter_modules(__path__):
        import_module(f"{__name__}.{module.name}")
    found = sorted(_with_rank(Law), key=lambda law: law.rank)
    return {key: law for law in found for key in law.spec_keys()}


def _with_rank(law: type[Law]) -> Iterator[type[Law]]:
    if "rank" in vars(law):
        yield law
    for each in law.__subclasses__():
        yield from _with_rank(each)
