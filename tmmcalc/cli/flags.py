"""The flags that all stage commands share, put before and after those of each."""

from __future__ import annotations

from collections.abc import Callable
from inspect import Parameter, Signature, signature

from tmmcalc.cli.options import Csv, Depfile, Fresh, FromStage, Out, Quiet, Set, SpecFile, Store, Strict, Tolerance
from tmmcalc.cli.work import Job, check_tolerance


def with_flags(body: Callable[..., None]) -> Callable[..., None]:
    """The command that takes the shared flags and those of ``body``, and calls ``body(job, ...)``.

    A flag of the body's own stands in place of the shared one of its name.
    """
    own = list(signature(body, eval_str=True).parameters.values())[1:]
    taken = {parameter.name for parameter in own}
    shared = {name: each for name, each in signature(_job, eval_str=True).parameters.items() if name not in taken}

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
    tolerance: Tolerance = None,
    overrides: Set = None,
) -> Job:
    if tolerance is not None:
        check_tolerance(tolerance)
    return Job(spec, out, store, fresh, from_stage, csv, depfile, strict, quiet, overrides or (), tolerance=tolerance)
