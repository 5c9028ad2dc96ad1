"""Geometry of sensors and the ground: frames, rasters, images. Pure values in, values out."""
