# SPDX-License-Identifier: BSD-3-Clause
"""Tests that each control in the panel of the plugin's representations changes the image. Controls without effect
must be hidden.
"""

import os

import numpy
from paraview import simple

from plugin_images import (
    add_array, coordinates, grid, image, load_texture, look_at, plain_view, producer, snapshot)
from plugin_testing import run

HIDDEN_VISIBILITIES = {"never", "multiblock_inspector"}
# Properties that do not affect the image of the volume, only affect speed, or belong to other data.
NOT_VISIBLE = {
    "AmbientColor", "AutoAdjustSampleDistances", "ColorArrayName", "CroppingOrigin", "CroppingScale", "DataAxesGrid",
    "InflowHelp", "Input", "IntervalAutoAdjustLevelOfDetail", "LookupTable", "MapScalars", "Pickable", "PolarAxes", "Representation",
    "Selection"}
# A new value for each property, and settings that must be made first for it to have an effect.
LIGHT = {"ProjectiveLight": 1}
LAMP = {"AreaLight": 1, "AreaLightIntensity": 2.0, "NumberOfLightSamples": 4}
PHASE = {"MultipleScattering": "Single", "ScatteringAnisotropy": 0.8}
NEARBY = {"Orientation": [0.0, 0.0, 40.0]}
TRANSFORM = {
    "Orientation": ([10.0, 20.0, 30.0], {}), "Origin": ([3.0, 0.0, 0.0], NEARBY), "Position": ([1.0, 0.0, 0.0], {}),
    "Scale": ([0.5, 1.0, 1.0], {})}
COMMON = {**TRANSFORM, "Opacity": (0.3, {}), "DiffuseColor": ([1.0, 0.0, 0.0], {"array": None})}


def picture():
    """Loads a texture."""
    return load_texture(os.path.join(
        os.path.dirname(__file__), "..", "..", "Data", "Baseline", "flow-disk.png"))


PAINT = {"InflowTexture": picture}
DETAIL = {"InflowDetailTexture": picture}
PULSES = {"InflowPulseLength": 0.5, "InflowTimePeriod": 2.0}
BY_TIME = {"InflowUseOpacityArray": 1, "InflowOpacityArray": ["POINTS", "AdvectionTime"]}
SHADED = {"InflowShade": 1, "InflowShadingArray": ["POINTS", "AdvectionTime"]}
BOUNDARY = ("IntervalBoundary", "IntervalBoundaryColor", "IntervalBoundaryColors", "IntervalBoundaryIdArrayName",
            "IntervalBoundaryOpacity", "IntervalBoundarySpecular", "IntervalBoundaryTexture")
CASES = {
    "Inflow Textures": (None, {
        **TRANSFORM, "InflowPattern": ("Bands", {}), "InflowTexture": (picture, {}), "InflowSurfaceTexture": (None, {}), "InflowSurfaceId": (None, {}),
        "InflowDefaultColor": ([1.0, 0.0, 0.0], {"InflowPattern": "None"}),
        "InflowDefaultOpacity": (0.5, {"InflowPattern": "None"}),
        "InflowOpacityUnitDistance": (0.2, {}), "InflowDetailTexture": (picture, {}), "InflowDetailMode": ("Over", DETAIL),
        "InflowDetailScale": ([5.0, 3.0, 1.0], DETAIL), "InflowPulseLength": (0.5, {"InflowTimePeriod": 2.0}),
        "InflowTimeGateTarget": ("Detail", {**DETAIL, **PULSES}), "InflowTimePeriod": (0.7, PULSES),
        "InflowTimePhase": (0.3, PULSES), "InflowUseOpacityArray": (1, {**BY_TIME, "InflowUseOpacityArray": 0}),
        "InflowOpacityArray": (["POINTS", "TerminationId"], BY_TIME), "InflowOpacityRange": ([0.0, 30.0], BY_TIME),
        "InflowShade": (1, {**SHADED, "InflowShade": 0}), "InflowShadingArray": (["POINTS", "TerminationId"], SHADED),
        "InflowShadows": (1, {}), "InflowLightBufferSize": (16, {"InflowShadows": 1}),
        "InflowUseCropping": (1, {"InflowCroppingScale": [0.5, 0.5, 0.5]}),
        "InflowCroppingOrigin": ([0.3, 0.0, 0.0], {"InflowUseCropping": 1}),
        "InflowCroppingScale": ([0.5, 0.5, 0.5], {"InflowUseCropping": 1}), "InflowPaintFilter": (0, PAINT),
        "InflowMaximumPaintSamples": (1, PAINT), "InflowSampleDistance": (0.5, PAINT),
        "InflowImageSampleDistance": (6.0, {}), "Ambient": (0.7, SHADED), "Diffuse": (0.2, SHADED),
        "Specular": (0.9, SHADED), "SpecularPower": (2.0, {**SHADED, "Specular": 1.0})}),
    "Interval Volume": (grid, {
        **COMMON, "IntervalBlendMode": ("Additive", {}), "IntervalOpacityUnitDistance": (20.0, {}),
        "IntervalDeltaTArrayName": ("value", {}), "IntervalIntegrationMode": ("Average Color", {}),
        "IntervalRenderPath": ("OpenGL", {}), "IntervalSortMode": ("None", {}),
        "IntervalLayerArrayName": ("ones", {"IntervalBlendMode": "Priority"}),
        "IntervalLayerPriorities": (["0", "3"], {"IntervalBlendMode": "Priority"}),
        **{name: (None, {}) for name in BOUNDARY}}),
    "Shadowed Slices": (image, {
        **COMMON, "Ambient": (0.7, {}), "Diffuse": (0.2, {}), "Specular": (0.9, {}), "SpecularPower": (2.0, {"Specular": 1.0}),
        "ColoredShadows": (1, {}), "ImageSampleDistance": (6.0, {}), "LightBufferSize": (16, {}),
        "LightLookup": ("Nearest", {}), "MaximumNumberOfShadows": (0, {}), "Shadows": (0, {}), "SliceSpacing": (3.0, {}), "ViewLightAngle": (40.0, {"NumberOfLightSamples": 4}),
        "ShadowedShade": (0, {}), "ShadowedTwoSidedLighting": (0, {}), "ShadowedSurfaceGradient": (1.0, {}), "ShadowedOpacityUnitDistance": (20.0, {}), "ShadowedUseCropping": (1, {
            "ShadowedCroppingScale": [0.5, 0.5, 0.5]}),
        "ShadowedCroppingOrigin": ([2.0, 0.0, 0.0], {"ShadowedUseCropping": 1}),
        "ShadowedCroppingScale": ([0.5, 0.5, 0.5], {"ShadowedUseCropping": 1}),
        "ShadowedUseSeparateOpacityArray": (1, {"ShadowedOpacityArrayName": ["POINTS", "other"]}),
        "ShadowedOpacityArrayName": (["POINTS", "value"], {"ShadowedUseSeparateOpacityArray": 1}),
        "ShadowedOpacityComponent": (1, {
            "ShadowedUseSeparateOpacityArray": 1, "ShadowedOpacityArrayName": ["POINTS", "vectors"]}),
        "ProjectiveLight": (1, {}), "ProjectiveLightColor": ([1.0, 0.0, 0.0], LIGHT),
        "ProjectiveLightEdgeWidth": (0.9, LIGHT), "ProjectiveLightScreenOpacity": (0.2, LIGHT), "ProjectiveLightInterpolate": (None, {}),
        "ProjectiveLightFocalPoint": ([8.0, 0.0, 0.0], LIGHT),
        "ProjectiveLightIntensity": (3.0, LIGHT), "ProjectiveLightPosition": ([-9.0, 20.0, 3.0], LIGHT),
        "ProjectiveLightPositional": ("Point", LIGHT), "ProjectiveLightScreenHeight": (3.0, LIGHT),
        "ProjectiveLightScreenWidth": (3.0, LIGHT), "ProjectiveLightShadows": (0, {**LIGHT, "ProjectiveLightIntensity": 9.0}),
        "ProjectiveLightViewUp": ([1.0, 1.0, 0.0], {**LIGHT, "ProjectiveLightScreenWidth": 3.0}),
        "ProjectiveLightImage": (None, {}), "SceneDepthBias": (None, {}), "SceneDepthMapResolution": (None, {}),
        "SceneShadows": (None, {}), "ShadowGridResolution": (None, {}), "AreaLight": (1, {}), "AreaLightColor": ([1.0, 0.0, 0.0], LAMP),
        "AreaLightFocalPoint": ([8.0, 0.0, 0.0], LAMP), "AreaLightHeight": (9.0, LAMP), "AreaLightImage": (None, {}),
        "AreaLightIntensity": (3.0, LAMP), "AreaLightPosition": ([-9.0, 20.0, 3.0], LAMP),
        "AreaLightPositional": ("Lamp", LAMP), "AreaLightShadows": (0, LAMP),
        "AreaLightShape": ("Square", {**LAMP, "AreaLightWidth": 9.0}),
        "AreaLightViewLights": (1.0, LAMP), "AreaLightViewUp": ([1.0, 1.0, 0.0], {**LAMP, "AreaLightWidth": 9.0}), "AreaLightWidth": (9.0, LAMP),
        "NumberOfLightSamples": (9, LAMP), "SoftShadowMethod": ("Accumulated Convolution", LAMP),
        "MultipleScattering": ("Single", {}), "ScatteringPhaseFunction": ("Henyey Greenstein", PHASE),
        "ScatteringAnisotropy": (0.3, {**PHASE, "ScatteringPhaseFunction": "Henyey Greenstein"}),
        "ScatteringPhaseTable": ([-1.0, 0.0, 1.0, 2.0], {**PHASE, "ScatteringPhaseFunction": "Table"}),
        "ScatteringBrightness": (0.5, {"MultipleScattering": "Single"}),
        "ScatteringAlbedo": ([0.0, 0.1, 0.4, 0.9, 8.0, 0.9, 0.4, 0.1], PHASE),
        "ScatteringForwardSpread": (0.5, {"MultipleScattering": "Forward"}),
        "ScatteringBackwardLayers": (1, {"MultipleScattering": "Full"}),
        "ScatteringGridSize": (4, {"MultipleScattering": "Full"})})}
# Properties that need a texture file, surfaces or several processes. TestPluginShadowedSlices,
# TestPluginAreaLight, TestPluginBoundary, TestPluginInflowTextures, TestPluginSceneShadows and
# TestPluginPieceShadows test these properties.
TESTED_IN_OTHER_SCRIPTS = {
    *BOUNDARY, "AreaLightImage", "InflowSurfaceId", "InflowSurfaceTexture", "ProjectiveLightImage", "ProjectiveLightInterpolate", "SceneDepthBias", "SceneDepthMapResolution", "SceneShadows",
    "ShadowGridResolution"}


def shows(decorator, representation):
    """Returns whether a decorator shows its widget for a representation."""
    kind = decorator.GetAttribute("type")
    if kind == "CompositeDecorator":
        expression = decorator.GetNestedElement(0)
        parts = [shows(expression.GetNestedElement(i), representation)
                 for i in range(expression.GetNumberOfNestedElements())]
        return any(parts) if expression.GetAttribute("type") == "or" else all(parts)
    if kind != "GenericDecorator" or decorator.GetAttribute("property") != "Representation":
        return True
    values = decorator.GetAttribute("values")
    values = values.split() if values else [decorator.GetAttribute("value")]
    return (representation in values) != (decorator.GetAttribute("inverse") == "1")


def is_shown(item, representation):
    """Returns whether the hints show a property or a group."""
    hints = item.GetHints()
    elements = [hints.GetNestedElement(i) for i in range(hints.GetNumberOfNestedElements())] if hints else []
    return all(shows(element, representation) for element in elements
               if element.GetName() == "PropertyWidgetDecorator")


def controls(display, representation):
    """Returns the names of the properties shown in the panel."""
    proxy = display.SMProxy
    groups = {}
    for i in range(proxy.GetNumberOfPropertyGroups()):
        group = proxy.GetPropertyGroup(i)
        for j in range(group.GetNumberOfProperties()):
            groups[group.GetProperty(j)] = group
    names = set()
    iterator = proxy.NewPropertyIterator()
    iterator.Begin()
    while not iterator.IsAtEnd():
        item, name = iterator.GetProperty(), iterator.GetKey()
        group = groups.get(item)
        visibilities = {item.GetPanelVisibility(), group.GetPanelVisibility() if group else None}
        if not (item.GetInformationOnly() or item.GetIsInternal() or visibilities & HIDDEN_VISIBILITIES):
            if is_shown(item, representation) and (group is None or is_shown(group, representation)):
                names.add(name)
        iterator.Next()
    return names


def make_data(make):
    """Returns data with a sphere. The grid has two overlapping layers, for which order and priority count."""
    data = make(9)
    points = coordinates(data)
    distance = numpy.linalg.norm(points - points.mean(axis=0), axis=1)
    add_array(data, "value", 8.0 - distance)
    add_array(data, "other", points[:, 0])
    add_array(data, "vectors", points)
    cells = data.GetNumberOfCells()
    add_array(data, "IntervalId", (numpy.arange(cells) % 2).astype(numpy.int32), False)
    add_array(data, "ones", (numpy.arange(cells) % 3).astype(numpy.int32), False)
    return data


def make_source(make):
    """Returns a source of generated data, or a flow field."""
    if make:
        return producer(make_data(make))
    flow = simple.AnalyticFlow()
    flow.UpdatePipeline()
    return simple.ImplicitFlowField(Input=flow)


def set_value(display, name, value):
    value = value() if callable(value) else value
    if name == "array":
        simple.ColorBy(display, value)
    else:
        setattr(display, name, value)


def check_control(checks, source, view, images, representation, name, value, first):
    """Compares with the image before the change. Controls with the same settings before share it in images."""
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0, 0, 1], [0, 0, 0], [0, 1, 0]
    display = simple.Show(source, view)
    display.SetRepresentationType(representation)
    if source.PointData["value"]:
        simple.ColorBy(display, ["POINTS", "value"])
    for key, setting in first.items():
        set_value(display, key, setting)
    look_at(view)
    settings = repr(first)
    if settings not in images:
        images[settings] = snapshot(view)
    before = images[settings]
    set_value(display, name, value)
    change = numpy.abs(snapshot(view) - before).max()
    checks.that(change > 0, f"{representation}, {name} changes the image")
    checks.that(before.max() > 0, f"{representation}, {name}, the image before is not empty")
    simple.Delete(display)


def main(checks):
    for representation, (make, values) in CASES.items():
        source = make_source(make)
        view = plain_view()
        view.ViewSize = [150, 150]
        display = simple.Show(source, view)
        display.SetRepresentationType(representation)
        if display.SMProxy.GetProperty("Translation"):
            values["Translation"] = values.pop("Position")  # the name in ParaView 5.12 or later
        shown = controls(display, representation) - NOT_VISIBLE
        simple.Delete(display)
        checks.equal(sorted(shown - set(values)), [], f"{representation}, controls without effect")
        checks.equal(sorted(set(values) - shown), [], f"{representation}, hidden controls")
        images = {}
        for name in sorted(shown & set(values) - TESTED_IN_OTHER_SCRIPTS):
            check_control(checks, source, view, images, representation, name, *values[name])
        simple.Delete(view)


run(main)
