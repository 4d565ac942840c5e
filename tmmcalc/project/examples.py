"""Examples of what to write where a fault is: the lists, the tables in one line, the arrays, by dotted name."""

# Of the joints of a manipulator: an example of a coordinate, and a larger one.
JOINTS = {"psi": "-30 deg", "phi_2": "10 deg", "phi_3": "-60 deg", "l_3": "0.6 m", "h": "0.2 m", "r": "0.5 m"}
_HIGHEST = ("90 deg", "70 deg", "20 deg", "1.2 m", "0.9 m", "1.1 m")
_PLACES = ("start", "end", "via")  # of its path

# Of the parameters that are sought for a six-bar with a dwell.
_RANGES = {
    "phi12_part": "[0.4, 0.6]",
    "psi0": '["18 deg", "162 deg"]',
    "psi13": '["-162 deg", "-18 deg"]',
    "psi12_part": "[0.4, 0.6]",
    "CB": "[0.1, 1.5]",
    "CD": "[0.1, 1.5]",
    "alpha": '["18 deg", "354 deg"]',
    "n": "[0.2, 0.8]",
}

ARRAYS_OF_TABLES = (
    "mechanism.links",
    "mechanism.joints",
    "mechanism.outputs",
    "loads",
    "springs",
    "loads.indicator.strokes",
    "torque.harmonics.terms",
    "shafts",
    "transients",
    "transients.load_steps",
    "balance.counterweights",
    "balance.add",
    "engine.cylinders",
    "rotor.unbalances",
    "gearing.members",
    "gearing.meshes",
    "pair.meshes",
    "manipulator.obstacles",
    "constraints",
)

_LAWS = ("cam.law", "cam.rise_law", "cam.return_law", "indexing.law")

# Lists that are not points: what they hold, and an example; with brackets, the lists that are elements of a list.
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
    "torque.pieces": ("a list of two points or more", 'pieces = [["0 deg", "100 N*m"], ["90 deg", "-50 N*m"]]'),
    "torque.pieces[]": ("an angle and a moment", '["90 deg", "100 N*m"]'),
    "torque.table.theta": ("a list of two angles or more", 'theta = ["0 deg", "90 deg", "270 deg"]'),
    "torque.table.moment": ("a list of two moments or more", 'moment = [0, "40 N*m", 0]'),
    "torque.delays": ("a list of angles", 'delays = ["0 deg", "180 deg"]'),
    "transients.motor_on": ("a list of intervals of time", 'motor_on = [["0 s", "2 s"]]'),
    "transients.motor_on[]": ("two times, on and off", '["0 s", "2 s"]'),
    "transients.targets": ("a list of speeds", 'targets = ["500 rpm"]'),
    "balance.schemes": ("a list of schemes", 'schemes = ["least squares", "minimax"]'),
    "engine.firing_order": ("a list of cylinder numbers", "firing_order = [1, 3, 4, 2]"),
    "engine.throws": ("a list of angles", 'throws = ["0 deg", "180 deg", "180 deg", "0 deg"]'),
    "engine.orders": ("a list of orders", "orders = [1, 2, 4, 6]"),
    "rotor.bearings": ("the places of the two bearings", 'bearings = [0, "400 mm"]'),
    "rotor.planes": ("the places of the two correction planes", 'planes = ["50 mm", "350 mm"]'),
    "gearing.teeth": ("a list of numbers of teeth", "teeth = [22, 118, 17, 97]"),
    "gearing.locked": ("a list of pairs of members", 'locked = [["sun", "H"]]'),
    "synthesis.path.points": ("a list of two points or more", 'points = [[0, 0], ["20 mm", "15 mm"]]'),
    "synthesis.path.timing": ("a list of angles", 'timing = ["0 deg", "30 deg", "60 deg"]'),
    "synthesis.motion.points": ("a list of two points or more", 'points = [[0, 0], ["20 mm", "15 mm"]]'),
    "synthesis.motion.angles": ("a list of two angles or more", 'angles = ["0 deg", "30 deg"]'),
    **{
        f"synthesis.{kind}.region": ("two corners", 'region = [["-100 mm", "-100 mm"], ["200 mm", "100 mm"]]')
        for kind in ("path", "motion")
    },
    "synthesis.function.range": ("the two ends of an interval", "range = [1, 2]"),
    "synthesis.function.table": ("a list of three pairs or more", "table = [[0, 0], [0.5, 0.25], [1, 1]]"),
    "synthesis.function.table[]": ("an abscissa and a value", "[0.5, 0.25]"),
    "synthesis.function.inputs": ("a list of angles", 'inputs = ["0 deg", "30 deg", "60 deg"]'),
    "synthesis.function.outputs": ("a list of outputs", 'outputs = ["0 deg", "20 deg", "50 deg"]'),
    "synthesis.dwell.pivot": ("two coordinates", "pivot = [-0.6, 0.8], parts of l_OB"),
    **{
        f"synthesis.dwell.optimum.ranges.{key}": ("the two ends of a range", f"{key} = {example}")
        for key, example in _RANGES.items()
    },
    **{f"manipulator.path.{key}": ("two coordinates, or three", f'{key} = ["1.2 m", "0.3 m"]') for key in _PLACES},
    "manipulator.path.points[]": ("two coordinates, or three", '["1.2 m", "0.3 m"]'),
    "manipulator.path.points": ("a list of two points or more", 'points = [["1.2 m", "0.3 m"], ["0.5 m", "1.1 m"]]'),
    "manipulator.path.normal": ("three components", "normal = [0.0, 0.0, 1.0]"),
    "manipulator.motion.t": ("a list of two times or more", 't = ["0 s", "0.5 s", "1 s"]'),
    **{
        f"manipulator.motion.{name}": ("a list of coordinates", f'{name} = ["{example}", "{example}"]')
        for name, example in JOINTS.items()
    },
    **{
        f"manipulator.limits.{name}": ("the lowest and the highest", f'{name} = ["{example}", "{high}"]')
        for (name, example), high in zip((*JOINTS.items(), ("elbow", "-150 deg")), (*_HIGHEST, "-5 deg"), strict=True)
    },
    "manipulator.obstacles.corners": ("three points or more", 'corners = [[0, 0], ["1 m", 0], ["1 m", "1 m"]]'),
    "manipulator.obstacles.box": ("two opposite corners", 'box = [[0, 0], ["1 m", "1 m"]]'),
    "train.modules": ("the modules of the two stages", 'modules = ["2 mm", "3.5 mm"]'),
    **{f"{key}.points": ("a list of two points or more", "points = [[0, 0], [0.5, 0.4], [1, 1]]") for key in _LAWS},
    **{f"{key}.points[]": ("a part of the phase and a displacement", "[0.5, 0.4]") for key in _LAWS},
    **{f"{key}.acceleration": ("a list of two points or more", "acceleration = [[0, 1], [1, -1]]") for key in _LAWS},
    **{f"{key}.acceleration[]": ("a part of the phase and an acceleration", "[0.25, 1]") for key in _LAWS},
    **{f"{key}.polynomial": ("a list of 3 to 30 coefficients", "polynomial = [0, 0, 3, -2]") for key in _LAWS},
    "contact.table.h": ("rows of gaps", 'h = [[0, "1 um"], ["1 um", "2 um"]]'),
    "contact.table.h[]": ("a list of gaps", '[0, "1 um"]'),
    "cam.loads.force_table.phi": ("a list of two angles or more", 'phi = ["0 deg", "90 deg", "270 deg"]'),
    "cam.loads.force_table.force": ("a list of two forces or more", 'force = [0, "-150 N", 0]'),
    "cam.loads.force_table.moment": ("a list of two moments or more", 'moment = [0, "-4 N*m", 0]'),
}

# Tables that are written in one line.
INLINE = {
    "mechanism.joints.guide": 'guide = { through = "B", angle = "0 deg" }',
    "mechanism.joints.slider": 'slider = { through = "B", angle = "0 deg" }',
    "loads.polynomial": "polynomial = { force = [0, 250, -12.5] }",
    "loads.indicator.strokes": 'strokes = [{ x = [0, 1], p = ["5 MPa", "0.3 MPa"] }, ...]',
    "motor.table": 'table = { speed = ["0 rpm", "1500 rpm"], moment = ["15 N*m", 0] }',
    "torque.constants": "constants = { M0 = 500 }",
    "torque.harmonics": 'harmonics = { constant = "20 N*m", terms = [{ order = 2, sin = "100 N*m" }] }',
    "torque.harmonics.terms": 'terms = [{ order = 2, sin = "100 N*m" }]',
    "torque.table": 'table = { theta = ["0 deg", "180 deg"], moment = ["100 N*m", 0] }',
    "gearing.speeds": 'speeds = { sun = "1500 rpm", ring = 0 }',
    "gearing.torques": 'torques = { sun = "20 N*m" }',
    "gearing.load": 'load = { H = "150 N*m" }',
    "gearing.powers": 'powers = { sun = "4 kW" }',
    "pair.cutter": "cutter = { teeth = 20, shift = 0.1, rounding = 0.2 }",
    "pair.meshes.cutter": "cutter = { teeth = 20, shift = 0.1, rounding = 0.2 }",
    **{
        f"manipulator.joints.{name}": f'{name} = {{ from = "{example}", to = "{high}", ... }}'
        for (name, example), high in zip(JOINTS.items(), _HIGHEST, strict=True)
    },
    "contact.table": "table = { x = [...], y = [...], h = [[...], ...] }",
    "cam.loads.force_table": 'force_table = { phi = ["0 deg", "180 deg"], force = ["-150 N", 0] }',
    "pendulum.swing.carrier": 'carrier = { time = ["0 s", "1 s"], x = [0, "0.2 m/s"] }',
    "vibrator.points": 'points = { A = ["20 mm", 0, "-80 mm"] }',
    "transients.load_steps": 'load_steps = [{ factor = 0.5, time = "3 s" }]',
    "transients.brake": 'brake = { moment = "200 N*m", from = "2 s" }',
    "balance.counterweights": 'counterweights = [{ link = 1, radius = "60 mm" }]',
    "balance.add": 'add = [{ order = -1, mass = "2 kg", radius = "60 mm" }]',
}
