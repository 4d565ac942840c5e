"""Faults of an assignment from several places of it, told together."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from tmmcalc.core.errors import Fault, SpecError
from tmmcalc.project import Spec
from tmmcalc.project.loader import refused
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.phrases import Path


class Faults:
    """What is wrong with a spec, collected part by part."""

    def __init__(self, spec: Spec) -> None:
        self._spec = spec
        self._found: list[Fault] = []

    def add(self, error: SpecError, path: Path = ()) -> None:
        """Keep the faults of an error; those of another file are told at the ``path`` that names it."""
        if path:
            findings = [
                Finding(path, f"{error.file}{f':{each.line}' if each.line else ''}: {each.message}", each.remedy)
                for each in error.faults
            ]
            error = refused(self._spec, findings)
        self._found += error.faults

    @contextmanager
    def gathered(self) -> Iterator[None]:
        """Keep the faults of what is done inside."""
        try:
            yield
        except SpecError as error:
            self.add(error)

    def tell(self) -> None:
        """Raise the one error of all, if there is any."""
        if self._found:
            raise SpecError(refused(self._spec, ()).file, self._found)
