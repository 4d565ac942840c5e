"""The ratio of a planetary train is that of its teeth, without the 1 (textbook 4.19)."""

from __future__ import annotations

from copy import deepcopy

from tmmcalc.core.mistake import OFTEN, Document, Mistake, Tables

PLANETARY = {"i_1H": "u", None: "u"}


def _tables(document: Document, part: str) -> Tables:
    train = deepcopy(document.get("train", {}))
    if not isinstance(train.get("layout"), str) or train.get("ratio_kind") not in PLANETARY or not _planetary(train):
        return {}
    return {"train": {**train, "ratio_kind": "u"}}


def _planetary(train: Tables) -> bool:
    from tmmcalc.gears.kinds import kinds_of
    from tmmcalc.gears.layouts import LAYOUTS

    return train["layout"] in LAYOUTS and "i_1H" in kinds_of(LAYOUTS[train["layout"]])


MISTAKE = Mistake(
    "the teeth of a planetary train are chosen by the ratio itself, without the 1",
    "How does the ratio of a train whose carrier turns follow from the numbers of teeth?",
    OFTEN,
    tables=_tables,
)
