# SPDX-License-Identifier: BSD-3-Clause
"""Suite flow-texture: vtkImplicitFlowVolumeMapper."""

from measured_cells import count, joined, ratio, slower
from measured_tables import Table


def against(method):
    return joined("{} ({})", ratio(method=method, peer="gpu-rgba"), ratio(method=method, peer="gpu"))


TABLES = {
    "flow-texture.speed": Table("flow-texture", [
        ("cells that are split", count("split_cells", method="textures", peer="gpu-rgba")),
        ("filtered", against("textures")), ("unfiltered", against("textures, unfiltered"))],
        head="field", method="textures", peer="gpu-rgba"),
    "flow-texture.shadows": Table("flow-texture", [("time over the other", slower()), ("slices", count("slices"))],
                                  head="method", by="method", case="rotation",
                                  method=lambda name: name is not None and name.startswith("shadows")),
}
VALUES = {}
