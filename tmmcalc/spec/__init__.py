"""The machinery of TOML tables: field types, units, messages, places in the text. No subject's table."""
