"""Plain data: fields that are checked and read, files written whole or not at all, tables that a notebook shows."""
