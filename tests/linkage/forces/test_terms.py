"""Terms of the lever and of the equations of links by name: they balance, and are those of the documents."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from loaded import anything, press, ready
from random_mechanisms import KINDS

import tmmcalc
from linkage.forces.loadings import random_loading
from linkage.forces.worked import CASES
from linkage.test_properties import regular_scenes
from tmmcalc.linkage.acting import acting_on
from tmmcalc.linkage.facts.bodies import bodies_document
from tmmcalc.linkage.facts.lever import lever_document
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.forces.rows import Rows
from tmmcalc.linkage.forces.solve import solve_forces
from tmmcalc.linkage.forces.terms import equation_columns, lever_columns, lever_scale
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.loading import GearDrive, Load, Loading, Spring
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.document import Document

FRICTION = CASES["dyn-press-friction"]["expected"]
Columns = dict[str, np.ndarray]
SCENES = ("shaper", "class-three", "class-four", "hydraulic-lift", "scotch-yoke", "trammel")


def solved(mechanism: Mechanism, loading: Loading, kinematics: Kinematics | None = None) -> Rows:
    kinematics = kinematics or solve_kinematics(mechanism)
    return Rows(mechanism, loading, kinematics, solve_forces(mechanism, loading, kinematics))


def scenes() -> Iterator[Rows]:
    yield solved(*press())
    for name in SCENES:
        yield solved(ready(name), anything(ready(name)))


def made(rows: Rows) -> Columns:
    columns = [*lever_columns(rows), *equation_columns(rows)]
    assert len({column.name for column in columns}) == len(columns)
    return {column.name: column.make() for column in columns}


def terms(found: Columns, prefix: str) -> Columns:
    return {name.removeprefix(prefix): values for name, values in found.items() if name.startswith(prefix)}


def balanced(rows: Rows, result: Forces) -> None:
    """All sums by the names alone, to rounding of what they are made from."""
    found, scale = made(rows), lever_scale(rows).mu
    moments = terms(found, "lever_M_")
    size = sum(np.abs(values) for values in moments.values()) * scale / abs(result.speed) + np.abs(result.drive)
    np.testing.assert_array_less(
        np.abs(sum(moments.values()) * scale / result.speed + result.drive), 1e-9 * np.max(size) + 1e-12
    )
    np.testing.assert_allclose(sum(moments.values()), found["lever_M"], atol=1e-12 * np.max(np.abs(found["lever_M"])))
    for name, force in terms(found, "lever_F_").items():
        arm = np.where(force > 0, found[f"lever_h_{name}"], 0.0)
        np.testing.assert_allclose(moments[name], force * arm, rtol=1e-12)
    for link in (each.id for each in rows.mechanism.links):
        sizes, arms = terms(found, f"eq_{link}_F_"), terms(found, f"eq_{link}_h_")
        parts = [terms(found, f"eq_{link}_F{axis}_") for axis in "xy"]
        moments = terms(found, f"eq_{link}_M_")
        largest = max(float(np.max(values)) for values in sizes.values())
        for each in parts:
            assert np.max(np.abs(sum(each.values()))) < 1e-10 * largest + 1e-12
        assert np.max(np.abs(sum(moments.values()))) < 1e-10 * (
            largest + sum(float(np.max(np.abs(values))) for values in moments.values())
        )
        np.testing.assert_allclose(sum(moments.values()), found[f"eq_{link}_M"], atol=1e-12 * largest)
        for name, size in sizes.items():
            np.testing.assert_allclose(np.hypot(parts[0][name], parts[1][name]), size, rtol=1e-12)
            np.testing.assert_allclose(moments[name], size * np.where(size > 0, arms[name], 0.0), rtol=1e-9)


@pytest.mark.slow
def test_the_terms_balance() -> None:
    for rows in scenes():
        balanced(rows, rows.result)


@pytest.mark.parametrize("kind", KINDS)
def test_the_terms_of_random_scenes_balance(kind: str) -> None:
    compared = 0
    for seed, mechanism, kinematics in regular_scenes((kind, "RRP"), range(4)):
        loading = random_loading(np.random.default_rng(seed), mechanism, 0.1 * (seed % 2))
        try:
            rows = solved(mechanism, loading, kinematics)
        except tmmcalc.TmmError:  # locked, or no place for a load
            continue
        balanced(rows, rows.result)
        compared += 1
    assert compared >= 1


def cells(document: Document) -> Iterator[dict[str, object]]:
    assert document.table is not None
    for row in zip(*document.table.columns, strict=True):
        yield dict(zip(document.table.headers, row, strict=True))


@pytest.mark.slow
def test_they_are_what_the_documents_of_all_rows_tell() -> None:
    """Every row of the documents by its name; and no name has more than they do."""
    for rows in scenes():
        found, result = made(rows), rows.result
        every = range(len(result.labels))
        names = {(each.link, each.name, each.kind) for each in acting_on(*_of(rows))}
        count = 0
        for cell in cells(bodies_document(rows.statics, result, "", every)):
            assert (cell["link"], cell["name"], cell["kind"]) in names
            row, link, name = result.labels.index(str(cell["i"])), cell["link"], _named(found, cell)
            assert found[f"eq_{link}_M_{name}"][row] == cell["moment[N*m]"]
            if cell["force[N]"] != "":
                assert found[f"eq_{link}_F_{name}"][row] == cell["force[N]"]
                assert found[f"eq_{link}_h_{name}"][row] == cell["arm[m]"]
            count += 1
        assert count == sum(int(np.count_nonzero(each)) for each in _counted(found, rows))
        for cell in cells(lever_document(rows.statics, rows.kinematics, result, "", [*every])):
            row, name = result.labels.index(str(cell["i"])), _named(found, cell, "lever_M_")
            assert found[f"lever_F_{name}"][row] == cell["force[N]"]
            assert found[f"lever_M_{name}"][row] == cell["moment[N*mm]"]
            assert found[f"lever_h_{name}"][row] == cell["arm[mm]"]


def _of(rows: Rows) -> tuple[Mechanism, object, Loading]:
    return rows.mechanism, rows.kinematics.structure, rows.loading


def _named(found: Columns, cell: dict[str, object], prefix: str = "") -> str:
    """The name of a cell's force in names: its own, with its kind or its link where it shares it."""
    name, kind, link = (str(cell[key]) for key in ("name", "kind", "link"))
    point = f"_{cell['point']}" if cell.get("point") else ""
    prefix = prefix or f"eq_{link}_M_"
    some = (f"{name}{point}", f"{name}_{kind}{point}", f"{name}_{link}{point}", f"{name}_{kind}_{link}{point}")
    (own,) = [each for each in some if f"{prefix}{each}" in found]
    return own


def _counted(found: Columns, rows: Rows) -> Iterator[np.ndarray]:
    """Of every term on a link whether it is something, by rows."""
    for link in (each.id for each in rows.mechanism.links):
        sizes = terms(found, f"eq_{link}_F_")
        yield from sizes.values()
        yield from (values for name, values in terms(found, f"eq_{link}_M_").items() if name not in sizes)


def test_the_terms_of_the_press() -> None:
    """dyn-press-friction: R21T as a moment about B, friction moments of the pins, h of the slider."""
    rows = solved(*press())
    found = made(rows)
    at = [rows.result.labels.index(str(i) if i != 9 else "9-") for i in range(13)]
    agree = {"rtol": 1e-5, "atol": 2e-4}
    np.testing.assert_allclose(found["eq_2_M_R21"][at], -0.168 * np.array(FRICTION["R21T"]), **agree)
    np.testing.assert_allclose(found["eq_2_M_M21"][at], FRICTION["M21"], **agree)
    np.testing.assert_allclose(found["eq_2_M_M23"][at], FRICTION["M23"], **agree)
    np.testing.assert_allclose(np.abs(found["eq_3_h_N30"][at]), np.abs(FRICTION["h_mm"]) / 1e3, **agree)
    np.testing.assert_allclose(found["eq_1_M_Md"][at], FRICTION["M_bal"], **agree)


def test_the_arm_of_a_load_on_a_slider_is_its_velocity_to_scale() -> None:
    """Closed form of the crank-slider, by hand; the largest velocity of a pin is not longer than 100 mm."""
    rows = solved(press()[0], Loading(loads=(Load("Q", 3, "force", Constant(-200.0)),)))
    found, theta = made(rows), rows.result.theta
    phi2 = np.arcsin(-0.0375 * np.sin(theta) / 0.168)
    velocity = -0.0375 * 5.0 * np.sin(theta - phi2) / np.cos(phi2)
    np.testing.assert_allclose(found["lever_h_Q"], -velocity / lever_scale(rows).mu, atol=1e-9)
    np.testing.assert_allclose(found["lever_F_Q"], 200.0)
    assert 0.0375 * 5.0 / lever_scale(rows).mu <= 100  # of the crank's pin


def test_what_shares_a_name_is_told_apart() -> None:
    mechanism = ready("shaper")
    loads = (
        Load("Q", 5, "force", Constant(-100.0), against=3),
        Load("k", 5, "moment", Constant(5.0)),
        Load("G3", 3, "force", Constant(9.0)),
    )
    springs = (Spring("k", "linear", (3, 5), (0.1j, 0.2 + 0j), 50.0, 0.1, 4.0),)
    rows = solved(mechanism, replace(anything(mechanism), loads=loads, springs=springs))
    found = made(rows)
    assert {"lever_M_Q_3", "lever_M_Q_5", "lever_M_k_spring_3", "lever_M_k_damper_5"} <= found.keys()
    assert {"eq_3_M_Q", "eq_5_M_k_load", "eq_3_M_k_damper", "eq_3_M_G3_load", "eq_3_M_G3_weight"} <= found.keys()
    balanced(rows, rows.result)


def test_a_gear_on_the_crank_is_a_term() -> None:
    mechanism, loading, _ = press(friction=False)
    rows = solved(mechanism, replace(loading, drive=GearDrive(0.12, 0.35, -1.5)))
    found = made(rows)
    np.testing.assert_allclose(found["eq_1_M_Fmesh"], rows.result.drive, atol=1e-9)
    assert rows.result.mesh is not None
    np.testing.assert_allclose(found["eq_1_F_Fmesh"], np.abs(rows.result.mesh))
    balanced(rows, rows.result)
