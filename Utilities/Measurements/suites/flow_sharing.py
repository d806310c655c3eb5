# SPDX-License-Identifier: BSD-3-Clause
"""Suite flow-sharing: ShareStreamlines of vtkImplicitFlowField."""

from measured_cells import count, error, joined, percent, ratio
from measured_tables import Table

TABLES = {
    f"flow-sharing.{name}": Table("flow-sharing", [
        ("shared", count("share", percent)), ("median", count("median", error)), ("99 %", count("q99", error)),
        ("99.9 %", count("q999", error)), ("largest", count("largest", error)), ("faster", ratio())],
        head="field", parameter=tolerance)
    for name, tolerance in (("loose", 1e-3), ("middle", 1e-4), ("default", 1e-6))
}
VALUES = {}
