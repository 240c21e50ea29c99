"""An overhead line, the rules for it, and the names of its parts."""
