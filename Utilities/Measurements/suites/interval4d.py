# SPDX-License-Identifier: BSD-3-Clause
"""Suite interval4d: vtkTimeVaryingIntervalVolume."""

from measured_cells import count, error_of, joined, mebibytes_of_kib, percent, ratio, time
from measured_tables import Lines, Table

from .data_names import STEPS
from .spread import single

WARM = {"method": "warm", "parameter": "1 thread"}
DIFFERENCE = {"error_norm": "symmetric difference, share of the volume"}


def table_lookups(method):
    return Table("interval4d", [
        ("lookups", count("lookups")), ("cases made", count("cases_made")), ("kinds made", count("kinds_made")),
        ("found their case", count("hit_share", percent)), ("found their kind", count("kind_hit_share", percent))],
        head="data", names=STEPS, method=method)


def with_stated(name):
    return joined("{} ({})", count(name), count(f"stated_{name}"))


def between(method, field):
    rows = {"case": field, "method": method, **DIFFERENCE}
    return joined("{} ({})", error_of(**rows), time(**rows))


TABLES = {
    "interval4d.speed": Table("interval4d", [
        ("4-simplices", count("simplices", **WARM)), ("dissertation", count("stated_simplices", **WARM)),
        ("tetrahedra", count("tetrahedra", **WARM)), ("warm", time(**WARM)), ("cold", time(method="cold")),
        ("a second thread", ratio(method="threads-2"))], head="data", names=STEPS, **WARM),
    "interval4d.lookups": table_lookups("cold"),
    "interval4d.later": table_lookups("later-slabs"),
    "interval4d.memory": Table("interval4d", [
        ("two steps, MiB", count("steps_kib", mebibytes_of_kib)), ("output, MiB", count("output_kib", mebibytes_of_kib)),
        ("peak, MiB", count("peak_kib", mebibytes_of_kib)), ("peak / (steps + output)", count("peak_share"))],
        head="data", names=STEPS, method="memory"),
    "interval4d.classes": Lines("interval4d", [
        ("3-simplices, first step", with_stated("3_simplices")), ("4-simplices", with_stated("4_simplices")),
        *((f"class {name}", with_stated(f"class_{name}")) for name in ("1", "2", "3a", "3b", "4", "5"))],
        [(f"{STEPS[case]}, {words}", {"case": case, "method": method})
         for case in ("vortex-2", "wave-2") for method, words in (("hexahedra", "hexahedra"),
                                                                  ("tetrahedra-5", "tetrahedra"))], head="data"),
    **{f"interval4d.between-{field}": Table("interval4d", [
        ("slice of 4-simplices", between("slice", field)), ("interpolated", between("interpolate", field)),
        ("sampled", between("sampled", field))], head="step", by="parameter", case=field, **DIFFERENCE)
       for field in ("wave", "ball", "linear")},
}
VALUES = {
    "interval4d.vortex-simplices": ("interval4d", single(count("simplices"), case="vortex-2", **WARM)),
    "interval4d.vortex-tetrahedra": ("interval4d", single(count("tetrahedra"), case="vortex-2", **WARM)),
    "interval4d.vortex-warm": ("interval4d", single(time(), case="vortex-2", **WARM)),
    "interval4d.vortex-cold": ("interval4d", single(time(), case="vortex-2", method="cold")),
}
