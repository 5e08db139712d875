"""What the book needs and a filter does not: figures, scenes, rendered rooms, the report's filter."""
