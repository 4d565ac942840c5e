"""The sense of one value is reversed."""

from tmmcalc.core.mistake import OFTEN, Asked, Mistake


def _reads(asked: Asked) -> float:
    return -asked.value


MISTAKE = Mistake(
    "the sense of the value is reversed",
    "Look at the sense: which direction did you count as positive, and which one does the task?",
    OFTEN,
    reads=_reads,
)
