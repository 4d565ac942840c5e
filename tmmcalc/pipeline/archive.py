"""The output folder of one run: finds the valid results, keeps the new ones, logs the run times.

Only a run with an output folder imports this module, and hashing and the store with it.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmmcalc._version import __version__
from tmmcalc.core.files import open_own
from tmmcalc.core.printable import printable
from tmmcalc.core.stage import Stage
from tmmcalc.pipeline.hashing import stage_hash
from tmmcalc.pipeline.lock import WAIT
from tmmcalc.pipeline.manifest import Provenance
from tmmcalc.pipeline.outcome import Event, Outcome
from tmmcalc.pipeline.store import Damaged, Missing, Store

if TYPE_CHECKING:
    from tmmcalc.core.columns import Column

LOG_NAME = "run.log"


class Archive:
    """Results of earlier runs in ``folder`` and of this one; ``csv`` and ``columns`` as in :meth:`Store.save`.

    ``wait`` and ``waiting`` are those of `locked`.
    """

    def __init__(
        self,
        folder: Path,
        csv: bool | None,
        columns: Sequence[str] = (),
        wait: float = WAIT,
        waiting: Callable[[float], None] = lambda seconds: None,
    ) -> None:
        self.store = Store(folder, wait, waiting)
        self.csv = csv
        self.columns = tuple(columns)
        self._open: set[str] = set()  # stages whose CSV waits until it is known that the names mean something
        self._provenance: dict[str, Provenance] = {}  # of the stages so far

    def valid(
        self,
        stage: Stage,
        inputs: object,
        settings: Mapping[str, Any],
        forced: str | None,
        tell: Callable[[Event], None],
    ) -> tuple[Outcome | None, str]:
        """Return the stored outcome of a stage if it is valid and not ``forced`` (the reason), and why it is or is not.

        The stages that it reads must have come before. A damaged file is told at once.
        """
        provenance = self._provenance_of(stage, inputs, settings)
        found = Missing(forced) if forced else self.store.find(provenance)
        if isinstance(found, Damaged):
            tell(Event(stage.name, "damaged", found.message))
            return None, "its files were damaged"
        if isinstance(found, Missing):
            return None, found.reason
        outcome = Outcome(stage, found.record, self.store.folder)
        if self.store.csv_differs(found, self.csv, self.columns):
            if self.columns:
                self._open.add(stage.name)
            else:
                self.save(outcome)
        return outcome, "files are valid"

    def save(self, outcome: Outcome) -> None:
        """Write the files of a stage that was not found valid; where columns are named its CSV comes last of all."""
        provenance = self._provenance[outcome.stage.name]
        if self.columns:
            self._open.add(outcome.stage.name)
        self.store.save(provenance, outcome.record, outcome.table, False if self.columns else self.csv)

    def write_tables(self, outcomes: Mapping[str, Outcome], further: Mapping[str, Sequence[Column]]) -> None:
        """Write the CSV files with the columns that are named, those by choice as well; the others stay as they are."""
        for stage, outcome in outcomes.items():
            if stage in self._open or stage in further:
                table = outcome.table
                if table is not None and stage in further:
                    from tmmcalc.pipeline.csvcolumns import with_columns

                    table = with_columns(table, further[stage])
                self.store.save_table(self._provenance[stage], table, self.csv, self.columns)

    def log(self, event: Event) -> None:
        """Append one line with the local time to the log; a log that cannot be written stops no run."""
        stamp = time.strftime("%Y-%m-%dT%H:%M:%S%z")
        told = " ".join(printable(event.message).split())
        line = f"{stamp} {event.stage} {event.kind} {event.seconds:.6f} s: {told}\n"
        with suppress(OSError):
            handle = open_own(self.store.folder / LOG_NAME, os.O_WRONLY | os.O_APPEND)
            try:
                os.write(handle, line.encode())  # one call: lines of two runs do not mix
            finally:
                os.close(handle)

    def clear(self, stages: Collection[str], tell: Callable[[Event], None]) -> None:
        """Remove the files of all stages but these, as :meth:`Store.remove_others` does, and tell of each."""
        for stage, gone, kept in self.store.remove_others(stages):
            changed = f"; {', '.join(kept)} was changed by hand and stays" if kept else ""
            tell(Event(stage, "removed", f"the spec has it no more; removed {', '.join(gone)}{changed}"))

    def files(self, stages: Iterable[str]) -> tuple[Path, ...]:
        """Return the files of these stages."""
        return tuple(path for stage in stages for path in self.store.files(stage))

    def _provenance_of(self, stage: Stage, inputs: object, settings: Mapping[str, Any]) -> Provenance:
        """What the result of a stage depends on."""
        upstream = {name: self._provenance[name].hash for name in stage.upstream(self._provenance)}
        digest = stage_hash(stage, inputs, settings, upstream)
        self._provenance[stage.name] = Provenance(stage.name, __version__, digest, upstream, settings)
        return self._provenance[stage.name]
