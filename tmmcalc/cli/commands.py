"""The commands by name: their module and their one line of help, known before any body is imported."""

SECTIONS = {
    "Specs": {
        "init": ("tmmcalc.cli.init", "Write a commented starter spec."),
        "check": ("tmmcalc.cli.check", "Check specs and report all their faults."),
        "schema": ("tmmcalc.cli.schema", "Print the JSON Schema of a spec, for TOML editors."),
        "plan": ("tmmcalc.cli.plan", "Show which stages run for a spec, which do not, and why."),
    },
    "Linkages": {
        "synth": ("tmmcalc.cli.synth", "Linkages by stroke, swing, path, function or motion."),
        "structure": ("tmmcalc.cli.structure", "Mobility, Assur groups, structural formula."),
        "kinematics": ("tmmcalc.cli.kinematics", "Positions, velocities, accelerations, dead centres, strokes."),
        "forces": ("tmmcalc.cli.forces", "Reactions in the pairs, friction, driving moment."),
        "unsteady": ("tmmcalc.cli.unsteady", "Motion from rest to rest by the time-optimal law."),
        "manipulator": ("tmmcalc.cli.manipulator", "Arms: gripper, joints, singular places, obstacles."),
    },
    "Machines": {
        "reduce": ("tmmcalc.cli.reduce", "Reduced moments and inertia, work per cycle."),
        "power": ("tmmcalc.cli.power", "Work per cycle, efficiency, power, choice of the motor."),
        "flywheel": ("tmmcalc.cli.flywheel", "The flywheel for the allowed unevenness, by all methods."),
        "motion": ("tmmcalc.cli.motion", "Steady motion of the machine over the cycle."),
        "transient": ("tmmcalc.cli.transient", "Start-up, braking, run-down, load changes in time."),
        "balance": ("tmmcalc.cli.balance", "Shaking forces of linkage, engine, rotor; counterweights."),
        "vibrator": ("tmmcalc.cli.vibrator", "Vibratory device: frequencies, resonance curve, start-up."),
        "pendulum": ("tmmcalc.cli.pendulum", "Pendulum-rotor: whirl, critical speeds, swing in time."),
    },
    "Gears, cams and others": {
        "gears": ("tmmcalc.cli.gears", "Gears: trains, strength, pairs, blocking contours, profiles."),
        "cam": ("tmmcalc.cli.cam", "Cams: laws, synthesis, profile, forces, strength, optimum."),
        "extra": ("tmmcalc.cli.extra", "Contact, reliability, tie-down, falling ball, bearing."),
    },
    "All stages": {
        "run": ("tmmcalc.cli.run", "Run every stage that the spec has."),
        "sweep": ("tmmcalc.cli.sweep", "Variants of a spec over ranges of its keys, to one CSV."),
        "feasibility": ("tmmcalc.cli.feasibility", "Constraints on results: which hold, by how much."),
        "plot": ("tmmcalc.cli.plot", "Draw the result of a stage to an svg, png or pdf file."),
        "accuracy": ("tmmcalc.cli.accuracy", "Error against run time of every method of the stages."),
        "stress": ("tmmcalc.cli.stress", "Ladders of extremes: where every stage loses its digits."),
    },
}

COMMANDS = {name: line for section in SECTIONS.values() for name, line in section.items()}

GEARS = {
    "synth": ("tmmcalc.cli.gears.synth", "Every set of tooth numbers within the constraints."),
    "planetary": ("tmmcalc.cli.gears.planetary", "Speeds, torques, power flow, efficiency of any train."),
    "strength": ("tmmcalc.cli.gears.strength", "Modules and face widths of all tooth sets."),
    "compare": ("tmmcalc.cli.gears.compare", "Mass, inertia, size, efficiency; the best train."),
    "pair": ("tmmcalc.cli.gears.pair", "Geometry, shifts and checks of pairs of gears."),
    "blocking": ("tmmcalc.cli.gears.blocking", "Blocking contours: all admissible shifts of a pair."),
    "profile": ("tmmcalc.cli.gears.profile", "Tooth profiles; svg, dxf and csv files of gears."),
    "measure": ("tmmcalc.cli.gears.measure", "Span, size over balls, chords of the teeth."),
}

CAM = {
    "law": ("tmmcalc.cli.cam.law", "Law of motion of the follower, its constants and jumps."),
    "synth": ("tmmcalc.cli.cam.synth", "Sizes within the limits of the pressure angle."),
    "profile": ("tmmcalc.cli.cam.profile", "Pitch and working profile; svg, dxf and csv files."),
    "forces": ("tmmcalc.cli.cam.forces", "Spring, reactions, friction, torque of the cam."),
    "strength": ("tmmcalc.cli.cam.strength", "Slip, shaft, stem, pin, contact stress with margins."),
    "elastic": ("tmmcalc.cli.cam.elastic", "Vibration of a follower on an elastic train."),
    "optimize": ("tmmcalc.cli.cam.optimize", "The lowest mechanism; blocking contour; what limits it."),
    "indexing": ("tmmcalc.cli.cam.indexing", "Cam-lantern indexing drive: limits, profiles, efficiency."),
}

EXTRA = {
    "contact": ("tmmcalc.cli.extra.contact", "Pressure of two elastic bodies, with Hertz as check."),
    "reliability": ("tmmcalc.cli.extra.reliability", "Reliability and life under shock loads."),
    "tie-down": ("tmmcalc.cli.extra.tie_down", "Forces in the ties of a transported load."),
    "ball": ("tmmcalc.cli.extra.ball", "Fall of a ball whose radius decreases."),
    "bearing": ("tmmcalc.cli.extra.bearing", "Frequencies of the defects of a rolling bearing."),
}
