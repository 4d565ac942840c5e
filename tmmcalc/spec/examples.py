"""What keys are for, and examples of what to write: the facts from which faults are worded, by dotted name."""

# What a missing key is for, and what to write. A test holds this against the required fields of the tables.
MISSING = {
    "mechanism": (
        "a spec describes a mechanism",
        "add [mechanism.input], [[mechanism.links]] and [[mechanism.joints]]",
    ),
    "mechanism.input": (
        "every mechanism needs an input",
        'add [mechanism.input] with joint = "O" and speed = "55 rpm"',
    ),
    "mechanism.input.joint": ("the input is named by its joint with the frame", 'add joint = "O"'),
    "mechanism.input.speed": ("the input needs its mean speed", 'add speed = "55 rpm"'),
    "mechanism.links": ("every mechanism needs links", "add [[mechanism.links]], one for each moving link"),
    "mechanism.links.id": ("every link needs its number", "add id = 1 (2, 3, ...); 0 is the frame"),
    "mechanism.joints": (
        "every mechanism needs joints",
        "add [[mechanism.joints]], one for each pair of links",
    ),
    "mechanism.joints.name": ("every joint needs a name", 'add name = "A"'),
    "mechanism.joints.kind": ("every joint needs a kind", 'add kind = "revolute" or kind = "prismatic"'),
    "mechanism.joints.links": ("every joint needs its two links", "add links = [0, 1]; 0 is the frame"),
    "mechanism.joints.guide": (
        "every prismatic joint needs the line of its guide",
        'add guide = { through = "B", angle = "0 deg" }, in the axes of the second of links',
    ),
    "mechanism.joints.guide.through": (
        "the line runs through a point",
        'add through = "B" or through = [x, y]',
    ),
    "loads.link": ("every load acts on a link", "add link = 5"),
    "loads.indicator.strokes": (
        "an indicator diagram has two or four strokes",
        'add strokes = [{ x = [0, 1], p = ["5 MPa", "0.3 MPa"] }, ...]',
    ),
    "loads.indicator.strokes.x": ("every stroke has its distances from 0 to 1", "add x = [0, 0.5, 1]"),
    "loads.indicator.strokes.p": ("every stroke has its pressures", 'add p = ["5 MPa", "1 MPa", "0.3 MPa"]'),
    "springs.links": ("every spring connects two links", "add links = [2, 0]; 0 is the frame"),
    "motor.table.speed": ("a characteristic has its speeds", 'add speed = ["0 rpm", "1400 rpm", "1500 rpm"]'),
    "motor.table.moment": ("a characteristic has its moments", 'add moment = ["15 N*m", "7.5 N*m", 0]'),
}

ARRAYS_OF_TABLES = (
    "mechanism.links",
    "mechanism.joints",
    "mechanism.outputs",
    "loads",
    "springs",
    "loads.indicator.strokes",
)

# Lists that are not points: what they hold, and an example.
LISTS = {
    "mechanism.grid.extra": ("a list of input coordinates", 'extra = ["30 deg", "200 deg"]'),
    "mechanism.joints.links": ("two link numbers", "links = [0, 1]"),
    "mechanism.joints.points": ("the names of the pin on the two links", 'points = ["A", "A2"]'),
    "loads.between": ("two angles, from and to", 'between = ["30 deg", "180 deg"]'),
    "loads.positions": ("two positions, from and to", "positions = [2, 12]"),
    "loads.polynomial.force": ("a list of coefficients", "force = [0, 250, -12.5]"),
    "loads.polynomial.moment": ("a list of coefficients", "moment = [0, 25, -1.2]"),
    "loads.table.x": ("a list of two abscissae or more", 'x = ["0 deg", "90 deg", "270 deg"]'),
    "loads.table.force": ("a list of two forces or more", 'force = [0, "1.5 kN", 0]'),
    "loads.table.moment": ("a list of two moments or more", 'moment = [0, "40 N*m", 0]'),
    "loads.indicator.strokes.x": ("a list of two distances or more, from 0 to 1", "x = [0, 0.1, 0.5, 1]"),
    "loads.indicator.strokes.p": ("a list of two pressures or more", 'p = ["5 MPa", "1 MPa", "0.3 MPa"]'),
    "springs.links": ("two link numbers", "links = [2, 0]"),
    "springs.points": ("the ends of the spring on the two links", 'points = ["B", [0.1, 0.2]]'),
    "motor.table.speed": ("a list of two speeds or more", 'speed = ["0 rpm", "1400 rpm", "1500 rpm"]'),
    "motor.table.moment": ("a list of two moments or more", 'moment = ["15 N*m", "7.5 N*m", 0]'),
}

# Tables that are written in one line.
INLINE = {
    "mechanism.joints.guide": 'guide = { through = "B", angle = "0 deg" }',
    "mechanism.joints.slider": 'slider = { through = "B", angle = "0 deg" }',
    "loads.polynomial": "polynomial = { force = [0, 250, -12.5] }",
    "loads.indicator.strokes": 'strokes = [{ x = [0, 1], p = ["5 MPa", "0.3 MPa"] }, ...]',
    "motor.table": 'table = { speed = ["0 rpm", "1500 rpm"], moment = ["15 N*m", 0] }',
}
