"""Runs and measurements that are compared: opened, named, on one section of one line."""
