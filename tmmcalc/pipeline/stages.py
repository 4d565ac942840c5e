"""The registry: every stage by name, in the order of the pipeline (each stage after the ones it needs)."""

from __future__ import annotations

from tmmcalc.pipeline.stage import Stage


def _linkage(name: str, title: str, needs: tuple[str, ...] = ()) -> Stage:
    """Declare a stage whose functions are ``<name>_inputs``, ``<name>_solve``, ... of the linkage room."""
    prefix = f"tmmcalc.linkage.stages:{name}"
    return Stage(
        name=name,
        title=title,
        needs=needs,
        inputs=f"{prefix}_inputs",
        solve=f"{prefix}_solve",
        dump=f"{prefix}_dump",
        load=f"{prefix}_load",
        table=f"{prefix}_table",
    )


STAGES: dict[str, Stage] = {
    stage.name: stage
    for stage in (
        _linkage("structure", "mobility, Assur groups, structural formula, class and order"),
        _linkage(
            "kinematics", "positions, velocities and accelerations over the cycle", needs=("structure",)
        ),
    )
}
