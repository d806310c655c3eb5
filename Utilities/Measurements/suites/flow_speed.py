# SPDX-License-Identifier: BSD-3-Clause
"""Suite flow-speed: vtkImplicitFlowField against vtkStreamTracer."""

from measured_cells import count, error, error_of, joined, ratio
from measured_tables import Table

from .spread import single

NAMES = {"image-64": "image 64³", "image-128": "image 128³", "hexahedra-64": "hexahedra, 64³ points",
         "tetrahedra-64": "tetrahedra, 64³ points"}


def equal(integrator):
    return {"method": "equal-error", "peer": f"streamtracer-{integrator}"}


def again(integrator):
    return {"method": "equal-error-again", "peer": f"streamtracer-{integrator}"}


TABLES = {
    "flow-speed.equal-error": Table("flow-speed", [
        ("our error", error_of(error, **equal("RK4"))),
        ("RK4: error", count("peer_error", error, **equal("RK4"))), ("time / ours", ratio(**equal("RK4"))),
        ("steps/s, ours / its", count("steps_per_second_ratio", **equal("RK4"))),
        ("RK45: error", count("peer_error", error, **equal("RK45"))), ("time / ours", ratio(**equal("RK45"))),
        ("steps/s, ours / its", count("steps_per_second_ratio", **equal("RK45")))],
        head="field", names=NAMES, **equal("RK4")),
    "flow-speed.again": Table("flow-speed", [
        (integrator, joined("{}, its error {}", ratio(**again(integrator)),
                            count("peer_error", error, **again(integrator))))
        for integrator in ("RK4", "RK45")], head="executed again", names=NAMES, **again("RK4")),
}
VALUES = {"flow-speed.second": ("flow-speed", single(ratio(), method="threads-2"))}
