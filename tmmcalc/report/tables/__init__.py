"""The TOML table of what is handed in, which belongs to no room."""
