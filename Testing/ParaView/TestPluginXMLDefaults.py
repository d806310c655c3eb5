# SPDX-License-Identifier: BSD-3-Clause
"""TestPluginXMLDefaults.py FOLDER: tests that the defaults in the plugin's XML in FOLDER equal the defaults of the
C++ classes for every property. Properties without a default start empty or have a domain that reads the value from
the data. Intended differences are listed here.
"""

import glob
import os
import sys
from xml.etree import ElementTree

import interlume

# Domains that read the value from the data.
DATA_DOMAINS = {"ArrayRangeDomain", "ProposedRangeDomain", "DataTypeDomain", "ArrayListDomain", "BoundsDomain",
                "ProxyListDomain", "InputArrayDomain", "RepresentedArrayListDomain", "DataAssemblyListDomain",
                "DataAssemblyDomain"}
# Replacements for classes of the plugin that Python does not have.
STAND_INS = {
    "vtkPVImplicitFlowField": "vtkImplicitFlowField", "vtkPVInflowMapping": "vtkInflowMapping",
    "vtkPVStreamSurfaceParameters": "vtkStreamSurfaceParameters", "vtkPVTerminationBox": "vtkTerminationBox",
    "vtkPVTerminationRectangle": "vtkTerminationPlane", "vtkPVTerminationCylinder": "vtkTerminationCylinder",
    "vtkPVTerminationTube": "vtkTerminationTube", "vtkPieceSliceMapper": "vtkShadowedSliceMapper",
    "vtkProperty": "vtkTimeWeightedTetrahedraMapper"}
# Classes that are not compared: the widget, and classes whose properties belong to a compared
# proxy.
NOT_COMPARED = {"vtkTimeSlabWriter", "vtkAreaLightRepresentation", "vtk3DWidgetRepresentation", None}


def center_of_points(surface):
    return [0.5 * (a + b) for a, b in zip(surface.GetPoint1(), surface.GetPoint2())]


def end_of_cylinder(number):
    return lambda tube: getattr(interlume.vtkTerminationCylinder(), f"GetPoint{number}")()


def box_bounds(box):
    bounds = [0.0] * 6
    box.GetBounds(bounds)
    return bounds


# Values, or functions of a new object, for properties that have no getter, belong to another
# class, or differ from C++.
LISTED = {
    "vtkPVImplicitFlowField": {
        "TubeRadius": lambda field: interlume.vtkTerminationTube().GetRadius(),
        "MeshPeriodicU": lambda field: interlume.vtkTerminationMesh().GetPeriodicU(),
        "MeshPeriodicV": lambda field: interlume.vtkTerminationMesh().GetPeriodicV(), "CheckpointFileName": "",
        # First images in ParaView have no gaps that cuts can close.
        "RefinementLevels": lambda field: field.CUT_BOUNDARY, "HideUnreached": 1},
    # Slices become fine enough for streaks, and show those of flow across them.
    "vtkFlowLIC": {"RefineSurface": 1, "ProjectVectors": 1},
    "vtkPVInflowMapping": {
        "Formula": lambda mapping: mapping.GetFormula(mapping.ALL), "ImageId": lambda mapping: mapping.ALL,
        "FormulasById": [], "Rings": lambda mapping: [] if mapping.GetNumberOfRings(mapping.ALL) == 0 else None},
    # Lengths of 0 mean the size of the field, or 1 without a field.
    "vtkPVTerminationRectangle": {"Center": center_of_points, "Normal": [0, 0, 1], "Lengths": [0, 0], "Angle": 0},
    "vtkPVTerminationCylinder": {"Center": center_of_points, "Axis": [0, 0, 1], "Length": 0},
    "vtkPVTerminationBox": {
        "Position": lambda box: box_bounds(box)[0::2],
        "Lengths": lambda box: [high - low for low, high in zip(box_bounds(box)[0::2], box_bounds(box)[1::2])]},
    "vtkPVTerminationTube": {"Start": end_of_cylinder(1), "End": end_of_cylinder(2)},
    "vtkTimeVaryingIntervalVolume": {
        "Boundaries": lambda volume: [kind for kind in range(8)
                                      if volume.GetGenerateBoundary(kind)]},
    # The proxy names the array DeltaT, and layer numbers are the default priorities.
    "vtkIntervalVolumeRepresentation": {
        "IntervalDeltaTArrayName":
            lambda _: interlume.vtkTimeWeightedTetrahedraMapper().GetDeltaTArrayName() or "DeltaT"},
    # The array of the filter of the same name.
    "vtkTimeWeightedTetrahedraMapper": {
        "IntervalBoundaryIdArrayName": "BoundarySide",
        "IntervalBoundaryTexture": lambda mapper: mapper.GetBoundaryTexture(),
        "IntervalLayerPriorities": lambda mapper: [] if mapper.GetLayerPriority(3) == 3.0 else None},
    # The property of the boundary.
    "vtkProperty": {
        f"IntervalBoundary{name}": lambda mapper, name=name: getattr(mapper.GetBoundaryProperty(), "Get" + name)()
        for name in ("Color", "Opacity", "Specular")},
    # The representation draws as vtkStreamSurfaceMapper, a class that it does not use.
    "vtkStreamSurfaceRepresentation": {
        "Streamlines": lambda _: interlume.vtkStreamSurfaceMapper().GetStreamlines(),
        "Timelines": lambda _: interlume.vtkStreamSurfaceMapper().GetTimelines()},
    "vtkProjectiveLight": {"ProjectiveLightColor": lambda light: light.GetDiffuseColor()},
    "vtkAreaLight": {"AreaLightColor": lambda light: light.GetDiffuseColor()},
    # A light kit has five lights. By default, only one of them casts shadows. Shading is on,
    # because volumes would otherwise be too bright. Scattered light is as bright as surfaces.
    "vtkPieceSliceMapper": {
        "MaximumNumberOfShadows": 1, "ShadowedTwoSidedLighting": 1, "ScatteringBrightness": 0.35},
    "vtkShadowedSliceRepresentation": {
        "Ambient": 0, "Diffuse": 1, "Specular": 0, "SpecularPower": 100, "ShadowedShade": 1, "ColoredShadows": 0,
        "SceneShadows": 0, "ShadowGridResolution": 64, "ViewLightAngle": 0, "AreaLightViewLights": 0.3,
        "SceneDepthMapResolution": lambda _: interlume.vtkShadowedScenePass().GetDepthMapResolution(),
        "SceneDepthBias": lambda _: interlume.vtkShadowedScenePass().GetDepthBias(),
        "ShadowedUseSeparateOpacityArray": 0, "ShadowedOpacityComponent": 0,
        "ShadowedUseCropping": lambda _: interlume.vtkShadowedSliceMapper().GetCropping(),
        "ShadowedCroppingOrigin": [0, 0, 0], "ShadowedCroppingScale": [1, 1, 1], "ProjectiveLight": 0, "AreaLight": 0,
        "ProjectiveLightImage": lambda _: interlume.vtkProjectiveLight().GetImage(),
        "AreaLightImage": lambda _: interlume.vtkAreaLight().GetEmitter(),
        "ScatteringPhaseTable": lambda _: interlume.vtkShadowedSliceMapper().GetPhaseTable(),
        "ScatteringAlbedo": lambda _: interlume.vtkShadowedSliceMapper().GetScatteringAlbedo()},
    "vtkInflowTextureRepresentation": {
        "Ambient": 0, "Diffuse": 1, "Specular": 0, "SpecularPower": 100, "InflowSurfaceId": 0, "InflowShade": 0,
        "InflowPattern": 1,
        "InflowCroppingOrigin": [0, 0, 0], "InflowCroppingScale": [1, 1, 1],
        "InflowTexture": lambda _: interlume.vtkImplicitFlowVolumeMapper().GetNumberOfInflowTextures() or None,
        "InflowSurfaceTexture": lambda _: interlume.vtkImplicitFlowVolumeMapper().GetInflowTexture(0),
        "InflowDefaultColor": lambda _: interlume.vtkImplicitFlowVolumeMapper().GetDefaultColor()[:3],
        "InflowDefaultOpacity": lambda _: interlume.vtkImplicitFlowVolumeMapper().GetDefaultColor()[3],
        "InflowDetailTexture": lambda _: interlume.vtkImplicitFlowVolumeMapper().GetDetailTexture(),
        "InflowPulseLength": lambda _: 0 if interlume.vtkImplicitFlowVolumeMapper().GetTimeGate() else 1,
        "InflowUseOpacityArray": lambda _: len(interlume.vtkImplicitFlowVolumeMapper().GetOpacityArray() or ""),
        "InflowUseCropping": lambda _: interlume.vtkImplicitFlowVolumeMapper().GetCropping()},
}


def is_same(given, value):
    """Returns whether a text of the XML, which may be None, equals a value of C++."""
    if value is None or isinstance(value, str):
        return given == value
    values = [*value] if isinstance(value, (list, tuple)) else [value]
    return given is not None and [*map(float, given.split())] == values or given is None and values == []


def reads_value_from_data(element):
    return any(child.tag in DATA_DOMAINS for child in element) or element.get("is_internal") == "1"


def errors_of(element, instance, listed):
    """Yields errors of a property; `instance` is a new object of the class, or None."""
    name, given = element.get("name"), element.get("default_values")
    rows = element.get("set_number_command") or element.get("clean_command") or ""
    number = getattr(instance, "GetNumberOf" + rows.replace("SetNumberOf", "").replace("RemoveAll", ""), None)
    if number and name not in listed and number() != 0:
        yield f"{name}: a new object has {number()}"
    getter = getattr(instance, "Get" + element.get("command", "Set")[3:], None)
    if name in listed:
        value = listed[name](instance) if callable(listed[name]) else listed[name]
    elif getter and given is not None and element.get("repeat_command") != "1":
        value = getter()
    else:
        if not reads_value_from_data(element) and (given is not None or element.get("number_of_elements") != "0"):
            yield f"{name}: is neither compared nor read from the data"
        return
    if not is_same(given, value):
        yield f"{name}: XML {given!r}, C++ {value!r}"


def properties_of(proxy, proxies):
    """Returns the properties of a proxy and of its base proxy, unless that is a display or not part of the
    plugin."""
    group = proxy.get("base_proxygroup")
    base = proxies.get((group, proxy.get("base_proxyname"))) if group != "internal_representations" else None
    inherited = properties_of(base, proxies) if base is not None else []
    own = [element for element in proxy if element.tag.endswith("Property") and not element.get("information_only")]
    return [*inherited, *own]


def main():
    proxies = {}
    for path in sorted(glob.glob(os.path.join(sys.argv[1], "*.xml"))):
        for group in ElementTree.parse(path).getroot().iter("ProxyGroup"):
            for proxy in group:
                proxies[group.get("name"), proxy.get("name")] = proxy
    errors, compared = [], 0
    for (group, _), proxy in proxies.items():
        kind = proxy.get("class")
        if kind in NOT_COMPARED or group.startswith("internal_"):
            continue
        instance = getattr(interlume, STAND_INS.get(kind, kind), None)
        listed = LISTED.get(kind, {})
        properties = properties_of(proxy, proxies)
        unknown = set(listed) - {element.get("name") for element in properties}
        errors += [f"{kind}.{name} is listed but is not a property" for name in unknown]
        if not instance and not listed and kind != "vtkTetrahedralMesher":
            errors.append(f"{kind} has no class in Python and no listed values")
            continue
        for element in properties if instance or listed else []:
            compared += 1
            errors += [f"{kind}.{error}" for error in errors_of(element, instance() if instance else None, listed)]
    print(compared, "properties")
    sys.exit("\n".join(errors) if errors else 0)


main()
