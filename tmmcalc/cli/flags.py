"""The flags that all stage commands share, put before and after those of each."""

from __future__ import annotations

from collections.abc import Callable
from inspect import Parameter, Signature, signature

from tmmcalc.cli.options import Csv, Depfile, Fresh, FromStage, Out, Quiet, Set, SpecFile, Store, Strict
from tmmcalc.cli.work import Job


def with_flags(body: Callable[..., None]) -> Callable[..., None]:
    """The command that takes the shared flags and those of ``body``, and calls ``body(job, ...)``."""
    shared = signature(_job, eval_str=True).parameters
    own = list(signature(body, eval_str=True).parameters.values())[1:]

    def command(**given: object) -> None:
        job = _job(**{name: given.pop(name) for name in shared})  # type: ignore[arg-type]
        body(job, **given)

    spec, *rest = shared.values()
    listed = [spec, *own, *rest]
    command.__signature__ = Signature(listed)  # type: ignore[attr-defined]
    command.__annotations__ = {parameter.name: parameter.annotation for parameter in listed}
    command.__doc__ = body.__doc__
    assert all(parameter.kind is Parameter.POSITIONAL_OR_KEYWORD for parameter in listed)
    return command


def _job(
    spec: SpecFile,
    out: Out = None,
    store: Store = True,
    fresh: Fresh = False,
    from_stage: FromStage = None,
    csv: Csv = None,
    depfile: Depfile = None,
    strict: Strict = False,
    quiet: Quiet = False,
    overrides: Set = None,
) -> Job:
    return Job(spec, out, store, fresh, from_stage, csv, depfile, strict, quiet, overrides or ())
