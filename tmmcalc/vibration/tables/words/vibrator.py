"""Words for faults in ``[vibrator]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "ring": ("a device has its ring", "add [vibrator.ring] with mass and inertia"),
    "ring.mass": ("the ring has its mass", 'add mass = "1.2 kg"'),
    "ring.inertia": ("the ring turns about the vertical", 'add inertia = "2e-3 kg*m^2"'),
    "gripper": ("a device has its gripper", "add [vibrator.gripper] with mass, drop and inertias"),
    "gripper.mass": ("the gripper has its mass", 'add mass = "0.9 kg"'),
    "gripper.drop": ("its centre of mass hangs below the flat springs", 'add drop = "40 mm"'),
    "gripper.inertia_x": ("the gripper tilts about x", 'add inertia_x = "8e-4 kg*m^2"'),
    "gripper.inertia_y": ("the gripper tilts about y", 'add inertia_y = "8e-4 kg*m^2"'),
    "gripper.inertia_z": ("the gripper turns with the ring", 'add inertia_z = "4e-4 kg*m^2"'),
    "exciter": (
        "a device has its exciter",
        "add [vibrator.exciter] with mass, arm and stiffness of the plate",
    ),
    "exciter.mass": ("the exciter has its mass", 'add mass = "0.5 kg"'),
    "exciter.radius": ("its centre of mass is off the vertical axis", 'add radius = "60 mm"'),
    "exciter.arm": ("its centre of mass is at a distance from the hinge", 'add arm = "50 mm"'),
    "exciter.arm_angle": ("that arm climbs above the horizontal", 'add arm_angle = "30 deg"'),
    "exciter.inertia_hinge": ("the exciter turns about its hinge", 'add inertia_hinge = "2.5e-4 kg*m^2"'),
    "exciter.stiffness": ("the plate resists that turn", 'add stiffness = "60 N*m/rad"'),
    "rods": ("rods carry the ring", "add [vibrator.rods] with radius, diameter and length"),
    "rods.radius": ("the rods stand around the axis", 'add radius = "70 mm"'),
    "flats": ("flat springs carry the gripper", "add [vibrator.flats] with width, thickness, length, offset"),
    "curve.from": ("a curve has its lowest speed", 'add from = "600 rpm"'),
    "curve.to": ("a curve has its highest speed", 'add to = "3000 rpm"'),
    "start.acceleration": ("the rotor speeds up evenly", 'add acceleration = "300 rad/s^2"'),
    "start.duration": ("a start has its duration", 'add duration = "1.5 s"'),
    "drive.duration": ("a start has its duration", 'add duration = "4 s"'),
}

INLINE = {
    "points": 'points = { A = ["20 mm", 0, "-80 mm"] }',
}
