"""Runs on the disk: where they are, and what is in them in a few words."""
