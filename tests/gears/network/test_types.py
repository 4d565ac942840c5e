"""Planetary types: GT-S11, limits of self-locking, choice, curves, friction of teeth."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gears.network.trains import EXAMPLES
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.losses import SLIDING, mesh_efficiency
from tmmcalc.gears.network import types
from tmmcalc.gears.network.choice import proposals
from tmmcalc.gears.network.curves import efficiency_over_ratio, efficiency_over_reduction, ratio_over_inverted
from tmmcalc.gears.scheme import layout_of

FILE = Path(__file__).parents[2] / "cases" / "gear-trains.json"
CASE = next(case for case in json.loads(FILE.read_text()) if case["id"] == "GT-S11")


class TestCase:
    """GT-S11, all items at once."""

    i = np.array([item["i_1H"] for item in CASE["inputs"]["items"]])
    eta0 = np.array([item["eta0"] for item in CASE["inputs"]["items"]])

    @staticmethod
    def expected(key: str) -> list[float]:
        return [item[key] for item in CASE["expected"]["items"]]

    def test_ratio(self) -> None:
        np.testing.assert_allclose(
            types.inverted_ratio(self.i), self.expected("i13_H"), atol=CASE["tolerance"]["i13_H"]
        )

    @pytest.mark.parametrize(("driver", "key"), [("1", "wheel1"), ("H", "carrier")])
    def test_efficiency(self, driver: types.Driver, key: str) -> None:
        eta = types.efficiency(self.i, self.eta0, driver)
        np.testing.assert_allclose(eta, self.expected(f"eta_{key}_driving"), atol=CASE["tolerance"]["eta"])
        locks = types.self_locking(self.i, self.eta0, driver)
        assert locks.tolist() == self.expected(f"self_locking_{key}")


class TestFormulas:
    @EXAMPLES
    @given(st.floats(-30, 30).filter(lambda i: abs(i) > 1e-3), st.floats(0.05, 1.0))
    def test_as_printed(self, i: float, eta0: float) -> None:
        """Table 4.6 as it stands, and self-locking as its zero."""
        slow = 0 < i < 1
        wheel = (1 - (1 - i) / eta0) / i if slow else (1 - eta0 * (1 - i)) / i
        carrier = i / (1 - eta0 * (1 - i)) if slow else i / (1 - (1 - i) / eta0)
        slack = 1e-15 / abs(i) / eta0
        assert types.efficiency(i, eta0) == pytest.approx(wheel, rel=1e-12, abs=4 * slack)
        assert types.efficiency(i, eta0, "H") == pytest.approx(carrier, rel=1e-12 + 8 * slack)
        assert not types.self_locking(i, eta0, "H")
        if abs(wheel) > 1e-9:
            assert types.self_locking(i, eta0) == (wheel < 0)

    def test_borders(self) -> None:
        """Both ends of the self-locking interval belong to it."""
        ends = np.array([-0.25, 0.2])
        assert types.self_locking(ends, 0.8).all()
        assert types.efficiency(ends, 0.8) == pytest.approx([0, 0], abs=1e-15)
        assert not types.self_locking(np.array([-0.2501, 0.2001]), 0.8).any()

    def test_special(self) -> None:
        assert types.efficiency(1.0, 0.9).item() == 1
        assert types.efficiency(1.0, 0.9, "H") == pytest.approx(1, rel=1e-15)
        # no losses: no cancellation however small the ratio
        assert types.efficiency(1e-14, 1.0, "H").item() == 1
        assert types.efficiency(np.ones((2, 1)), np.full(3, 0.9)).shape == (2, 3)

    def test_ratio_and_back(self) -> None:
        for layout, i in (("AI", 31.29), ("AIbar", 7.29), ("AA", -7.15), ("II", 0.05)):
            u = types.tooth_ratio(layout, i)
            assert u > 0
            assert 1 + layout_of(layout).sign * u == pytest.approx(i)

    @pytest.mark.parametrize(
        ("call", "error", "match"),
        [
            (lambda: types.efficiency([2.0, 0.0], 0.9), NoSolutionError, "i_1H is 0: one of"),
            (lambda: types.efficiency(np.nan, 0.9), NoSolutionError, "i_1H is nan"),
            (lambda: types.efficiency(2.0, [0.9, 0.0]), UsageError, "inverted train is 0"),
            (lambda: types.efficiency(2.0, 1.1), UsageError, "inverted train is 1.1"),
            (lambda: types.efficiency(2.0, 0.9, "3"), UsageError, "driver is '3'"),
            (lambda: types.tooth_ratio("AII", 2.0), UsageError, "not 1 \\+ U or 1 - U"),
            (lambda: proposals(0.0), UsageError, "required ratio is 0"),
        ],
    )
    def test_faults(self, call: object, error: type[Exception], match: str) -> None:
        with pytest.raises(error, match=match):
            call()


class TestChoice:
    @staticmethod
    def layouts(required: float, **options: object) -> list[tuple[str, str]]:
        return [(p.layout, p.driver) for p in proposals(required, **options) if p.admissible]

    def test_power(self) -> None:
        assert self.layouts(7.29) == [("AIbar", "1"), ("AI", "1"), ("2A-AA", "1"), ("AII", "1")]
        # 30.29 is above what three single planets allow
        assert self.layouts(31.29) == [("AI", "1"), ("AII", "1")]
        assert self.layouts(31.29, planets=2)[0] == ("AIbar", "1")
        # a multiplier: the carrier drives
        assert self.layouts(1 / 7.29)[:2] == [("AIbar", "H"), ("AI", "H")]

    def test_no_internal_wheels(self) -> None:
        assert self.layouts(-7.15, internal=False) == [("AA", "1")]
        assert self.layouts(7.29, internal=False) == [("2A-AA", "1")]

    def test_kinematic(self) -> None:
        assert self.layouts(1000.0, power=False) == [("AI", "1"), ("AA", "H"), ("II", "H")]
        assert ("AA", "H") not in self.layouts(100.0)

    def test_reasons(self) -> None:
        found = {(p.layout, p.driver): p for p in proposals(0.05, internal=False)}
        assert not any(p.admissible for p in found.values())
        assert found["AA", "1"].remark == "locks itself"
        assert found["AI", "H"].remark == "needs internal wheels"
        remarks = {(p.layout, p.driver): p.remark for p in proposals(-7.15)}
        assert "only where internal wheels cannot be cut" in remarks["AA", "1"]
        assert "U = 0.8" in {p.layout: p.remark for p in proposals(1.8)}["AIbar"]

    @EXAMPLES
    @given(st.floats(-60, 60).filter(lambda r: abs(r) > 0.01), st.booleans(), st.booleans())
    def test_consistent(self, required: float, power: bool, internal: bool) -> None:
        for p in proposals(required, power, internal, 0.94):
            if p.i_1h is None or p.tooth_ratio is None:
                assert p.layout == "AII"
                continue
            assert (p.i_1h if p.driver == "1" else 1 / p.i_1h) == pytest.approx(required)
            assert 1 + layout_of(p.layout).sign * p.tooth_ratio == pytest.approx(p.i_1h, abs=1e-12)
            eta0 = 0.94**1.5 if p.layout == "2A-AA" else 0.94
            assert p.efficiency == types.efficiency(p.i_1h, eta0, p.driver)
            assert p.self_locking == bool(types.self_locking(p.i_1h, eta0, p.driver))
            assert not (p.admissible and p.self_locking)
            if power and p.admissible:
                assert p.i_1h > 1 or (not internal and p.i_1h < -1)


class TestCurves:
    def test_over_ratio(self) -> None:
        left, middle, right = efficiency_over_ratio(0.9, lowest=-1.0)
        assert left.x[0] == -20
        assert left.y[-1] == pytest.approx(-1.0)
        assert middle.y[0] == pytest.approx(-1.0)
        assert middle.y[-1] == right.y[0] == 1
        assert right.y[-1] == pytest.approx(0.905)
        assert (np.diff(left.y) < 0).all()
        assert (np.diff(middle.y) > 0).all()
        assert (np.diff(right.y) < 0).all()

    def test_over_reduction(self) -> None:
        slow, back = efficiency_over_reduction(0.9, 50.0)
        r = slow.x
        np.testing.assert_allclose(slow.y, 1 / (0.9 + 0.1 * r), rtol=1e-13)
        np.testing.assert_allclose(back.y, 0.9 / (1 + 0.1 * r), rtol=1e-13)

    def test_ratio(self) -> None:
        line, left, right = ratio_over_inverted(-6.0, 4.0, 25.0)
        np.testing.assert_allclose(line.x + line.y, 1)
        assert left.y[-1] == pytest.approx(25)
        assert right.y[0] == pytest.approx(25)
        assert right.y[-1] == pytest.approx(1 / 3)

    def test_no_losses(self) -> None:
        for curve in (*efficiency_over_ratio(1.0), *efficiency_over_reduction(1.0)):
            np.testing.assert_allclose(curve.y, 1, rtol=1e-15)

    def test_faults(self) -> None:
        with pytest.raises(UsageError, match="limits 2 to 20"):
            efficiency_over_ratio(0.9, low=2.0)
        with pytest.raises(UsageError, match="largest ratio is 1"):
            efficiency_over_reduction(0.9, 1.0)
        with pytest.raises(UsageError, match="both sides of 1"):
            ratio_over_inverted(2.0, 8.0)


class TestFriction:
    @pytest.mark.parametrize(("z1", "z2"), [(17, 50), (20, 20), (25, 100), (40, 60)])
    def test_sliding(self, z1: int, z2: int) -> None:
        """Sliding work along the path of contact, pairs in contact sharing the load equally (rack of 20 degrees)."""
        alpha = math.radians(20)
        e1, e2 = (
            z / (2 * math.pi) * (math.tan(math.acos(z * math.cos(alpha) / (z + 2))) - math.tan(alpha)) for z in (z1, z2)
        )
        x = np.linspace(-e1, e2, 200_001)  # in base pitches from the pitch point
        pairs = 1 + (x > 1 - e1).astype(int) + (x < e2 - 1)
        work = np.mean(np.abs(x) / pairs) * (e1 + e2)
        exact = 2 * math.pi * (1 / z1 + 1 / z2) * work
        assert (1 - mesh_efficiency(z1, z2, friction=0.1)) / 0.1 == pytest.approx(exact, rel=0.12)

    def test_signs(self) -> None:
        eta = mesh_efficiency([20, 20], 60, [-1, 1], 0.1)
        np.testing.assert_allclose(1 - eta, 0.1 * SLIDING * np.array([1 / 15, 1 / 30]))
        with pytest.raises(UsageError, match=r"takes 1\.15 of"):
            mesh_efficiency(5, 20, friction=2.0)
