"""The domain: elements, changes, rules. Imports no web, database or file code."""
