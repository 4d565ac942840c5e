"""Designs of a synthesis judged one by one, against the kinematics of their own ready specs."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import tmmcalc
from tmmcalc.core.errors import NoSolutionError, SingularityError, UsageError
from tmmcalc.feasibility.stages.feasibility import solve
from tmmcalc.pipeline import runner
from tmmcalc.pipeline.runner import upstream_of
from tmmcalc.project import templates
from tmmcalc.rooms import STAGES

TEXT = (templates.folder() / "feasibility.toml").read_text()


def found(*overrides: str) -> Any:
    return tmmcalc.run(tmmcalc.load_spec(templates.folder() / "feasibility.toml", overrides), target="feasibility")


def test_every_design_is_judged_by_its_own_simulation() -> None:
    run = found()
    result, designs = run.results["feasibility"], run.results["synthesis"].designs
    assert len(designs) == 2
    for candidate in result.candidates:
        design = designs[candidate.number - 1]
        motion = tmmcalc.solve_kinematics(tmmcalc.parse_spec(design.spec))
        row = motion.trace.link_ids.index(3)
        values = {verdict.name: verdict.value for verdict in candidate.verdicts}
        assert values["calm"] == pytest.approx(np.abs(motion.trace.dangle[row]).max() * 2 * np.pi, rel=1e-12)
        assert values["transmits"] == design.merits["transmission_min[deg]"]
        assert values["short"] == design.size("L")
        calm, short = values["calm"] <= 2.5, values["short"] <= 0.35
        assert candidate.feasible == (values["transmits"] >= 35 and (calm or not short))
    assert [candidate.number for candidate in result.candidates] == [2, 1]
    assert result.chosen == 2
    assert result.feasible
    assert result.verdicts == result.candidates[0].verdicts
    assert result.candidates[1].failing == ("calm", "short")
    assert STAGES["feasibility"].load(STAGES["feasibility"].dump(result)) == result


def test_designs_that_are_all_feasible_keep_their_order() -> None:
    result = found('constraints[1].at_most="10 rad/s"').results["feasibility"]
    assert [(each.number, each.feasible) for each in result.candidates] == [(1, True), (2, True)]


def test_without_a_feasible_design_the_nearest_is_first() -> None:
    """The second design is the calmer one."""
    result = found('constraints[1].at_most="1 rad/s"', 'feasibility.rule="calm"').results["feasibility"]
    assert not result.feasible
    assert [each.number for each in result.candidates] == [2, 1]
    first, second = (each.function for each in result.candidates)
    assert second < first < 0
    assert result.failing == ("calm",)


def test_a_stage_that_no_ready_spec_has() -> None:
    with pytest.raises(UsageError, match="nothing acts on the links"):
        found('constraints[1].stage="forces"', 'constraints[1].column="R_A"')


def test_a_design_that_cannot_be_judged_is_last(monkeypatch: pytest.MonkeyPatch) -> None:
    run = found()
    scene, whole = tmmcalc.parse_spec(TEXT.split("\n", 1)[1]), runner.run
    from tmmcalc.feasibility.stages.feasibility import inputs

    broken = run.results["synthesis"].designs[1].spec

    def refusing(spec: Any, **options: Any) -> Any:
        if spec.model_dump() == tmmcalc.parse_spec(broken).model_dump():
            raise SingularityError("dead point", where="kinematics", remedy="x")
        return whole(spec, **options)

    monkeypatch.setattr(runner, "run", refusing)
    upstream = {"synthesis": run.results["synthesis"]}
    result = solve(*inputs(scene), **upstream_of(STAGES["feasibility"], upstream))
    assert [each.number for each in result.candidates] == [1, 2]
    assert result.candidates[1].refused == "kinematics: dead point"
    assert result.candidates[1].function is None
    assert STAGES["feasibility"].load(STAGES["feasibility"].dump(result)) == result

    def never(spec: Any, **options: Any) -> Any:
        raise SingularityError("dead point", where="kinematics", remedy="x")

    monkeypatch.setattr(runner, "run", never)
    with pytest.raises(NoSolutionError, match="no design can be judged; the first: kinematics: dead point"):
        solve(*inputs(scene), **upstream_of(STAGES["feasibility"], upstream))
