"""Forces on the follower of a cam: the return spring, reactions with friction, torque and work of the camshaft."""
