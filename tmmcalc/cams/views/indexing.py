"""The indexing drive as a page moves it: both cams turn, their rollers lead the wheel from dwell to dwell.

Axes are those of the scheme: O1 at 0, O2 at a on x; the cams turn counter-clockwise, the wheel clockwise. The cam in
front and its row of rollers have one colour, the cam behind and its row another.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmmcalc.cams.files.indexing import chain_of
from tmmcalc.cams.indexing.flanks import Drive
from tmmcalc.cams.indexing.outline import outline
from tmmcalc.cams.indexing.results import Cam, Indexing
from tmmcalc.cams.indexing.solve import drive_of
from tmmcalc.cams.indexing.task import IndexingTask
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.tables.tasks.indexing import to_indexing
from tmmcalc.core.notes import Phrase
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.moving import BLUE, FRAME, ORANGE, Body, Handle, Mark, Reading, Spot, Stop, Track, View, track_of

CHORD = 1e-5  # of the wheel: how far the drawn profiles may be from the true ones
FRONT, BEHIND = BLUE, ORANGE
PER = math.pi / 180  # rates are by degrees


def views(order: Order) -> Iterator[View]:
    """The drive over a turn of its cams, if its law is known."""
    result: Indexing = order.results["indexing"]
    task = to_indexing(order.spec)
    drive = drive_of(task, result.ratio)
    if drive is not None and result.cam is not None:
        yield _view(task, drive, result, result.cam)


def _view(task: IndexingTask, drive: Drive, result: Indexing, cam: Cam) -> View:
    phi, turned = over_turn(task, result)
    count, degrees = len(phi), np.degrees(phi)
    zero, away = (track_of(np.array(value), np.array(0.0), count) for value in (0.0, drive.centres))
    spin = track_of(phi, np.array(PER), count)
    wheel = Track(-turned.values, -turned.rates)
    behind = -1.0 if task.dwells is None else np.exp(-1j * (task.step + task.rests[0]))
    radii = (result.roller or 0.0, (result.roller or 0.0) if result.second is None else result.second.roller)
    profiles = [
        outline("", chain_of(task, result, of_second=second), CHORD * result.wheel).polygon for second in (False, True)
    ]
    rows = [_row(drive, which, radius) for which, radius in enumerate(radii)]
    near = 0.35 * cam.nearest
    bodies = (
        Body("rear cam", zero, zero, spin, _profile(behind * profiles[1], BEHIND)),
        Body("wheel", away, zero, wheel, (*_disc(drive), *rows[1]), "2", (complex(0.45 * drive.wheel),)),
        Body("front cam", zero, zero, spin, _profile(profiles[0], FRONT), "1", (complex(0.55 * result.base),)),
        Body("front rollers", away, zero, wheel, rows[0]),
    )
    reach = max(float(np.abs(profile).max()) for profile in profiles)
    far = drive.wheel + max(radii)
    return View(
        name="indexing",
        title="Indexing drive",
        symbol="φ",
        unit="deg",
        values=degrees,
        whole=True,
        column="phi[deg]",
        steps=(),
        box=(complex(-reach, -max(reach, far)), complex(max(reach, drive.centres + far), max(reach, far))),
        bodies=bodies,
        frame=(),
        spots=(Spot("O1", FRAME, 0j, "pin"), Spot("O2", FRAME, complex(drive.centres), "pin")),
        handle=Handle("front cam", pivot=0j),
        stops=tuple(_stops(task)),
        shown=("indexing.beta", "indexing.beta1", "indexing.beta2", "indexing.vartheta_A", "indexing.vartheta_B"),
        readings=(
            Reading("angle of the wheel", "beta", "deg", Track(np.degrees(turned.values), np.degrees(turned.rates))),
        ),
        seconds=8.0,
        front=(
            Mark("pivot", (0j, -1j)),
            Mark("pivot", (complex(drive.centres), -1j)),
            Mark("sense", (0j, near * np.exp(0.15j * math.pi)), 0.7 * math.pi),
        ),
    )


def over_turn(task: IndexingTask, result: Indexing) -> tuple[Values, Track]:
    """Angles (n,) of the cams over a turn, and the track of the wheel's turn in its own sense [rad, 1/deg]."""
    (first, _), step, pitch = task.rests, result.step, 2 * math.pi / result.rollers
    beta, rate = result.motion[:2]
    second = step + first
    phi = np.concatenate((step * result.k, [step, second], second + step * result.k, [second + step, 2 * math.pi]))
    turned = np.concatenate((beta, [pitch, pitch], pitch + beta, [2 * pitch, 2 * pitch]))
    still = np.zeros(2)
    return phi, Track(turned, PER * np.concatenate((rate, still, rate, still)))


def _profile(points: np.ndarray, tone: int) -> tuple[Mark, ...]:
    return (Mark("gear", tuple(points.tolist()), tone=tone),)


def _places(drive: Drive, row: int) -> list[complex]:
    """Where the rollers of a row are on the wheel at the start of the first step, in its axes."""
    every = drive.half + 4 * drive.half * np.arange(drive.rollers // 2) - 2 * drive.half * row
    places: list[complex] = (-drive.wheel * np.exp(-1j * every)).tolist()
    return places


def _row(drive: Drive, row: int, radius: float) -> tuple[Mark, ...]:
    """The rollers of a row."""
    return tuple(
        Mark("roller" if radius else "dot", (place,), radius, (FRONT, BEHIND)[row]) for place in _places(drive, row)
    )


def _disc(drive: Drive) -> Iterator[Mark]:
    """The circle of the rollers' axes, an arm to each of them."""
    yield Mark("pitch", (0j,), drive.wheel)
    for row in range(2):
        for place in _places(drive, row):
            yield Mark("line", (0j, place))


def _stops(task: IndexingTask) -> Iterator[Stop]:
    """The beginnings of steps and dwells."""
    at = 0.0
    for rest in task.rests:
        yield Stop(Phrase("beginning: {phase}", phase="step of the wheel"), math.degrees(at))
        yield Stop(Phrase("beginning: {phase}", phase="dwell of the wheel"), math.degrees(at + task.step))
        at += task.step + rest
