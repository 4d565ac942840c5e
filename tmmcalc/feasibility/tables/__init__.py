"""The TOML tables of the feasibility room: models, with their checks and the tasks that are made of them."""
