"""Use cases: (session, actor, arguments) -> result. They never commit and know nothing of HTTP."""
