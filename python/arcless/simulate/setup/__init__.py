"""Parts of a scenario → what the core is given to step."""
