"""Words for faults in ``[balance]``: what a missing key is for, what to write in its lists and tables."""

from tmmcalc.linkage.tables.words.mechanism import FRAME_STANDS

MISSING = {
    "counterweights.link": ("a counterweight is on a link", "add link = 1"),
    "add.order": ("a rotating weight turns with some multiple of the crank's speed", "add order = -1"),
    "add.mass": ("a rotating weight has its mass", 'add mass = "2 kg"'),
    "add.radius": ("a rotating weight has its radius", 'add radius = "60 mm"'),
}

LISTS = {
    "schemes": ("a list of schemes", 'schemes = ["least squares", "minimax"]'),
}

INLINE = {
    "counterweights": 'counterweights = [{ link = 1, radius = "60 mm" }]',
    "add": 'add = [{ order = -1, mass = "2 kg", radius = "60 mm" }]',
}

PLACES = ("point",)
ZEROS = {"counterweights.link": FRAME_STANDS}
