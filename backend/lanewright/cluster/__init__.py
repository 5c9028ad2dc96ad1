"""The private PostGIS cluster that Lanewright runs for itself when no ``DATABASE_URL`` is given.

Standard library only: it has to work before anything else does.
"""

from lanewright.cluster.errors import ClusterError
from lanewright.cluster.private import ClusterStatus, PrivateCluster

__all__ = ["ClusterError", "ClusterStatus", "PrivateCluster"]
