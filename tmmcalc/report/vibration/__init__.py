"""Reports of the vibratory device and of the pendulum-rotor."""
