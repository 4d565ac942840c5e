"""Many local searches side by side, whose designs are solved together.

Each runs in a thread of its own and asks for designs; when all that are still at it have asked, what they ask for is
solved in the order of the searches, so that nothing depends on which thread was faster.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

Values = NDArray[np.floating[Any]]
Ask = Callable[[Values], Values]
Found = TypeVar("Found")


class _Ended(BaseException):
    """The searches are to end: nobody answers any more."""


def together(searches: Sequence[Callable[[Ask], Found]], solve: Ask) -> list[Found]:
    """What the searches find; ``solve`` takes places (n, k) of several of them to results (n, m).

    What a search raises is raised once all are done.
    """
    board = _Board(len(searches))
    threads = [
        threading.Thread(target=board.run, args=(number, search), daemon=True) for number, search in enumerate(searches)
    ]
    for thread in threads:
        thread.start()
    try:
        while asked := board.wait():
            answers = solve(np.concatenate([places for _, places in asked]))
            ends = np.cumsum([len(places) for _, places in asked])[:-1]
            board.answer([number for number, _ in asked], np.split(answers, ends))
    finally:
        board.end()
        for thread in threads:
            thread.join()
    return board.found()


class _Board:
    """Where searches leave what they ask for, and find the answers."""

    def __init__(self, count: int) -> None:
        self._changed = threading.Condition()
        self._running = count
        self._asked: dict[int, Values] = {}
        self._answers: dict[int, Values] = {}
        self._results: dict[int, Any] = {}
        self._errors: dict[int, Exception] = {}
        self._over = False

    def run(self, number: int, search: Callable[[Ask], Any]) -> None:
        try:
            self._results[number] = search(lambda places: self._ask(number, places))
        except _Ended:
            pass
        except Exception as error:  # told in the thread that waits for all
            self._errors[number] = error
        with self._changed:
            self._running -= 1
            self._changed.notify_all()

    def _ask(self, number: int, places: Values) -> Values:
        with self._changed:
            self._asked[number] = places
            self._changed.notify_all()
            self._changed.wait_for(lambda: number in self._answers or self._over)
            if number not in self._answers:
                raise _Ended
            return self._answers.pop(number)

    def wait(self) -> list[tuple[int, Values]]:
        """What all that are still at it ask for, in their order; nothing once all are done."""
        with self._changed:
            self._changed.wait_for(lambda: len(self._asked) == self._running)
            return sorted(self._asked.items())

    def answer(self, numbers: Sequence[int], answers: Sequence[Values]) -> None:
        with self._changed:
            self._asked.clear()
            self._answers.update(zip(numbers, answers, strict=True))
            self._changed.notify_all()

    def end(self) -> None:
        with self._changed:
            self._over = True
            self._changed.notify_all()

    def found(self) -> list[Any]:
        for number in sorted(self._errors):
            raise self._errors[number]
        return [result for _, result in sorted(self._results.items())]
