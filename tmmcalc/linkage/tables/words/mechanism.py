"""Words for faults in ``[mechanism]``: what a missing key is for, what to write in its lists and tables."""

BEGIN = "[mechanism.input], [[mechanism.links]], [[mechanism.joints]]"

MISSING = {
    "input": (
        "every mechanism needs an input",
        'add [mechanism.input] with joint = "O" and speed = "55 rpm"',
    ),
    "input.joint": ("the input is named by its joint with the frame", 'add joint = "O"'),
    "links": ("every mechanism needs links", "add [[mechanism.links]], one for each moving link"),
    "links.id": ("every link needs its number", "add id = 1 (2, 3, ...); 0 is the frame"),
    "joints": (
        "every mechanism needs joints",
        "add [[mechanism.joints]], one for each pair of links",
    ),
    "joints.name": ("every joint needs a name", 'add name = "A"'),
    "joints.kind": ("every joint needs a kind", 'add kind = "revolute" or kind = "prismatic"'),
    "joints.links": ("every joint needs its two links", "add links = [0, 1]; 0 is the frame"),
    "joints.guide": (
        "every prismatic joint needs the line of its guide",
        'add guide = { through = "B", angle = "0 deg" }, in the axes of the second of links',
    ),
    "joints.guide.through": (
        "the line runs through a point",
        'add through = "B" or through = [x, y]',
    ),
}

LISTS = {
    "grid.extra": ("a list of input coordinates", 'extra = ["30 deg", "200 deg"]'),
    "joints.links": ("two link numbers", "links = [0, 1]"),
    "joints.points": ("the names of the pin on the two links", 'points = ["A", "A2"]'),
}

INLINE = {
    "joints.guide": 'guide = { through = "B", angle = "0 deg" }',
    "joints.slider": 'slider = { through = "B", angle = "0 deg" }',
    "fixed": "points by name: A = [x, y]",
    "links.points": "points by name: A = [x, y]",
    "assembly.sketch": "points by name: A = [x, y]",
}

PLACES = ("joints.guide.through", "joints.slider.through")
ELEMENTS = {"links": ("id", "link {}"), "joints": ("name", 'joint "{}"')}
LENGTHS = {"joints.links": "a joint connects two links"}

FRAME_STANDS = ("link 0 is the frame and does not move", "name a moving link")
ZEROS = {
    "links.id": ("0 is the frame, not a moving link", "its points stand in [mechanism.fixed]; count from 1"),
    "outputs.link": FRAME_STANDS,
}

KINDS = {
    "joints": ("a kind of joint", 'write kind = "revolute" (a pin) or kind = "prismatic" (a slider and its guide)'),
}
_LINES = 'its lines are guide = { through = "B" } and, where it needs one, slider = { through = "A" }'
FOREIGN = {
    "joints": {
        "revolute": {
            "guide": ("a revolute joint has no guide", 'remove guide, or write kind = "prismatic"'),
            "slider": ("a revolute joint has no slider", 'remove slider, or write kind = "prismatic"'),
            "length": ("a revolute joint has no length", "its size is the radius of the pin: radius"),
        },
        "prismatic": {
            "radius": (
                "a prismatic joint has no radius",
                "its size is the length of the slider along the guide: length",
            ),
            "point": ("a prismatic joint has no point", _LINES),
            "points": ("a prismatic joint has no points", _LINES),
        },
    },
}
