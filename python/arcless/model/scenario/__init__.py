"""A scenario, the rules for it, and runs that follow from it."""
