"""What runs outside a request: procrastinate on the same database, so that a job commits with its cause."""
