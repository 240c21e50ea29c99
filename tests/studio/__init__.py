"""The studio as a user works with it: a real server on a folder of its own, and Chromium."""
