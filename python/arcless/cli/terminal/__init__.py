"""Text on a terminal: where it goes, tables, progress."""
