"""Flywheels: inertia by the classical methods and under the real motor, its place, its rim.

`methods` compares those for forces of position, `wittenbauer` holds their picture, `required` finds the true
inertia under a motor, `comparison` sets all side by side; `placement` and `rim` turn inertia into a
wheel.
"""
