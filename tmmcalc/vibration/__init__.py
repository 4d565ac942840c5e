"""Vibration: the vibratory assembly device and the pendulum-rotor, with equations that follow from their energies."""
