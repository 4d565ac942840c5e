"""What a page moves of the small calculators: the transloader by the speeds and times of its stage."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tmmcalc.extras.views.transloader import views
from tmmcalc.pipeline.picturing import order_of
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec

CONFIG = Path(__file__).parents[2] / "configs" / "extra-transloader.toml"


def test_the_grab_is_hoisted_and_the_trolley_goes_its_way() -> None:
    spec = load_spec(CONFIG)
    found = run(spec, target=["transloader"]).results
    (view,) = views(order_of(spec, found))
    drives = {each.what: each for each in found["transloader"].drives}
    trolley, grab = view.bodies
    assert np.ptp(grab.y.values) == pytest.approx(drives["hoist"].length)
    assert np.ptp(trolley.x.values) == pytest.approx(drives["trolley"].length)
    assert view.values[-1] == pytest.approx(drives["hoist"].time + drives["trolley"].time)
    assert grab.y.rates.max() == pytest.approx(drives["hoist"].speed)
    assert trolley.x.rates.max() == pytest.approx(drives["trolley"].speed)
    assert trolley.x is grab.x
    low, high = view.box
    assert low.real < trolley.x.values.min()
    assert trolley.x.values.max() < high.real
    (stop,) = view.stops
    assert stop.at == pytest.approx(drives["hoist"].time)


@pytest.mark.parametrize("gone", ["trolley", "hoist"])
def test_one_way_alone(gone: str) -> None:
    text = CONFIG.read_text()
    spec = load_spec(CONFIG)
    assert f"[transloader.{gone}]" in text
    table = spec.transloader.model_copy(update={gone: None, "inertia": None, "parts": []})
    alone = spec.model_copy(update={"transloader": table})
    (view,) = views(order_of(alone, run(alone, target=["transloader"]).results))
    still = view.bodies[0].x if gone == "trolley" else view.bodies[1].y
    assert np.ptp(still.values) == 0
    assert not view.stops
