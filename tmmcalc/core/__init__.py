"""What every room stands on and no subject knows."""
