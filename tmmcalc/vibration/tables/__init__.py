"""The TOML tables of the vibration room: models, with their checks and the tasks that are made of them."""
