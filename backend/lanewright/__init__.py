"""Lanewright: annotate how HD maps change, with exactly one explanation per map update."""

__version__ = "0.1.0"
