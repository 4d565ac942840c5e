"""The pendulum-rotor: a heavy elastic rod that hangs in a spherical joint, spins, and carries a disc."""
