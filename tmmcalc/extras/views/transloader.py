"""The transloader over the time: the grab is hoisted, then the trolley goes its way along the bridge."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.core.timelaw import TimeLaw, by_travel, motion
from tmmcalc.extras.tables.tasks.transloader import to_transloader
from tmmcalc.extras.transloader import Transloader
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.moving import Body, Mark, Span, Stop, Track, View, seconds_of, track_of

STEPS = 120  # of each way
WIDER = 1.25  # the bridge than the way of the trolley, where its span is not told
HIGHER = 1.4  # the bridge than the height of hoisting
TROLLEY, GRAB = 0.05, 0.04  # of the span: half their width


def views(order: Order) -> Iterator[View]:
    """Both ways one after another, or the one that is given; none without any."""
    result: Transloader = order.results["transloader"]
    laws = {each.what: by_travel(each.length, each.speed, each.acceleration) for each in result.drives}
    if laws:
        yield _view(laws, to_transloader(order.spec).span)


def _view(laws: dict[str, TimeLaw], span: float | None) -> View:
    hoist, trolley = laws.get("hoist"), laws.get("trolley")
    lifted = hoist.duration if hoist is not None else 0.0
    whole = lifted + (trolley.duration if trolley is not None else 0.0)
    t = np.unique(np.concatenate((np.linspace(0.0, lifted, STEPS + 1), np.linspace(lifted, whole, STEPS + 1))))
    way = trolley.travel if trolley is not None else 0.0
    wide = span or WIDER * (way or (hoist.travel if hoist is not None else 0.0))
    lift = hoist.travel if hoist is not None else 0.3 * wide
    high = HIGHER * lift
    x = _way(trolley, t - lifted, (wide - way) / 2)
    y = _way(hoist, t, high - lift - 3 * GRAB * wide if hoist is not None else high - lift)
    still = track_of(0.0, 0.0, len(t))
    a, b = TROLLEY * wide, GRAB * wide
    wheels = (Mark("circle", (each * a + 0.25j * a,), 0.25 * a) for each in (-0.7, 0.7))
    car = Mark("plate", tuple(a * z for z in (-1 + 0.5j, 1 + 0.5j, 0.8 + 1.2j, -0.8 + 1.2j)))
    grab = Mark("plate", tuple(b * z for z in (-0.35 + 0j, 0.35 + 0j, 1 - 1j, 0.6 - 1.8j, -0.6 - 1.8j, -1 - 1j)))
    bridge = track_of(high, 0.0, len(t))
    return View(
        name="transloader",
        title="Transloader",
        symbol="t",
        unit="s",
        values=t,
        whole=False,
        column="",
        steps=(("", 0.0), *([("", lifted)] if 0 < lifted < whole else []), ("", whole)),
        box=(complex(-a, 0.0), complex(wide + a, high + 1.5 * a)),
        bodies=(
            Body("trolley", x, bridge, still, (car, *wheels)),
            Body("grab", x, y, still, (grab,)),
        ),
        frame=(
            Mark("bar", (complex(-a, high), complex(wide + a, high))),
            *(Mark("bar", (complex(at, 0.0), complex(at, high))) for at in (0.0, wide)),
            *(Mark("pivot", (complex(at, 0.0), -1j)) for at in (0.0, wide)),
        ),
        spots=(),
        spans=(Span("rope", (("trolley", 0.5j * a), ("grab", 0j))),),
        seconds=seconds_of(whole),
        stops=(Stop("the trolley starts", lifted),) if len(laws) > 1 else (),
    )


def _way(law: TimeLaw | None, t: Real, start: float) -> Track:
    """A way from where it starts, at rest before and after."""
    if law is None:
        return track_of(start, 0.0, len(t))
    s, v, _ = motion(law, t)
    return Track(start + s, v)
