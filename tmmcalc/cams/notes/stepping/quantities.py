"""The quantities of an indexing drive by their names in formulas; lengths in mm, angles in degrees.

Those of a flank have its letter for an index, ``theta_A``; ``<f>`` stands for it in formulas of either flank.
"""

from __future__ import annotations

from math import degrees
from typing import NamedTuple

import numpy as np

from tmmcalc.cams.indexing.flanks import Drive, Flank, FlankName
from tmmcalc.cams.indexing.results import FlankTable, Indexing
from tmmcalc.cams.indexing.solve import drive_of, flank_table
from tmmcalc.cams.indexing.task import IndexingTask
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.language import tr
from tmmcalc.report.manuscript import Lexicon, Place
from tmmcalc.report.telling import named

MM = 1e3
FLANKS: tuple[FlankName, ...] = ("A", "B")


class Stepping(NamedTuple):
    """A drive with what is told of it; ``drive`` is None where the law is known by its B alone."""

    task: IndexingTask
    found: Indexing
    drive: Drive | None
    lexicon: Lexicon

    @property
    def place(self) -> tuple[Place, ...]:
        """Where formulas hold that are the same all over the step."""
        return (Place("", self.lexicon),)


def stepping_of(task: IndexingTask, found: Indexing) -> Stepping:
    """The drive with the quantities that are the same all over the step."""
    return Stepping(task, found, drive_of(task, found.ratio), named(_given(task, found) | _sizes(found)))


def _given(task: IndexingTask, found: Indexing) -> Lexicon:
    """What the task says, or leaves to be chosen."""
    quantities = {
        "z_2": Given(float(found.rollers), "", tr("number of rollers, half of them in each row")),
        "phi_p": Given(degrees(found.step), "deg", tr("angle of the cams during a step")),
        "l_k": Given(MM * found.wheel, "mm", tr("radius of the wheel to the axes of its rollers")),
        "a": Given(MM * found.centres, "mm", tr("centre distance")),
        "lambda": Given(found.ratio, "", tr("centre distance over the radius of the wheel")),
        "B": Given(found.peak, "", tr("largest derivative of the law by the part of the step")),
        "theta_d": Given(degrees(found.limit), "deg", tr("permissible pressure angle")),
        "f_1": Given(found.first_friction, "", tr("coefficient of friction of the rollers on the cams")),
        "f_2": Given(found.second_friction, "", tr("coefficient of friction of the rollers on their pins")),
        "r_c": Given(MM * task.shaft, "mm", tr("radius of the camshaft")),
    }
    if found.roller is not None:
        quantities["r_r"] = Given(MM * found.roller, "mm", tr("radius of the rollers"))
    if found.second is not None and not found.second.turned_over:
        quantities["r_r2"] = Given(MM * found.second.roller, "mm", tr("radius of the rollers of the second row"))
    if found.dwells is None:
        return quantities | {"phi_d": Given(degrees(found.dwell), "deg", tr("angle of the cams during each dwell"))}
    said = (tr("angle of the cams during the first dwell"), tr("angle of the cams during the second dwell"))
    for k, (rest, meaning) in enumerate(zip(found.dwells, said, strict=True), 1):
        quantities[f"phi_d{k}"] = Given(degrees(rest), "deg", meaning)
    return quantities


def _sizes(found: Indexing) -> Lexicon:
    """What follows for all of the step."""
    limits = found.bounds
    quantities = {
        "beta_m": Given(found.pitch, "deg", tr("angle of the wheel in a step")),
        "beta_0": Given(found.pitch / 2, "deg", tr("angle of a roller from the line of centres in a dwell")),
        "lambda_min": Given(limits.ratio_min, "", tr("least ratio, below which the groove crosses itself")),
        "a_min": Given(MM * found.least_centres, "mm", tr("least centre distance")),
        "phi_pmin": Given(degrees(found.step_min), "deg", tr("least angle of the step")),
        "phi_pmax": Given(degrees(found.step_max), "deg", tr("largest recommended angle of the step")),
        "R_0": Given(MM * found.base, "mm", tr("radius of the pitch curve in the dwells")),
        "delta_0": Given(
            degrees(found.start_angle), "deg", tr("polar angle of a roller about the axis of the cams in a dwell")
        ),
        "vartheta_1m": Given(degrees(found.start_pressure), "deg", tr("pressure angle at the start of the step")),
    }
    if limits.ratio_max is not None:
        quantities["lambda_max"] = Given(
            limits.ratio_max, "", tr("largest ratio, by the pressure angle at the start of the step")
        )
    return quantities


def at_row(of: Stepping, row: int) -> Lexicon:
    """All quantities at a row of the tables."""
    assert of.found.cam is not None
    return _moving(of, float(of.found.k[row]), of.found.motion[:, row], (of.found.cam.a, of.found.cam.b), row)


def at_part(of: Stepping, part: float) -> Lexicon:
    """All quantities at a part k of the step."""
    assert of.drive is not None
    k = np.array([part])
    flanks = [Flank(of.drive, name) for name in FLANKS]
    tables = [flank_table(flank, k, of.found.roller or 0.0) for flank in flanks]
    return _moving(of, part, flanks[0].motion(k)[:, 0], (tables[0], tables[1]), 0)


def _moving(of: Stepping, part: float, motion: np.ndarray, tables: tuple[FlankTable, FlankTable], row: int) -> Lexicon:
    assert of.drive is not None
    s, s1, s2 = of.drive.law.at(np.array([part]))[:3, 0].tolist()
    quantities = {
        "k": Given(part, "", tr("part of the step")),
        "s": Given(s, "", tr("law of the step: turn of the wheel over its turn in the whole step")),
        "s'": Given(s1, "", tr("derivative of the law by the part of the step")),
        "s''": Given(s2, "", tr("second derivative of the law by the part of the step")),
        "phi": Given(degrees(of.drive.step * part), "deg", tr("angle of the cams from the start of the step")),
        "beta": Given(degrees(motion[0]), "deg", tr("angle of the wheel from the start of the step")),
        "beta'": Given(float(motion[1]), "", tr("derivative of the angle of the wheel by that of the cams")),
        "beta''": Given(float(motion[2]), "", tr("second derivative of the angle of the wheel by that of the cams")),
    }
    for table in tables:
        quantities |= _flank(of.drive, table, part, row)
    return of.lexicon | named(quantities)


def _flank(drive: Drive, table: FlankTable, part: float, row: int) -> Lexicon:
    """What a flank adds; without a radius of curvature where it is straight or comes to a point."""
    name, k = table.name, np.array([part])
    flank = Flank(drive, FLANKS[FLANKS.index(name)])
    speed, rates, normal = float(flank.frame(k).speed[0]), flank.rates(k)[0] / drive.step, flank.rise(k)[0]
    return {
        f"theta_{name}": Given(
            degrees(table.theta[row]),
            "deg",
            tr("angle of the roller of flank {flank} on the wheel from the line of centres", flank=name),
        ),
        f"R_{name}": Given(MM * float(table.radius[row]), "mm", tr("distance of its axis from that of the cams")),
        f"psi_{name}": Given(degrees(flank.polar(k)[0]), "deg", tr("polar angle of its axis about that of the cams")),
        f"delta_{name}": Given(degrees(table.polar[row]), "deg", tr("the same in the axes of the cam")),
        f"x_{name}": Given(MM * float(table.x[row]), "mm", tr("pitch curve in the axes of the cam")),
        f"y_{name}": Given(MM * float(table.y[row]), "mm", tr("pitch curve in the axes of the cam")),
        f"x'_{name}": Given(MM * rates.real, "mm", tr("derivatives of these coordinates by the angle of the cams")),
        f"y'_{name}": Given(MM * rates.imag, "mm", tr("derivatives of these coordinates by the angle of the cams")),
        f"v_{name}": Given(MM * speed, "mm", tr("length of the vector of these derivatives")),
        f"x_w{name}": Given(MM * float(table.working_x[row]), "mm", tr("working profile in the axes of the cam")),
        f"y_w{name}": Given(MM * float(table.working_y[row]), "mm", tr("working profile in the axes of the cam")),
        f"vartheta_{name}": Given(
            degrees(table.pressure[row]), "deg", tr("pressure angle of flank {flank}", flank=name)
        ),
        f"D_{name}": Given(
            MM**2 * speed**3 * float(table.curvature[row]),
            "mm^2",
            tr("denominator of the radius of curvature of its pitch curve"),
        ),
        f"rho_{name}": Given(
            MM * float(table.bend[row]),
            "mm",
            tr("radius of curvature of its pitch curve, negative where it is concave"),
        ),
        f"n_x{name}": Given(
            MM**2 * normal.real,
            "mm^2",
            tr("normal along the line from the axis of the cams to the roller and across it, scaled"),
        ),
        f"n_y{name}": Given(
            MM**2 * normal.imag,
            "mm^2",
            tr("normal along the line from the axis of the cams to the roller and across it, scaled"),
        ),
        f"sigma_{name}": Given(
            degrees(flank.rise_angle(k)[0]),
            "deg",
            tr("acute angle of the normal and the line from the axis of the cams to the roller"),
        ),
    }
