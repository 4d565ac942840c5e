"""The cam turns the other way (textbook 5.3)."""

from __future__ import annotations

from copy import deepcopy

from tmmcalc.core.mistake import OFTEN, Document, Mistake, Tables
from tmmcalc.spec.altered import bare
from tmmcalc.spec.quantities import CLOCKWISE

OTHER = {"clockwise": "counter-clockwise", "counter-clockwise": "clockwise"}


def _tables(document: Document, part: str) -> Tables:
    cam = deepcopy(document.get("cam", {}))
    return {"cam": {**cam, "rotation": OTHER.get(_rotation(document, cam))}} if cam else {}


def _rotation(document: Document, cam: Document) -> str:
    """The sense of the cam: as given, that of the crank with which it turns, or clockwise."""
    speed = document.get("mechanism", {}).get("input", {}).get("speed")
    if "rotation" in cam:
        return str(cam["rotation"])
    if speed is None or "speed" in cam or cam.get("shaft", "crank") != "crank":
        return "clockwise"
    number = bare(speed)
    return "clockwise" if speed == CLOCKWISE or (number is not None and number < 0) else "counter-clockwise"


MISTAKE = Mistake(
    "the cam turns the other way",
    "Look at the arrow at the cam: which way does it turn?",
    OFTEN,
    tables=_tables,
)
