"""Commands about measured test runs."""
