"""What people and other programs read: documents made of facts and one table, in four formats."""
