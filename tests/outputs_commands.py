"""What ``outputs.py`` runs: every ready spec through all its stages, every flag, every help text, wrong specs.

A scene is one folder with some specs in it and commands that run there one after the other, so that what one has
stored the next one loads. Commands of a ready spec follow from the stages that ``plan`` says it has.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

COMMANDS = {  # by stage: the command that prints it
    "synthesis": "synth",
    "dyad": "dyad",
    "structure": "structure",
    "kinematics": "kinematics",
    "paths": "paths",
    "forces": "forces",
    "reduction": "reduce",
    "train": "gears synth",
    "gearing": "gears planetary",
    "strength": "gears strength",
    "criteria": "gears compare",
    "pair": "gears pair",
    "blocking": "gears blocking",
    "profile": "gears profile",
    "power": "power",
    "flywheel": "flywheel",
    "motion": "motion",
    "transient": "transient",
    "unsteady": "unsteady",
    "manipulator": "manipulator",
    "balance": "balance",
    "cam_law": "cam law",
    "cam_synthesis": "cam synth",
    "cam_profile": "cam profile",
    "cam_forces": "cam forces",
    "cam_strength": "cam strength",
    "cam_optimum": "cam optimize",
    "cam_elastic": "cam elastic",
    "indexing": "cam indexing",
    "vibrator": "vibrator",
    "pendulum": "pendulum",
    "contact": "extra contact",
    "reliability": "extra reliability",
    "tie_down": "extra tie-down",
    "falling_ball": "extra ball",
    "bearing": "extra bearing",
    "liner": "extra liner",
    "transloader": "extra transloader",
    "feasibility": "feasibility",
}
FORMATS = ("table", "json", "csv", "toml")
UNDRAWN = {
    "structure",
    "drive",
    "power",
    "gearing",
    "strength",
    "bearing",
}  # stages that plot does not know
MORE = {  # by stage: what else there is to ask of it
    "synthesis": ("synth {} --spec ready.toml", "synth {} --choose 2", "check ready.toml", "run ready.toml"),
    "structure": ("structure {} --assemblies",),
    "kinematics": (
        "kinematics {} --plan",
        "kinematics {} --dimensionless --positions 0:12:3",
        "kinematics {} --method projection --no-store -q",
        "kinematics {} --method differences --compare --no-store -q",
        "kinematics {} --columns 'phi,S_*,omega_*' --no-store",
    ),
    "forces": ("forces {} --positions 0:12:4 --columns 'phi,M_*,R_*'",),
    "train": ("gears synth {} --rows 3", "gears planetary {}", "plot {} train --choose 1"),
    "strength": ("gears strength {} --rows 3", "gears strength {} --train 1"),
    "criteria": ("gears compare {} --rows 3",),
    "pair": ("gears measure {}", "gears measure {} -f json", "gears measure {} -f csv"),
    "profile": ("gears profile {} --svg wheels.svg --dxf wheels.dxf --outline wheels.csv --tolerance '1 um'",),
    "cam_profile": ("cam profile {} --svg cam.svg --dxf cam.dxf --nc nc.csv", "cam profile {} --tool '20 mm' -q"),
    "cam_strength": ("cam strength {} --turn",),
    "indexing": ("cam indexing {} --compare", "cam indexing {} --svg cam.svg --dxf cam.dxf --nc nc.csv"),
    "balance": ("plot {} balance -o balance.png",),
}
LENGTHY = ("synth-path", "synth-dwell-optimum", "synth-dwell-rocker")  # in one format alone
FEWER = {"extreme/positions-many": "--set mechanism.grid.positions=5000"}  # in place of a million
SAMPLED = (
    *("shaper", "gears-pairs", "cam-translating", "cam-lantern", "manipulator", "rotor", "extra-bearing"),
    *("synth-slider-crank", "extreme/stall-peak", "extreme/dead-point", "extreme/self-locked"),
)


@dataclass(frozen=True)
class Scene:
    """A folder with specs, and what runs there; of a ready spec also what follows from its stages."""

    name: str
    specs: tuple[str, ...] = ()  # names of ready specs
    commands: tuple[str, ...] = ()
    files: tuple[tuple[str, str], ...] = ()  # further files: name, text
    stages: bool = False


def scenes(configs: Path, sample: bool) -> list[Scene]:
    """Return all scenes, long ones first, or a representative part of them."""
    names = [file.relative_to(configs).with_suffix("").as_posix() for file in sorted(configs.rglob("*.toml"))]
    names.sort(key=lambda name: name != "course-project")
    ready = [Scene(name, (name,), _first(name), stages=True) for name in names]
    if sample:
        kept = [scene for scene in ready if scene.name in SAMPLED]
        return [*kept, *(replace(scene, commands=scene.commands[::5]) for scene in SHORT)]
    return [*LONG, *ready, *SHORT]


def _first(name: str) -> tuple[str, ...]:
    spec = _spec(name)
    return (
        f"init {name}",
        f"check {spec}",
        f"plan {spec} --why",
        f"plan {spec}",
        f"run {spec}",
        f"plan {spec} -f json",
    )


def _spec(name: str) -> str:
    return f"{Path(name).name}.toml {FEWER.get(name, '')}".strip()


def of_stages(name: str, running: list[str]) -> list[str]:
    """Return the commands of a ready spec whose stages are known, after ``run``."""
    spec, known = _spec(name), [stage for stage in running if stage in COMMANDS]
    forms = FORMATS[:1] if name in LENGTHY else FORMATS
    found = [f"{COMMANDS[stage]} {spec} -f {form}" for stage in known for form in forms]
    found += [text.format(spec) for stage in known for text in MORE.get(stage, ()) if name not in LENGTHY]
    return found + [f"plot {spec} {stage} -o {stage}.svg" for stage in running if stage not in UNDRAWN]


HELP = (
    *("", "gears", "cam", "extra", "init", "check", "schema", "plan", "run", "sweep", "plot", "accuracy", "stress"),
    *COMMANDS.values(),
    "gears measure",
)

LENGTH = "mechanism.links[id=1].points.A[0]"
CSV = """variant,mechanism.links[id=1].points.A[0][mm],mechanism.input.speed[rpm]
01,180,52
02,185,55
03,1900,55
"""
SEVERAL = """[mechanism]
gravity = "9.81 m"
[mechanism.grid]
position = 12
[mechanism.input]
joint = "P"
speed = "60 rpn"
[mechanism.fixed]
O = [0, 0]
[[mechanism.links]]
id = 1
points = { O = [0, 0], A = ["60 mm", 0], 1A = [0, 0] }
mass = "-1 kg"
[[mechanism.joints]]
name = "O"
kind = "revolut"
links = [0, 7]
[motor]
power = "1 kW"
[[loads]]
link = 3
"""

SHORT = (
    Scene("help", (), tuple(f"{command} --help".strip() for command in HELP)),
    Scene(
        "texts",
        ("shaper",),
        (
            "--version",
            "",
            "schema",
            "schema -o s.json",
            "init --list",
            "init",
            "init cam-own-law -o own.toml",
            "init cam-own-law -o own.toml",
            "init press -o own.toml",
            "init press -o own.toml --force -q",
            "check own.toml shaper.toml none.toml .",
        ),
    ),
    Scene(
        "wrong flags",
        ("shaper", "press", "cam", "pair"),
        (
            "bogus",
            "kinematic shaper.toml",
            "kinematics",
            "kinematics none.toml",
            "kinematics shaper.toml --metod closed",
            "kinematics shaper.toml --method close",
            "kinematics shaper.toml --method splitting",
            "kinematics shaper.toml --columns vX_D",
            "kinematics shaper.toml --positions 0:99",
            "kinematics shaper.toml --step 1",
            "kinematics shaper.toml --format yaml",
            "kinematics shaper.toml --set mechanism",
            "kinematics shaper.toml --set mechanism.gird.positions=5",
            "kinematics shaper.toml --set mechanism.grid.positions=x",
            "kinematics shaper.toml --set @none.csv:1",
            "forces shaper.toml --iterations RRP",
            "forces shaper.toml --iterations 'RRP(4,5)@99'",
            "forces shaper.toml --stop 0.1",
            "forces shaper.toml --lever 99",
            "forces shaper.toml --lever 4 --bodies 4",
            "kinematics shaper.toml --polygons 4 --scale 0",
            "run shaper.toml --to kinematic",
            "run shaper.toml --skip bogus",
            "run shaper.toml --from train",
            "run shaper.toml -o shaper.toml/x",
            "run shaper.toml --tolerance 2",
            "plan shaper.toml kinematic",
            "plot shaper.toml train",
            "plot shaper.toml cam_laws",
            "plot shaper.toml structure",
            "plot shaper.toml -o a.bmp",
            "plot shaper.toml kinematics --choose 2",
            "gears synth shaper.toml",
            "gears pair cam.toml",
            "gears bogus",
            "gears pair pair.toml --pair second",
            "gears pair pair.toml --sliding-step 2",
            "gears profile pair.toml --wheel 7",
            "cam profile cam.toml --tool 20",
            "cam profile cam.toml --svg a.txt --tolerance '-1 mm'",
            "cam elastic cam.toml",
            "cam pressure cam.toml",
            "extra bal cam.toml",
            "sweep shaper.toml",
            f"sweep shaper.toml --set {LENGTH}=0.1:0.2",
            "sweep shaper.toml --set motion.inertia=1,2 --columns bogus",
            "feasibility shaper.toml",
            "feasibility shaper.toml --over motion.inertia=1:2:3",
            "stress shaper.toml --ladder bogus",
            "accuracy shaper.toml --stage structure",
            "init slot",
            "init shaper -o no/my.toml",
        ),
    ),
    Scene(
        "wrong specs",
        ("shaper", "press", "cam", "pair", "gears-double-planets", "geared-pump"),
        (
            "check several.toml",
            "run several.toml",
            "check broken.toml empty.toml key.toml unit.toml table.toml",
            "run table.toml",
            "run empty.toml",
            f"run shaper.toml --set '{LENGTH}=\"700 mm\"'",
            "run shaper.toml --set 'mechanism.links[id=4].points.D=[\"29 mm\", 0]'",
            "run shaper.toml --set 'mechanism.links[id=3].points.C=[\"600 mm\", 0]'",
            "run shaper.toml --set 'mechanism.links[id=3].points.C=[\"1290 mm\", 0]'",
            "run shaper.toml --set 'mechanism.links[id=3].points.C=[\"1289.97 mm\", 0]'",
            "run shaper.toml --set 'loads[0].force=\"75 kN\"'",
            "run shaper.toml --set motor.power=-1",
            "run shaper.toml --set 'motor.speed=\"1600 rpm\"'",
            "run shaper.toml --set 'mechanism.input.joint=\"A\"'",
            "run shaper.toml --set 'flywheel.delta=3'",
            "run press.toml --set 'mechanism.links[id=2].points.B=[\"37.5 mm\", 0]'",
            "run press.toml --set 'mechanism.links[id=2].points.B=[\"30 mm\", 0]'",
            "run press.toml --set 'mechanism.joints[name=B0].guide.angle=\"89 deg\"'",
            "run cam.toml --set 'cam.roller_radius=\"400 mm\"'",
            "run cam.toml --set 'cam.rise=\"300 deg\"'",
            "run cam.toml --set 'cam.law=\"sinus\"'",
            "run cam.toml --set 'cam.stroke=\"30 deg\"'",
            "run pair.toml --set 'pair.teeth=[5, 7]' --set 'pair.strategy=\"zero\"'",
            "run pair.toml --set 'pair.strategy=\"best\"'",
            "run gears-double-planets.toml --set 'train.ratio=\"0.5\"'",
            "run gears-double-planets.toml --set 'train.tolerance=\"1e-9\"'",
            "run gears-double-planets.toml --set 'strength.torque=\"75 m\"'",
            "run geared-pump.toml --set 'motor.synchronous_speed=\"1234 rpm\"'",
            "run geared-pump.toml --set 'loads[0].force=\"8 MN\"'",
        ),
        (
            ("several.toml", SEVERAL),
            ("broken.toml", "[mechanism\n"),
            ("empty.toml", ""),
            ("key.toml", "[train]\nlayout = 'AI'\nratoi = 7\n[pair]\n"),
            ("unit.toml", '[torque]\nspeed = "20 rad"\nformula = "100*sine(theta)"\n[flywheel]\ndelta = 0.02\n'),
            ("table.toml", "[flywheel]\ndelta = 0.02\n[motion]\n[strength]\n"),
        ),
    ),
    Scene(
        "overrides",
        ("shaper", "press", "class-four", "extreme/positions-many"),
        (
            "kinematics shaper.toml -q --set mechanism.grid.positions=6",
            f"kinematics shaper.toml --set '{LENGTH}=\"190 mm\"'",
            "kinematics shaper.toml --set @class.csv:02 --set mechanism.grid.positions=6",
            "kinematics shaper.toml --set @class.csv:03",
            "kinematics positions-many.toml --no-store --positions 0,1,250000 --columns 'phi,S_*'",
            "kinematics shaper.toml --study",
            "kinematics shaper.toml --study --decimals 5 -f json",
            "kinematics shaper.toml --method differences --step '1 deg' --decimals 6 --compare",
            "kinematics shaper.toml --plan -f json",
            "kinematics shaper.toml --method differences --tolerance 1e-6",
            "kinematics class-four.toml --method splitting --compare -f csv",
            "kinematics shaper.toml --columns 'phi,S_D,vS_D,aS_D,omega_3' --positions 0:24:4",
            "kinematics shaper.toml --fresh --no-csv --depfile k.mk",
            "forces shaper.toml --iterations 'RRP(4,5)@6'",
            "forces shaper.toml --iterations 'RRP(4,5)@67.5 deg' --stop 1e-6 -f json",
            "forces press.toml --iterations 'RRP(2,3)@10'",
            "forces press.toml --lever 9-,9 -f json",
            "forces press.toml --bodies 0,9- -f csv",
            "forces press.toml --columns 'Pi_*,Mi_*,RN_*,RT_*,h_*,angle_R_*,R0_*,P_fr_*,A_fr_*' -f json",
            "kinematics shaper.toml --polygons 4,9",
            "kinematics shaper.toml --polygons 21 --scale '40 mm' -f csv",
            "kinematics shaper.toml --dimensionless --columns 'vrel_*,an_*,at_*,aK_*,*_differences' --positions 0:24:4",
            "reduce shaper.toml --columns 'phi,M_red*,J_red' --positions 0:24:6",
            "reduce shaper.toml --set 'reduction.rods=\"lumped\"' -q",
            "motion shaper.toml --positions 0:24:6 --tolerance 1e-8",
            "run shaper.toml --to forces -o out --columns 'phi,R_*'",
            "run shaper.toml --skip motion --skip balance -o out --from forces",
            "run shaper.toml --tolerance 1e-10 -f json --no-store",
            "run shaper.toml -f csv",
            "run shaper.toml -f toml --strict",
            "run shaper.toml press.toml none.toml --to kinematics -o all -q",
            "run shaper.toml --set 'mechanism.links[id=3].mass=60' --depfile r.mk",
            "plan shaper.toml forces --why -f json",
            "plan shaper.toml --skip reduction -f csv",
            "plot shaper.toml kinematics --polygons 21 --positions 7,0:24:2",
            "plot shaper.toml forces --polygons 6 -o f.svg",
            "check shaper.toml press.toml --set @class.csv:01 -q",
        ),
        (("class.csv", CSV),),
    ),
    Scene(
        "flags of gears and cams",
        ("pair", "pair-helical", "pair-blocking", "gears-single-planets", "gears-radial-planets", "cam", "cam-lantern"),
        (
            "gears pair pair-helical.toml --sliding-step '2 mm'",
            "gears pair pair-blocking.toml --pair 'no undercut' -f csv",
            "gears measure pair-helical.toml --wheel 1 --teeth 3 --ball '8.5 mm' --radius '67 mm'",
            "gears profile pair.toml --rolls=-0.3:0.4:0.1",
            "gears profile pair.toml --fillet 0:0.5:0.1 --wheel 1",
            "gears profile pair.toml --wheel 1 --axis pitch --intervals 4 --points 20 --svg one.svg --tooth",
            "gears profile pair-helical.toml --phase '5 deg' --svg mesh.svg",
            "gears planetary gears-single-planets.toml --choose 3 --external --kinematic",
            "gears planetary gears-radial-planets.toml -f json",
            "gears strength gears-single-planets.toml --train 4 -f json",
            "gears blocking pair-blocking.toml --pair 'no undercut' -f csv",
            "plot pair.toml pair --phase '10 deg' -o p.svg",
            "plot cam-lantern.toml indexing --phase '20 deg'",
            "cam law cam.toml --columns 'phi,S*' --positions 0:60:6 --strict",
            "cam profile cam.toml --nc nc.csv --tool '20 mm' --tolerance '0.1 mm'",
            "cam indexing cam-lantern.toml --compare --columns 'law,z2,theta2_*' -f csv",
            "cam indexing cam-lantern.toml --set indexing.law=\"'0000'\" --compare",
        ),
    ),
    Scene(
        "searches",
        ("shaper", "feasibility", "press"),
        (
            f"sweep shaper.toml --set '{LENGTH}=*0.9:1.1:3' --set motion.inertia=20,200 --jobs 1 "
            "--columns 'kinematics.stroke_D,forces.max(R_A),motion.delta'",
            f"sweep shaper.toml --set '{LENGTH}=*0.9:1.1:3' --set motion.inertia=20,200 --jobs 1 "
            "--columns 'kinematics.stroke_D,forces.max(R_A),motion.delta' -f json",
            "sweep shaper.toml --points class.csv --to kinematics --jobs 1 -o -",
            "sweep shaper.toml --points class.csv --to kinematics --jobs 1 --depfile s.mk -o s.csv",
            "sweep shaper.toml --set 'motion.inertia=*0.5:1.5:4' --jobs 2 --to motion",
            "feasibility feasibility.toml --strict",
            "feasibility feasibility.toml --over synthesis.crank_rocker.time_ratio=1.1:1.5:5 "
            "--over 'synthesis.crank_rocker.swing=30 deg:50 deg:3' --picture map.svg",
            "feasibility feasibility.toml --over synthesis.crank_rocker.time_ratio=1.1:1.5:5 -f csv",
            "synth feasibility.toml --choose 1 --strict",
            "stress shaper.toml --ladder dead-point --stage kinematics --plot stress.svg",
            "stress press.toml --ladder direction --stage kinematics -f csv -o stress.csv",
            "accuracy shaper.toml --stage kinematics --repeats 1",
            "accuracy shaper.toml --stage reduction --repeats 1 -f csv",
            "accuracy press.toml --stage kinematics --repeats 1 -f csv -o a.csv",
        ),
        (("class.csv", CSV),),
    ),
)
LONG = (Scene("ladders", ("crank-slider",), ("stress -f csv", "stress", "stress crank-slider.toml -f json")),)
