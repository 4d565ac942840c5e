"""The mechanisms of the worked cases of classes III and IV."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from linkage.scenes import bar, pin, polar
from tmmcalc import Assembly, Body, Constant, Grid, Input, Link, Load, Loading, Mechanism

CASES = {
    case["id"]: case
    for case in json.loads(
        (Path(__file__).parents[2] / "cases" / "force-groups-and-linkage-synthesis.json").read_text(encoding="utf-8")
    )
}


def case(name: str) -> tuple[dict[str, Any], dict[str, Any]]:
    """Inputs and expected values of a case that somebody verified."""
    found = CASES[name]
    assert found["verified"]
    return found["inputs"], found["expected"]


def class_four(given: dict[str, Any], crank: float, f: complex, **assembly: Any) -> Mechanism:
    """Crank OA, links ACD and FBE, bars CB and DE."""
    two, five = given["link2"], given["link5"]
    bodies = (
        bar(1, O=0, A=crank),
        bar(2, A=0, C=two["l_AC"], D=polar(two["l_AD"], two["angle_CAD"])),
        bar(3, C=0, B=given["link3"]["l_CB"]),
        bar(4, D=0, E=given["link4"]["l_DE"]),
        bar(5, F=0, B=five["l_FB"], E=polar(five["l_FE"], five["angle_BFE"])),
    )
    joints = (("O", 0, 1), ("A", 1, 2), ("C", 2, 3), ("D", 2, 4), ("B", 3, 5), ("E", 4, 5), ("F", 0, 5))
    return _pinned({"O": 0j, "F": complex(f)}, bodies, joints, **assembly)


def class_three(given: dict[str, Any], crank: float, **assembly: Any) -> Mechanism:
    """Crank OA, plate P1 P2 P3 on the legs A-P1, Q2-P2 and Q3-P3."""
    legs, own = given["leg_lengths"], {k: complex(*v) for k, v in given["platform_local"].items()}
    bodies = (
        bar(1, O=0, A=crank),
        bar(2, A=0, P1=legs[0]),
        bar(3, **own),
        bar(4, Q2=0, P2=legs[1]),
        bar(5, Q3=0, P3=legs[2]),
    )
    joints = (("O", 0, 1), ("A", 1, 2), ("P1", 2, 3), ("P2", 3, 4), ("P3", 3, 5), ("Q2", 0, 4), ("Q3", 0, 5))
    frame = {"O": 0j, "Q2": complex(*given["Q2"]), "Q3": complex(*given["Q3"])}
    return _pinned(frame, bodies, joints, **assembly)


def _pinned(
    frame: dict[str, complex], bodies: tuple[Link, ...], joints: tuple[tuple[str, int, int], ...], **assembly: Any
) -> Mechanism:
    points = {0: frame} | {body.id: body.points for body in bodies}
    pins = tuple(pin(name, a, b, points[a][name], points[b][name]) for name, a, b in joints)
    return Mechanism(
        Link(0, frame),
        bodies,
        pins,
        Input("O", 10.0, start=0.0),
        grid=Grid(positions=12),
        assembly=Assembly(**assembly),
    )


def loading(given: dict[str, Any], mechanism: Mechanism, triangles: dict[int, tuple[str, ...]]) -> Loading:
    """Masses at the centroids of these points (or midpoints), the moment on link 5, weight."""
    centres = {1: 0j}
    for k in range(2, 6):
        names = triangles.get(k, tuple(mechanism.link(k).points))
        centres[k] = complex(np.mean([mechanism.link(k).points[name] for name in names]))
    bodies = tuple(Body(k, given["m"][k - 1], given["J_S"][k - 1], centres[k]) for k in range(1, 6))
    moment = Load("M5", 5, "moment", Constant(given["M5_ext"]))
    return Loading(bodies, -1j * given["g"], (moment,))
