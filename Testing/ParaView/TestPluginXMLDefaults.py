# SPDX-License-Identifier: BSD-3-Clause
"""TestPluginXMLDefaults.py FOLDER: the defaults in the plugin's XML in FOLDER are those of the C++ classes, for
every property: what its command sets is what a fresh object gets. Properties without a default start
empty, or have a domain that takes the value from the data. What is different on purpose is listed.
"""

import glob
import os
import sys
from xml.etree import ElementTree

import interlume

# Domains that give the value from the data.
DATA_DOMAINS = {"ArrayRangeDomain", "ProposedRangeDomain", "DataTypeDomain", "ArrayListDomain", "BoundsDomain",
                "ProxyListDomain", "InputArrayDomain", "RepresentedArrayListDomain", "DataAssemblyListDomain",
                "DataAssemblyDomain"}
# What stands for a class of the plugin that Python does not have.
STAND_INS = {
    "vtkPVImplicitFlowField": "vtkImplicitFlowField", "vtkPVInflowMapping": "vtkInflowMapping",
    "vtkPVStreamSurfaceParameters": "vtkStreamSurfaceParameters", "vtkPVTerminationBox": "vtkTerminationBox",
    "vtkPVTerminationRectangle": "vtkTerminationPlane", "vtkPVTerminationCylinder": "vtkTerminationCylinder",
    "vtkPVTerminationTube": "vtkTerminationTube", "vtkPieceSliceMapper": "vtkShadowedSliceMapper"}
# The widget, and what has its properties from a compared proxy.
NOT_COMPARED = {"vtkTimeSlabWriter", "vtkAreaLightRepresentation", "vtk3DWidgetRepresentation", None}


def middle_of_points(surface):
    return [0.5 * (a + b) for a, b in zip(surface.GetPoint1(), surface.GetPoint2())]


def end_of_cylinder(number):
    return lambda tube: getattr(interlume.vtkTerminationCylinder(), f"GetPoint{number}")()


def box_bounds(box):
    bounds = [0.0] * 6
    box.GetBounds(bounds)
    return bounds


# What has no getter, is of another class, or differs: the value, or a function of a fresh object.
LISTED = {
    "vtkPVImplicitFlowField": {
        "TubeRadius": lambda field: interlume.vtkTerminationTube().GetRadius(),
        "MeshPeriodicU": lambda field: interlume.vtkTerminationMesh().GetPeriodicU(),
        "MeshPeriodicV": lambda field: interlume.vtkTerminationMesh().GetPeriodicV(), "CheckpointFileName": ""},
    "vtkPVInflowMapping": {
        "Formula": lambda mapping: mapping.GetFormula(mapping.ALL), "ImageId": lambda mapping: mapping.ALL,
        "FormulasById": [], "Rings": lambda mapping: [] if mapping.GetNumberOfRings(mapping.ALL) == 0 else None},
    # Lengths of 0 are those of the field, or 1 where there is none.
    "vtkPVTerminationRectangle": {"Center": middle_of_points, "Normal": [0, 0, 1], "Lengths": [0, 0], "Angle": 0},
    "vtkPVTerminationCylinder": {"Center": middle_of_points, "Axis": [0, 0, 1], "Length": 0},
    "vtkPVTerminationBox": {
        "Position": lambda box: box_bounds(box)[0::2],
        "Lengths": lambda box: [high - low for low, high in zip(box_bounds(box)[0::2], box_bounds(box)[1::2])]},
    "vtkPVTerminationTube": {"Start": end_of_cylinder(1), "End": end_of_cylinder(2)},
    "vtkTimeVaryingIntervalVolume": {
        "Boundaries": lambda volume: [kind for kind in range(8)
                                      if volume.GetGenerateBoundary(kind)]},
    # DeltaT where there is one, and the layers' numbers as priorities.
    "vtkIntervalVolumeRepresentation": {
        "IntervalDeltaTArrayName":
            lambda _: interlume.vtkTimeWeightedTetrahedraMapper().GetDeltaTArrayName() or "DeltaT"},
    "vtkTimeWeightedTetrahedraMapper": {
        "IntervalLayerPriorities": lambda mapper: [] if mapper.GetLayerPriority(3) == 3.0 else None},
    "vtkProjectiveLight": {"ProjectiveLightColor": lambda light: light.GetDiffuseColor()},
    "vtkAreaLight": {"AreaLightColor": lambda light: light.GetDiffuseColor()},
    # A light kit has five lights: one shadow at first, and shading, without which they are too bright;
    # scattered light is as bright as surfaces.
    "vtkPieceSliceMapper": {
        "MaximumNumberOfShadows": 1, "ShadowedTwoSidedLighting": 1, "ScatteringBrightness": 0.35},
    "vtkShadowedSliceRepresentation": {
        "Ambient": 0, "Diffuse": 1, "Specular": 0, "SpecularPower": 100, "ShadowedShade": 1, "ColoredShadows": 0,
        "SceneShadows": 0, "ShadowGridResolution": 64, "ViewLightAngle": 0,
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
    """Whether a text of the XML, or None, is a value of C++."""
    if value is None or isinstance(value, str):
        return given == value
    values = [*value] if isinstance(value, (list, tuple)) else [value]
    return given is not None and [*map(float, given.split())] == values or given is None and values == []


def takes_value_from_data(element):
    return any(child.tag in DATA_DOMAINS for child in element) or element.get("is_internal") == "1"


def faults_of(element, made, listed):
    """What is wrong with a property of a class, of which `made` is a fresh object or None."""
    name, given = element.get("name"), element.get("default_values")
    rows = element.get("set_number_command") or element.get("clean_command") or ""
    number = getattr(made, "GetNumberOf" + rows.replace("SetNumberOf", "").replace("RemoveAll", ""), None)
    if number and name not in listed and number() != 0:
        yield f"{name}: a fresh object has {number()}"
    getter = getattr(made, "Get" + element.get("command", "Set")[3:], None)
    if name in listed:
        value = listed[name](made) if callable(listed[name]) else listed[name]
    elif getter and given is not None and element.get("repeat_command") != "1":
        value = getter()
    else:
        if not takes_value_from_data(element) and (given is not None or element.get("number_of_elements") != "0"):
            yield f"{name}: is neither compared nor taken from the data"
        return
    if not is_same(given, value):
        yield f"{name}: XML {given!r}, C++ {value!r}"


def properties_of(proxy, proxies):
    """Its own, and those of the proxy it is based on, if that is the plugin's and not a display's."""
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
    faults, compared = [], 0
    for (group, _), proxy in proxies.items():
        kind = proxy.get("class")
        if kind in NOT_COMPARED or group.startswith("internal_"):
            continue
        made = getattr(interlume, STAND_INS.get(kind, kind), None)
        listed = LISTED.get(kind, {})
        properties = properties_of(proxy, proxies)
        unknown = set(listed) - {element.get("name") for element in properties}
        faults += [f"{kind}.{name} is listed, but is no property" for name in unknown]
        if not made and not listed and kind != "vtkTetrahedralMesher":
            faults.append(f"{kind} is not known")
            continue
        for element in properties if made or listed else []:
            compared += 1
            faults += [f"{kind}.{fault}" for fault in faults_of(element, made() if made else None, listed)]
    print(compared, "properties")
    sys.exit("\n".join(faults) if faults else 0)


main()
