"""What a user does in the studio: a real server on a folder of its own, and Chromium."""
