"""Strength of spur gears: endurance of the teeth in contact and bending, modules and face widths.

``tables`` holds the reference data, ``steels`` and ``hardness`` read what a drawing says, ``endurance`` makes the
permissible stresses of a wheel, ``loads`` the torque of every mesh, ``series`` the standard modules, ``widths`` the
face widths; ``solve`` puts them together, ``explain`` tells every coefficient with its source,
``chain`` goes on from them to the stresses step by step.
"""
