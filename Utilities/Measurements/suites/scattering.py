# SPDX-License-Identifier: BSD-3-Clause
"""Suite scattering: scattered light in vtkShadowedSliceMapper."""

from measured_cells import count, error_of, joined, percent, slower
from measured_tables import Table

MODES = ("single", "forward", "full")
DEPTHS = ("0.25", "1", "4", "16", "64")


def is_slab(name):
    return name is not None and name.startswith("slab")


TABLES = {
    "scattering.slabs": Table("scattering", [(mode, error_of(percent, method=mode)) for mode in MODES],
                              head="slab of van de Hulst, cells through it", by=("case", "parameter"), case=is_slab,
                              method=lambda name: name in MODES),
    "scattering.limits": Table("scattering", [
        (f"depth {depth}: reflected, transmitted", joined("{}, {}", count(f"depth {depth} reflected", percent),
                                                          count(f"depth {depth} transmitted", percent)))
        for depth in DEPTHS], head="phase function", by="parameter", case="limits",
        parameter=lambda name: name is not None and str(name).startswith("g ")),
    "scattering.within": Table("scattering", [("settings within", count("within")), ("of", count("settings"))],
                               head="error", by="parameter", case="limits",
                               parameter=lambda name: name is not None and str(name).startswith("within ")),
    "scattering.cloud": Table("scattering", [
        *((f"{mode}: error", error_of(case="cloud", method=mode)) for mode in MODES),
        *((f"{mode}: time over shadows alone", slower(case="cloud", method=mode, peer="shadowed")) for mode in MODES)],
        head="setting", by="parameter", case="cloud", method=lambda name: name in MODES),
    "scattering.views": Table("scattering", [
        (f"{mode}: time over shadows alone", slower(case="cloud, the view turns", method=mode)) for mode in MODES],
        head="pixels a side", by="parameter", case="cloud, the view turns"),
}
VALUES = {}
