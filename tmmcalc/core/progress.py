"""How far a long computation is: it tells, and whoever runs it may listen."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar

Listener = Callable[[float, str], None]  # part that is done, a few words

_listener: ContextVar[Listener | None] = ContextVar("listener", default=None)


def tell(part: float, words: str) -> None:
    """Say what part is done (0 to 1); nothing happens unless somebody listens."""
    listener = _listener.get()
    if listener is not None:
        listener(part, words)


@contextmanager
def listening(listener: Listener) -> Iterator[None]:
    """Context in which ``listener`` is told."""
    token = _listener.set(listener)
    try:
        yield
    finally:
        _listener.reset(token)
