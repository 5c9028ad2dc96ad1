"""All SQL of the product, a file per noun. Functions take a session and values; they never commit."""
