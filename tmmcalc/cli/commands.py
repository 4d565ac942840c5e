"""The commands by name: their module and their one line of help, known before any body is imported."""

COMMANDS = {
    "init": ("tmmcalc.cli.init", "Write a commented starter spec."),
    "check": ("tmmcalc.cli.check", "Check specs and report all their faults."),
    "schema": ("tmmcalc.cli.schema", "Print the JSON Schema of a spec, for TOML editors."),
    "plan": ("tmmcalc.cli.plan", "Show which stages run for a spec, which do not, and why."),
    "structure": ("tmmcalc.cli.structure", "Mobility, Assur groups, structural formula."),
    "kinematics": ("tmmcalc.cli.kinematics", "Positions, velocities, accelerations, dead centres, strokes."),
    "run": ("tmmcalc.cli.run", "Run every stage that the spec has."),
    "plot": ("tmmcalc.cli.plot", "Draw the result of a stage to an svg, png or pdf file."),
}
