"""The kinds of synthesis: a new one joins by one line, the function that solves a `SynthesisTask` of it."""

from __future__ import annotations

from dataclasses import replace

from tmmcalc.linkage.synthesis.errors import sizes_error
from tmmcalc.linkage.synthesis.results import Synthesis
from tmmcalc.linkage.synthesis.task import SynthesisTask

_HOME = "tmmcalc.linkage.synthesis"
KINDS = {  # kind -> "module:function", called as function(task)
    "slider_crank": f"{_HOME}.crank_slider:solve",
    "slotted_link": f"{_HOME}.slotted:solve",
    "rotating_slotted_link": f"{_HOME}.rotating:solve",
    "crank_rocker": f"{_HOME}.rocker:solve",
    "trailing_rod": f"{_HOME}.trailing:solve",
    "path": f"{_HOME}.path:solve",
    "function": f"{_HOME}.function:solve",
    "motion": f"{_HOME}.guidance:solve",
    "dwell": f"{_HOME}.dwell.solve:solve",
}
SEARCHES = ("path", "function", "motion")  # which find more designs than they list


def solve_synthesis(task: SynthesisTask) -> Synthesis:
    """The designs for a task, best first, each simulated; raises `NoSolutionError` if there is none."""
    from importlib import import_module

    module, _, name = KINDS[task.kind].partition(":")
    found: Synthesis = getattr(import_module(module), name)(task)
    return replace(found, error=sizes_error(task, found))
