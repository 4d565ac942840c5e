"""Words for faults in ``[[loads]]``: what a missing key is for, what to write in its lists and tables."""

from tmmcalc.linkage.tables.words.mechanism import FRAME_STANDS

MISSING = {
    "link": ("every load acts on a link", "add link = 5"),
    "indicator.strokes": (
        "an indicator diagram has two or four strokes",
        'add strokes = [{ x = [0, 1], p = ["5 MPa", "0.3 MPa"] }, ...]',
    ),
    "indicator.strokes.x": ("every stroke has its distances from 0 to 1", "add x = [0, 0.5, 1]"),
    "indicator.strokes.p": ("every stroke has its pressures", 'add p = ["5 MPa", "1 MPa", "0.3 MPa"]'),
}

LISTS = {
    "between": ("two angles, from and to", 'between = ["30 deg", "180 deg"]'),
    "positions": ("two positions, from and to", "positions = [2, 12]"),
    "polynomial.force": ("a list of coefficients", "force = [0, 250, -12.5]"),
    "polynomial.moment": ("a list of coefficients", "moment = [0, 25, -1.2]"),
    "table.x": ("a list of two abscissae or more", 'x = ["0 deg", "90 deg", "270 deg"]'),
    "table.force": ("a list of two forces or more", 'force = [0, "1.5 kN", 0]'),
    "table.moment": ("a list of two moments or more", 'moment = [0, "40 N*m", 0]'),
    "indicator.strokes.x": ("a list of two distances or more, from 0 to 1", "x = [0, 0.1, 0.5, 1]"),
    "indicator.strokes.p": ("a list of two pressures or more", 'p = ["5 MPa", "1 MPa", "0.3 MPa"]'),
}

INLINE = {
    "polynomial": "polynomial = { force = [0, 250, -12.5] }",
    "indicator.strokes": 'strokes = [{ x = [0, 1], p = ["5 MPa", "0.3 MPa"] }, ...]',
}

PLACES = ("point",)
ELEMENTS = {"": ("name", 'load "{}"')}
ZEROS = {"link": FRAME_STANDS}
