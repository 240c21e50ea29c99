"""Scenario files that hold only what differs from another scenario."""
