"""Files and folders on disk: whole or absent, and locks between processes."""
