"""The least device, and the least pendulum, that the tests of their tables start from."""

from __future__ import annotations

RING = '[vibrator.ring]\nmass = "1.2 kg"\ninertia = "2e-3 kg*m^2"\n'
GRIPPER = (
    '[vibrator.gripper]\nmass = "0.9 kg"\ndrop = "40 mm"\n'
    'inertia_x = "8e-4 kg*m^2"\ninertia_y = "7e-4 kg*m^2"\ninertia_z = "4e-4 kg*m^2"\n'
)
EXCITER = (
    '[vibrator.exciter]\nmass = "0.5 kg"\nradius = "60 mm"\narm = "50 mm"\narm_angle = "30 deg"\n'
    'inertia_hinge = "2.5e-4 kg*m^2"\ninertia_vertical = "3e-4 kg*m^2"\nstiffness = "60 N*m/rad"\n'
)
RODS = '[vibrator.rods]\nradius = "70 mm"\ndiameter = "3 mm"\nlength = "80 mm"\n'
FLATS = '[vibrator.flats]\nwidth = "12 mm"\nthickness = "0.8 mm"\nlength = "30 mm"\n'
UNBALANCE = '[vibrator.unbalance]\nmoment = "200 g*mm"\nrotor_inertia = "2e-4 kg*m^2"\n'
MOTOR = '[motor]\nkind = "shunt"\npower = "5 W"\nspeed = "1500 rpm"\nno_load_speed = "1800 rpm"\n'
DEVICE = RING + GRIPPER + EXCITER + RODS + FLATS
HEAD = '[vibrator]\nspeed = "1450 rpm"\n'
ROD = '[pendulum.rod]\nlength = "800 mm"\ndiameter = "12 mm"\n'
PLAIN = '[pendulum.rod]\nlength = "800 mm"\nmass = "0.8 kg"\nbending_stiffness = 200\n'
