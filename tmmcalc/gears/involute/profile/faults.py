"""Why a wheel has no profile: a length that misses its limit, so that it can be told in any unit."""

from __future__ import annotations

from tmmcalc.core.errors import NoSolutionError


class ProfileError(NoSolutionError):
    """No such tooth: ``what`` in words without numbers; ``value`` and ``limit`` are lengths in normal modules."""

    def __init__(self, what: str, value: float, limit: float, *, where: str, remedy: str) -> None:
        self.what = what
        self.lengths = value, limit
        super().__init__(
            f"{what}: {value:.6g} against {limit:.6g} modules", where=where, value=value, limit=limit, remedy=remedy
        )
