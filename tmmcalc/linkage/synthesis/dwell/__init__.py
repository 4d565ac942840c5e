"""Six-bar linkages of class IV whose output dwells: synthesis by three positions, motion, unit forces, optimum."""
