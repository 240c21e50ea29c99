"""Jobs that take long: runs, reports and studies in processes of their own."""
