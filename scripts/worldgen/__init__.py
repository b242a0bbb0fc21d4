"""Tools that draw the simulator's worlds."""
