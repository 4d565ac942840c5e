"""The few numerical methods that several rooms share, on plain numpy: scipy costs more to import than they run."""
