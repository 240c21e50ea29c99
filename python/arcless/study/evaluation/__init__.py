"""Variants, and the runs that make their rows."""
