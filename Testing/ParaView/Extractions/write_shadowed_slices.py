# SPDX-License-Identifier: BSD-3-Clause
"""write_shadowed_slices.py FOLDER: writes images for the plugin test of the Shadowed Slices representation.

Writes shadowed_slices.json, a list of cases with source, settings, lights and camera, an image `<name>.png`
for each, and the image of the projective light. ParaView must reproduce the images.
"""

import os
import sys

import numpy
from interlume import vtkAnalyticFieldSource, vtkProjectiveLight, vtkShadowedSliceMapper
from vtkmodules.vtkRenderingCore import vtkLight, vtkLightKit

from images import (
    crop, gyroid_camera, make_renderer, make_volume, read_image, set_light, write_image, write_images)
from pipelines import connected, set_properties, temporal_source, updated

SCREEN = "light-screen.png"
# Part of a gyroid with haze around it, lit by the light kit. `light` is a light of the view, and `projector`
# is the light of the representation.
COMMON = {
    "source": "AnalyticField",
    "source_properties": {
        "Field": vtkAnalyticFieldSource.GYROID, "WholeExtent": [0, 71] * 3, "Bounds": [-0.9, 0.9] * 3},
    "array": "f", "size": [480, 360], "background": [0.925, 0.929, 0.933], "camera": gyroid_camera(46.0),
    "colors": [[0.4, 0.35, 0.45, 0.80], [0.8, 0.87, 0.87, 0.87], [1.3, 0.80, 0.25, 0.15]],
    "opacities": [[0.5, 0.0], [0.8, 0.1], [1.0, 0.8]], "unit": 0.05, "shade": 1, "ambient": 0.15, "kit": 1,
    "shadows": 1, "number_of_shadows": 1, "spacing": 0.0, "colored": 0, "crop": []}
SCENE_LIGHT = {
    "position": [1.0, 0.5, 2.0], "focus": [0.0, 0.0, 0.0], "color": [1.0, 0.95, 0.85], "intensity": 0.9}
PROJECTOR = {
    "position": [0.5, -2.5, 2.0], "focus": [0.2, -1.0, 0.8], "up": [0.0, 0.0, 1.0], "screen": [1.1, 0.9],
    "edge": 0.15, "color": [1.0, 1.0, 1.0], "intensity": 1.2, "image": SCREEN}
CASES = [{**COMMON, **changes, "name": name} for name, changes in (
    ("slices-light-kit", {}), ("slices-unshadowed", {"shadows": 0}), ("slices-plain", {"shadows": 0, "shade": 0}),
    ("slices-two-lights", {"kit": 0, "light": SCENE_LIGHT, "projector": PROJECTOR, "number_of_shadows": 2}),
    ("slices-colored", {"kit": 0, "light": SCENE_LIGHT, "colored": 1}),
    ("slices-cropped", {"shade": 0, "spacing": 0.04, "crop": [1.0, 0.6, 0.8]}))]


def squares(x, y):
    return numpy.where((x // 16 + y // 16) % 2, 255, 60), 230, numpy.where(y < 32, 80, 255)


def make_lights(picture, folder):
    if "light" in picture:
        yield set_light(vtkLight(), picture["light"])
    if "projector" in picture:
        values = picture["projector"]
        yield set_properties(set_light(vtkProjectiveLight(), values), {
            "Positional": True, "ViewUp": values["up"], "ScreenSize": values["screen"], "EdgeWidth": values["edge"],
            "Image": read_image(os.path.join(folder, values["image"]))})


def draw(picture, folder):
    write_image(os.path.join(folder, SCREEN), squares)
    mapper = connected(vtkShadowedSliceMapper(), updated(temporal_source(picture)))
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray(picture["array"])
    set_properties(mapper, {
        "Shadows": picture["shadows"], "MaximumNumberOfShadows": picture["number_of_shadows"],
        "SliceSpacing": picture["spacing"], "AutoAdjustSampleDistances": False, "TwoSidedLighting": True})
    volume = make_volume(mapper, picture)
    volume.GetProperty().SetInterpolationTypeToLinear()
    set_properties(volume.GetProperty(), {
        "Shade": picture["shade"], "Ambient": picture["ambient"], "Diffuse": 1.0, "Specular": 0.0})
    if picture["colored"]:
        mapper.SetTransmissionColor(volume.GetProperty().GetRGBTransferFunction())
    if picture["crop"]:
        crop(mapper, mapper.GetBounds(), picture["crop"])
    renderer = make_renderer(volume, [])
    if picture["kit"]:
        vtkLightKit().AddLightsToRenderer(renderer)
    for light in make_lights(picture, folder):
        renderer.AddLight(light)
    return renderer


write_images(sys.argv[1], "shadowed_slices.json", CASES, draw)
