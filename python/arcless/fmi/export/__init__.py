"""From a scenario to a model that other programs step."""
