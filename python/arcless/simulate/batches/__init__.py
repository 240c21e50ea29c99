"""Many runs that share what can be shared."""
