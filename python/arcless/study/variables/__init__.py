"""What a study varies, and how its values are distributed."""
