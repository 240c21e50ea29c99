"""What takes long: runs, reports and studies in processes of their own."""
