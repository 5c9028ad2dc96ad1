"""Lanewright's own demo data: procedural logs in the TbV directory layout, deterministic by seed."""

from lanewright.demo.grid import build_map
from lanewright.demo.log import DemoLog, demo_maps, generate

__all__ = ["DemoLog", "build_map", "demo_maps", "generate"]
