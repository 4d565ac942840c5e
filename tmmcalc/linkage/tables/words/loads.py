"""Words for faults in ``[[loads]]``: what a missing key is for, what to write in its lists and tables."""

from tmmcalc.linkage.loadlaws import laws
from tmmcalc.linkage.tables.words.mechanism import FRAME_STANDS

MISSING = {"link": ("every load acts on a link", "add link = 5")}
LISTS = {
    "between": ("two angles, from and to", 'between = ["30 deg", "180 deg"]'),
    "positions": ("two positions, from and to", "positions = [2, 12]"),
}
INLINE: dict[str, str] = {}
for law in laws().values():
    MISSING |= law.missing
    LISTS |= law.lists
    INLINE |= law.inline

PLACES = ("point",)
ELEMENTS = {"": ("name", 'load "{}"')}
ZEROS = {"link": FRAME_STANDS}
