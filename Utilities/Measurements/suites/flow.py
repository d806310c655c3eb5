# SPDX-License-Identifier: BSD-3-Clause
"""Suite flow: vtkImplicitFlowField and vtkFlowVolume."""

from measured_cells import count, error, error_of, joined, short, time
from measured_tables import Lines, Table

from .spread import single

FIELDS = {"source-sink": "source and sink", "sphere": "round a sphere", "abc": "ABC"}
OWN = {"automatic": "automatic", "dormand-prince": "Dormand–Prince", "runge-kutta-4": "RK4", "rosenbrock": "Rosenbrock"}
LINEAR = ("uniform", "rotation", "saddle", "spiral", "source-sink", "sphere", "abc")
TUBES = ("contraction", "beside", "around")


def answers(**fields):
    return joined("{}, {}: {}", error_of(error, **fields), count("time_error", error, **fields), time(**fields))


def volume(case):
    return joined("{}, {}: {}", error_of(error, case=case), count("boundary_distance", error, case=case),
                  time(case=case))


def changed(method):
    return time(method=method)


TABLES = {
    "flow.answers": Table("flow", [
        *((words, answers(method=method, parameter=1e-6)) for method, words in OWN.items()),
        ("`vtkStreamTracer` RK4, half a cell", answers(method="RK4", parameter=0.5)),
        ("RK45, 1e-8", answers(method="RK45", parameter=1e-8))],
        head="field", names=FIELDS, method="automatic", parameter=1e-6, case=lambda name: name in LINEAR),
    "flow.stiff": Table("flow", [(words, time(method=method, parameter=1e-6)) for method, words in OWN.items()],
                        head="field", method="automatic", parameter=1e-6,
                        case=lambda name: name is not None and name.startswith("stiff")),
    "flow.changes": Table("flow", [
        ("tetrahedra", count("tetrahedra", parameter="1 thread")), ("1 thread", time(parameter="1 thread")),
        ("2 threads", time(parameter="2 threads"))], head="change", by="method",
        names={"new-mapping": "inflow mapping", "new-interval": "interval alone", "new-times": "range of times alone"},
        method=lambda name: name in ("new-mapping", "new-interval", "new-times"), parameter="1 thread"),
    "flow.conservation": Table("flow", [("largest deviation of the flux", error_of(error))], head="field",
                               method="conservation"),
    "flow.tubes": Lines("flow", [(case, volume(case)) for case in TUBES], [
        *((f"explicit, {rings} rings", {"method": "explicit", "parameter": rings}) for rings in (8, 16, 32)),
        *((f"halved, {rings} rings", {"method": "explicit-halved", "parameter": rings}) for rings in (8, 16)),
        *((f"implicit, {side}³ samples", {"method": "implicit", "parameter": side}) for side in (32, 64, 96)),
        *((f"again, {side}³", {"method": "implicit-again", "parameter": side}) for side in (32, 64, 96)),
        *((f"refined, from {side}³", {"method": "implicit-refined", "parameter": side}) for side in (24, 48))],
        head="method"),
}
MAPPING = {"method": "new-mapping", "parameter": "1 thread"}
VALUES = {
    "flow.mapping-tetrahedra": ("flow", single(count("tetrahedra", short), **MAPPING)),
    "flow.mapping-time": ("flow", single(time(), **MAPPING)),
}
