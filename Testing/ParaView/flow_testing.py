# SPDX-License-Identifier: BSD-3-Clause
"""Creates the flow filters of Extractions/pipelines.py from the same descriptions."""

from paraview import servermanager, simple

from plugin_testing import set_properties, temporal_source


def termination_surface(description):
    """Returns a proxy of the group termination_surfaces."""
    group = servermanager.ProxyNamespace(
        ["termination_surfaces"], servermanager.ActiveConnection.Session)
    surface = getattr(group, description["kind"])()
    set_properties(surface, description["properties"])
    return surface


def surface_mesh(description):
    """Returns a triangle mesh of a termination surface."""
    return simple.TerminationSurface(Surface=termination_surface(description))


def vortex_axis(flow, extraction):
    axis = simple.VortexAxis(Input=flow)
    set_properties(axis, extraction["axis"])
    return axis


def analytic_flow(extraction):
    return temporal_source("AnalyticFlow", extraction["source_properties"])


def flow_field(flow, extraction):
    field = simple.ImplicitFlowField(Input=flow)
    field.RefinementLevels, field.HideUnreached = 0, 0  # as in C++
    surfaces = [termination_surface(description) for description in extraction["surfaces"]]
    field.TerminationSurface = surfaces if surfaces else "None"
    further = [surface_mesh(description) for description in extraction["meshes"]]
    if "axis" in extraction:
        further.append(vortex_axis(flow, extraction))
        field.TubeRadius = extraction["TubeRadius"]
    if further:
        field.Surfaces = further
    set_properties(field, extraction["field"])
    return field


def as_text(rows):
    """Returns the values of a table row by row, as text."""
    return [str(value) for row in rows for value in row]


def inflow_mapping(field, extraction):
    mapping = simple.InflowMapping(Input=field)
    for name, value in extraction["mapping"].items():
        setattr(mapping, name, value if name == "Formula" else as_text(value))
    if "image" in extraction:
        mapping.Image = simple.Wavelet(WholeExtent=extraction["image"])
        mapping.ImageId = extraction["ImageId"]
    return mapping


def stream_texture(volume, extraction):
    texture = simple.StreamSurfaceParameters(Input=simple.OutputPort(volume, 1))
    set_properties(texture, extraction["texture"])
    return texture


def stream_lic(volume, flow, extraction):
    lic = simple.FlowLIC(Input=simple.OutputPort(volume, 1), Field=flow)
    set_properties(lic, extraction["lic"])
    return lic


def flow_volume(mapping, extraction):
    volume = simple.FlowVolume(Input=mapping, Intervals=[])
    set_properties(volume, extraction["volume"])
    return volume
