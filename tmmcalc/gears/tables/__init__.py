"""The TOML tables of the gear room: models, with their checks and the tasks that are made of them."""
