"""What the studies of a stage are called with: ``studies(scene)`` yields a study of each of its quantities."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from tmmcalc.core.records import record

if TYPE_CHECKING:
    from tmmcalc.core.studies.measure import Clock


@record
class Scene:
    """What a study starts from: what the stage reads of the spec, the results of its run, the clock."""

    inputs: Any  # as the stage's ``inputs`` gives them
    results: Mapping[str, Any]  # by stage, of it and all before it
    clock: Clock
