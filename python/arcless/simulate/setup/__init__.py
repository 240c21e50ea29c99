"""Parts of a scenario → inputs of the core's steps."""
