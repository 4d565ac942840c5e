"""Checks of ``[class]`` beyond single values."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline

CHECKS: tuple[Callable[[Outline], Iterator[Finding]], ...] = ()
