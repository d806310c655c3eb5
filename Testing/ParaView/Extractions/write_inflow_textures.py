# SPDX-License-Identifier: BSD-3-Clause
"""write_inflow_textures.py FOLDER: writes images for the plugin test of Inflow Textures.

Writes inflow_textures.json, a list of cases with flow, surfaces, mapper settings and camera, an image
`<name>.png` for each, and the textures. ParaView must reproduce the images.
"""

import os
import sys

import numpy
from interlume import vtkAnalyticFlowSource, vtkImplicitFlowVolumeMapper
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkLight

from images import crop, make_renderer, make_volume, read_image, set_light, write_image, write_images
from pipelines import connected, flow_field, set_properties, updated

WIDE, FINE = "inflow-wide.png", "inflow-fine.png"
NO_CROP = [1.0, 1.0, 1.0]
ALL_SURFACES = -1
# Flow around a sphere, with an upstream rectangle of id 3. `pulse` is the fraction of the period in which dye
# is injected.
COMMON = {
    "source_properties": {
        "Field": vtkAnalyticFlowSource.SPHERE, "WholeExtent": [0, 19] * 3, "Bounds": [-1.0, 1.0] * 3},
    "surfaces": [{"kind": "Rectangle", "properties": {
        "Center": [-0.875, 0.0, 0.0], "Normal": [1.0, 0.0, 0.0], "Lengths": [1.5, 1.5], "Id": 3}}],
    "meshes": [], "field": {"SampleMode": 0}, "size": [200, 160], "background": [0.925, 0.929, 0.933],
    "camera": {"position": [1.6, -3.6, 1.8], "focus": [0.0, 0.0, 0.0], "up": [0.0, 0.0, 1.0], "angle": 40.0},
    "unit": 0.1, "inflow": "", "surface": "", "detail": "", "pulse": 1.0, "phase": 0.0, "opacity_range": [],
    "shading": "", "shadows": 0, "crop": NO_CROP, "ambient": 0.1, "diffuse": 0.9,
    "light": {
        "position": [1.0, -1.0, 3.0], "focus": [0.0, 0.0, 0.0], "color": [1.0, 0.95, 0.85], "intensity": 0.9}}
CASES = [{**COMMON, **changes, "name": "inflow-" + name} for name, changes in (
    ("plain", {}), ("all", {"inflow": WIDE}), ("one-surface", {"inflow": WIDE, "surface": FINE}),
    ("detail", {"inflow": WIDE, "detail": FINE}), ("pulse", {"inflow": WIDE, "pulse": 0.5}),
    ("phase", {"inflow": WIDE, "pulse": 0.5, "phase": 0.3}),
    ("opacity", {"inflow": WIDE, "opacity_range": [1.0, 0.2]}),
    ("cropped", {"inflow": WIDE, "crop": [0.9, 0.4, 1.0]}),
    ("shaded", {"inflow": WIDE, "shading": "AdvectionTime"}), ("shadows", {"inflow": WIDE, "shadows": 1}))]


def squares(width):
    """Returns a checkerboard of two colors, one of them nearly transparent."""
    def color(x, y):
        is_dense = (x // width + y // width) % 2 != 0
        return numpy.where(is_dense, 200, 40), 60 + 2 * y, 40 + 3 * x, numpy.where(is_dense, 120, 20)
    return color


def step(*points):
    function = vtkPiecewiseFunction()
    for point in points:
        function.AddPoint(*point)
    return function


def draw(picture, folder):
    write_image(os.path.join(folder, WIDE), squares(16))
    write_image(os.path.join(folder, FINE), squares(4))
    images = {name: read_image(os.path.join(folder, picture[name])) if picture[name] else None
              for name in ("inflow", "surface", "detail")}
    field = updated(flow_field(picture))
    mapper = connected(vtkImplicitFlowVolumeMapper(), field)
    mapper.SetInflowTexture(ALL_SURFACES, images["inflow"])
    mapper.SetInflowTexture(3, images["surface"])
    set_properties(mapper, {
        "DetailTexture": images["detail"], "TimePhase": picture["phase"], "ShadingArray": picture["shading"],
        "Shadows": picture["shadows"]})
    if picture["pulse"] < 1.0:
        mapper.SetTimeGate(step((0.0, 1.0), (picture["pulse"], 1.0, 0.0, 1.0), (1.0, 0.0)))
    if picture["crop"] != NO_CROP:
        crop(mapper, field.GetOutputDataObject(0).GetBounds(), picture["crop"])
    volume = make_volume(mapper, picture)
    set_properties(volume.GetProperty(), {
        "Shade": bool(picture["shading"]), "Ambient": picture["ambient"], "Diffuse": picture["diffuse"],
        "Specular": 0.0})
    if picture["opacity_range"]:
        low, high = picture["opacity_range"]
        mapper.SetOpacityArray("AdvectionTime")
        volume.GetProperty().SetScalarOpacity(step((low, 0.0), (high, 1.0)))
    return make_renderer(volume, [set_light(vtkLight(), picture["light"])])


write_images(sys.argv[1], "inflow_textures.json", CASES, draw)
