# SPDX-License-Identifier: BSD-3-Clause
"""Suite mixed: vtkShadowedScenePass."""

from measured_cells import count, error, error_of, percent, slower
from measured_tables import Table

OURS = {"method": "scene-pass", "peer": "shadow-maps"}
MOVING = {"method": "scene-pass, light moves", "peer": "shadow-maps"}
MAPS = {"method": "shadow-maps"}
BUDGET = "volume + 2 actors"

TABLES = {
    "mixed.slabs": Table("mixed", [
        ("mean difference", error_of(error, method="scene-pass", peer=None)),
        ("95 % away from edges are within", count("flat_p95", error, method="scene-pass", peer=None)),
        ("edges off by, texels", count("edge_texels", method="edges"))],
        head="scene", method="scene-pass", peer=None),
    "mixed.maps": Table("mixed", [
        ("error, ours", error_of(error, **OURS)), ("`vtkShadowMapPass`", error_of(error, **MAPS)),
        ("edges off by, pixels, ours", count("edge_pixels", **OURS)),
        ("`vtkShadowMapPass`", count("edge_pixels", **MAPS)),
        ("processor time over the peer's", count("processor_over_peer", **OURS)),
        ("light moves", count("processor_over_peer", **MOVING))], head="resolution of maps", by="parameter", **OURS),
    "mixed.soft": Table("mixed", [
        ("error", error_of(error)), ("processor time over hard shadows", count("processor_over_hard")),
        ("time over hard shadows", slower())], head="samples of the light", by="parameter", method="soft"),
    "mixed.budget": Table("mixed", [
        ("camera moves", count("processor_over_budget", method="scene-pass", peer=BUDGET)),
        ("light moves", count("processor_over_budget", method="scene-pass, light moves", peer=BUDGET))],
        head="processor time over that of the volume and the actors twice", peer=BUDGET),
    "mixed.turns": Table("mixed", [
        ("largest distance of a mean from its neighbours'", error_of(percent)), ("95 % below", count("p95", percent)),
        ("largest change of a pixel", count("change_largest")), ("95 % below", count("change_p95"))],
        head="scene, turned, frames", by=("case", "method", "parameter"),
        method=lambda name: name in ("views", "lights")),
}
VALUES = {}
