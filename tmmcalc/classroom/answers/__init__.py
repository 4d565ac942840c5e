"""What students hand in, whatever it is: files, tables in them, numbers in these."""
