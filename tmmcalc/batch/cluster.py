"""The workers of a Dask cluster, reached through its scheduler."""

from __future__ import annotations

import logging
from collections.abc import Iterable, Iterator
from concurrent.futures import CancelledError, Executor
from contextlib import contextmanager
from time import monotonic
from typing import TYPE_CHECKING

from tmmcalc.batch.executors import Block, Tell, Workers, solve_by
from tmmcalc.batch.task import Row, Task
from tmmcalc.core.errors import TmmError, UsageError

if TYPE_CHECKING:
    from distributed import Client

REACH = 10.0  # seconds within which a scheduler answers
WITHOUT = 60.0  # seconds that a sweep waits for a worker to come


_KEPT: dict[str, Client] = {}  # connections that stay open, by their addresses


def solve_on(address: str, task: Task, blocks: Iterable[Block], tell: Tell, kept: bool = False) -> Iterator[list[Row]]:
    """Solve blocks by the workers of the scheduler at ``address`` (``tcp://10.0.0.1:8786``), those that come later too.

    Raises UsageError if distributed is not installed, if no scheduler answers or no worker comes, and for workers
    that do not have this program. ``kept``: the connection stays for who asks again and again.
    """
    try:
        from distributed import KilledWorker
    except ImportError:
        from tmmcalc.core.installation import install

        raise UsageError(
            "a cluster needs dask.distributed, which is not installed",
            where="--scheduler",
            remedy=install("dask"),
        ) from None
    with _kept(address) if kept else _client(address) as client:
        watch = _Watch(client, address)
        workers = Workers(lambda: _executor(client), lambda: _threads(client), (KilledWorker,), watch)
        try:
            yield from solve_by(workers, task, blocks, tell)
        except TmmError:
            raise
        except CancelledError:
            raise watch.gone() from None
        except Exception as error:
            if client.status in ("closing", "closed"):  # it gave up while work was on its way out or back
                raise watch.gone() from None
            raise UsageError(
                f"the workers of {address} cannot run tmmcalc: {type(error).__name__}: {error}",
                where="--scheduler",
                remedy="install the same tmmcalc on all workers",
            ) from error


@contextmanager
def _client(address: str) -> Iterator[Client]:
    with _opened(address) as client:
        yield client


def _opened(address: str) -> Client:
    from distributed import Client

    logging.getLogger("distributed").setLevel(logging.CRITICAL)  # its loss of a connection is told once, by us
    try:
        return Client(address, timeout=REACH, set_as_default=False)
    except (OSError, ValueError, TimeoutError) as error:
        raise UsageError(
            f"no Dask scheduler answers at {address}: {error}",
            where="--scheduler",
            remedy="start one by `dask scheduler`, which prints its address",
        ) from None


@contextmanager
def _kept(address: str) -> Iterator[Client]:
    """A connection that stays open when the block ends well, until this process ends."""
    client = _KEPT.pop(address, None)
    if client is None or client.status != "running":
        client = _opened(address)
    try:
        yield client
    except BaseException:
        client.close()
        raise
    _KEPT[address] = client


@contextmanager
def _executor(client: Client) -> Iterator[Executor]:
    executor: Executor = client.get_executor(pure=False)
    try:
        yield executor
    finally:
        executor.shutdown(wait=False)


def _threads(client: Client) -> int:
    """Blocks that the workers solve at once, at least one: work may wait for the first worker."""
    try:
        return max(1, sum(client.nthreads().values()))
    except (OSError, RuntimeError):  # what has become of the scheduler is for the watch to say
        return 1


class _Watch:
    """Whether scheduler and workers are still there; called while nothing comes back."""

    def __init__(self, client: Client, address: str) -> None:
        self._client, self._address = client, address
        self._since: float | None = None  # when the last worker was missed first

    def __call__(self) -> None:
        try:
            there = bool(self._client.nthreads())
        except (OSError, RuntimeError):
            raise self.gone() from None
        if there:
            self._since = None
            return
        self._since = self._since or monotonic()
        if monotonic() - self._since > WITHOUT:
            raise UsageError(
                f"the scheduler at {self._address} has no workers",
                where="--scheduler",
                remedy=f"start some: dask worker {self._address}",
            )

    def gone(self) -> UsageError:
        """The error of a scheduler that answers no more."""
        return UsageError(
            f"the scheduler at {self._address} is gone",
            where="--scheduler",
            remedy="start it again; finished points are kept and the same command goes on from there",
        )
