"""The document of the drive stage: whose ratio the train is sought for, and the rounds in which a motor settled."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import keyed
from tmmcalc.machine.driveline import Round
from tmmcalc.machine.settled import Settled
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import number


def summary(result: Settled, title: str) -> Document:
    """The ratio, and a line for every round."""
    facts = [Fact("ratio for the train", f"{number(result.ratio)}: {result.origin}", keyed(result, "ratio", "origin"))]
    if result.rounds:
        facts.append(rounds_fact(result.rounds, result.alternating))
    return Document(title, tuple(facts), tuple(turn_notes(result.alternating)))


def rounds_fact(rounds: tuple[Round, ...], in_turn: tuple[str, ...]) -> Fact:
    """Motor, ratio and train of every round."""
    count = f"{len(rounds)} round{'s' if len(rounds) > 1 else ''}"
    lines = [f"not settled in {count}" if in_turn else f"settled in {count}"]
    lines += [
        f"{each.motor}: u = {number(each.ratio)}"
        + (f", train {each.train}, efficiency {number(each.efficiency)}" if each.train else "")
        for each in rounds
    ]
    return Fact("motor, ratio, train", "\n".join(lines), {"rounds": [keyed(each) for each in rounds]})


def turn_notes(in_turn: tuple[str, ...]) -> Iterator[str]:
    """What is to be said where no round settled it."""
    if in_turn:
        yield (
            Phrase(
                "warning: the motors {in_turn} come in turn, each asked for by the train of another: the "
                "strongest is taken; give the motor by its name, or ratio in [train]",
                in_turn=in_turn,
            )
        )
