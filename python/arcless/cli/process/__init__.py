"""The process of a command: its start, its signals, its failures."""
