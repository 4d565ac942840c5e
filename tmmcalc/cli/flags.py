"""The flags that all commands which run stages share, and commands that have them beside flags of their own."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from inspect import Parameter, Signature, signature
from math import isnan
from typing import Any

from tmmcalc.cli.found import Choose, Force, SpecOut
from tmmcalc.cli.options import (
    Csv,
    Depfile,
    Form,
    Format,
    Fresh,
    FromStage,
    Out,
    Quiet,
    Set,
    SpecFile,
    Store,
    Strict,
    Tolerance,
    Verbose,
    Wait,
)
from tmmcalc.cli.output import check_place, check_tolerance
from tmmcalc.core.errors import UsageError


def own_of(body: Callable[..., Any]) -> list[Parameter]:
    """The flags of a body: all parameters but the first."""
    return list(signature(body, eval_str=True).parameters.values())[1:]


def signed(command: Callable[..., None], own: Sequence[Parameter], body: Callable[..., Any]) -> Callable[..., None]:
    """The command with the flags that typer is to give it, the spec first, and the help of ``body``."""
    taken = {parameter.name for parameter in own}
    spec, *rest = (each for each in SHARED if each.name not in taken)
    listed = [spec, *own, *rest]
    assert all(parameter.kind is Parameter.POSITIONAL_OR_KEYWORD for parameter in listed)
    vars(command)["__signature__"] = Signature(listed)
    command.__annotations__ = {parameter.name: parameter.annotation for parameter in listed}
    command.__doc__ = body.__doc__
    return command


def taken(given: dict[str, Any], own: Sequence[Parameter]) -> dict[str, Any]:
    """The shared flags by the fields of a job, which are taken out of what is given."""
    names = {parameter.name for parameter in own}
    return _fields(**{each.name: given.pop(each.name) for each in SHARED if each.name not in names})


def _fields(
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
    wait: Wait = None,
    verbose: Verbose = False,
) -> dict[str, Any]:
    if quiet and verbose:
        raise UsageError("says less, -v more", where="-q", remedy="leave one of the two out")
    if tolerance is not None:
        check_tolerance(tolerance)
    if wait is not None and isnan(wait):
        raise UsageError("nan is no time", where="--wait", remedy="write seconds, such as --wait 10")
    if depfile is not None:
        if not store:
            raise UsageError(
                "--no-store leaves no files that could depend on the spec",
                where="--depfile",
                remedy="leave one of the two flags out",
            )
        check_place(depfile, "--depfile")
    return {
        "file": spec,
        "out": out,
        "store": store,
        "fresh": fresh,
        "from_stage": from_stage,
        "csv": csv,
        "depfile": depfile,
        "strict": strict,
        "quiet": quiet,
        "overrides": overrides or (),
        "tolerance": tolerance,
        "wait": wait,
        "verbose": verbose,
    }


SHARED = tuple(signature(_fields, eval_str=True).parameters.values())  # flags of all stage commands
FORM = Parameter("form", Parameter.POSITIONAL_OR_KEYWORD, default=Format.table, annotation=Form)
FOUND = (
    Parameter("spec_out", Parameter.POSITIONAL_OR_KEYWORD, default=None, annotation=SpecOut),
    Parameter("force", Parameter.POSITIONAL_OR_KEYWORD, default=False, annotation=Force),
)
CHOOSE = (Parameter("choose", Parameter.POSITIONAL_OR_KEYWORD, default=None, annotation=Choose),)
