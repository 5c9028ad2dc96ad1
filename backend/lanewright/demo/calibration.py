"""A plausible sensor rig: seven ring cameras and two lidars on the roof (nominal values, TbV image sizes)."""

from __future__ import annotations

import math
from dataclasses import dataclass

Quaternion = tuple[float, float, float, float]
"""w, x, y, z."""


@dataclass(frozen=True, slots=True)
class Camera:
    """A pinhole camera. ``yaw_degrees`` to the left of straight ahead, position in the ego frame (metres)."""

    name: str
    yaw_degrees: float
    position: tuple[float, float, float]
    width_px: int
    height_px: int
    focal_px: float

    @property
    def quaternion(self) -> Quaternion:
        """ego_SE3_camera: camera axes x right, y down, z forward."""
        w, z = math.cos(math.radians(self.yaw_degrees) / 2), math.sin(math.radians(self.yaw_degrees) / 2)
        # yaw about ego z, after the fixed turn from camera axes to ego axes (0.5, -0.5, 0.5, -0.5)
        return (0.5 * (w + z), 0.5 * (-w - z), 0.5 * (w - z), 0.5 * (-w + z))


CAMERAS = (
    Camera("ring_front_center", 0.0, (1.63, 0.0, 1.40), 1550, 2048, 1780.0),
    Camera("ring_front_left", 45.0, (1.55, 0.20, 1.40), 1024, 775, 842.0),
    Camera("ring_front_right", -45.0, (1.55, -0.20, 1.40), 1024, 775, 842.0),
    Camera("ring_rear_left", 153.0, (1.09, 0.13, 1.42), 1024, 775, 842.0),
    Camera("ring_rear_right", -153.0, (1.09, -0.13, 1.42), 1024, 775, 842.0),
    Camera("ring_side_left", 99.0, (1.31, 0.28, 1.41), 1024, 775, 842.0),
    Camera("ring_side_right", -99.0, (1.31, -0.28, 1.41), 1024, 775, 842.0),
)
LIDARS: tuple[tuple[str, Quaternion, tuple[float, float, float]], ...] = (
    ("up_lidar", (1.0, 0.0, 0.0, 0.0), (1.35, 0.0, 1.64)),
    ("down_lidar", (0.0, 1.0, 0.0, 0.0), (1.35, 0.0, 1.53)),
)
