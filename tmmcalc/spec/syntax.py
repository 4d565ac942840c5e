"""TOML text to a mapping, with syntax errors in plain words."""

from __future__ import annotations

import tomllib
from typing import Any

from tmmcalc.core.errors import Fault, SpecError
from tmmcalc.spec.limits import beyond, is_suspect


def read_toml(text: str, file: str) -> dict[str, Any]:
    """Return the mapping of a TOML text; raise SpecError with line, column and a remedy."""
    text = text.removeprefix("\ufeff")
    if is_suspect(text):
        check_limits(text, file)
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        from tmmcalc.spec.slips import fault_of  # late: only faults need it

        raise SpecError(file, [fault_of(text, str(error))]) from None
    except RecursionError:
        check_limits(text, file)
        raise


def check_limits(text: str, file: str) -> None:
    """Raise SpecError if a place of the text is beyond a limit of a spec."""
    if (found := beyond(text)) is not None:
        line = text.count("\n", 0, found.at) + 1
        column = found.at - text.rfind("\n", 0, found.at)
        raise SpecError(file, [Fault("", line, found.message, found.remedy, column)])
