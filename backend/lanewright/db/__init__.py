"""The store: PostGIS through SQLAlchemy. City-frame doubles are the truth, a 3857 column beside them is for display."""
