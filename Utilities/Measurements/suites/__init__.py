# SPDX-License-Identifier: BSD-3-Clause
"""The tables and numbers of the pages, a file for each suite of interlume-bench.

TABLES: by name a table; VALUES: by name the suite and a function that makes text of its run; README_LINES: the
lines of the README's table.
"""

from . import (contour, flow, flow_sharing, flow_speed, flow_texture, growth, interval, interval4d, mixed,
               profiles, ranks, scattering, scene_costs, shadows, soft_shadows, tables, tetrahedra)
from .readme import README_LINES

TABLES = {}
VALUES = {}
for _suite in (interval, contour, tetrahedra, shadows, scattering, soft_shadows, mixed, interval4d, flow, flow_speed,
               flow_sharing, flow_texture, growth, ranks, scene_costs, profiles, tables):
    TABLES.update(_suite.TABLES)
    VALUES.update(_suite.VALUES)

__all__ = ["README_LINES", "TABLES", "VALUES"]
