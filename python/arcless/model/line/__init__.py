"""An overhead line, and the rules for it."""
