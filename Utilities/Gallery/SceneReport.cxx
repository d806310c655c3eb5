// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/SceneReport.h"

#include <nlohmann/json.hpp>

#include <vector>

namespace gallery
{
namespace
{
const char* GetName(const std::vector<const char*>& names, int mode)
{
  return names.at(static_cast<std::size_t>(mode));
}

nlohmann::json ToJson(const vtkTetrahedraReport& volume)
{
  return { { "path", GetName({ "opengl", "software" }, volume.RenderPath) },
    { "blend",
      GetName(
        { "composite", "maximum", "additive", "priority", "optical-depth" }, volume.BlendMode) },
    { "sort", GetName({ "none", "centroid", "mpvonc" }, volume.SortMode) },
    { "sort_reason", volume.SortReason }, { "sorted", volume.Sorted },
    { "adjacency", volume.HasAdjacency }, { "features", volume.Features },
    { "tetrahedra", volume.Tetrahedra }, { "tetrahedra_drawn", volume.TetrahedraDrawn },
    { "boundary_triangles", volume.BoundaryTriangles }, { "passes", volume.Passes },
    { "layers", volume.Layers }, { "cycles", volume.Cycles }, { "gaps", volume.Gaps },
    { "control_points", volume.ControlPoints }, { "pixel_stride", volume.PixelStride },
    { "buffers", volume.Buffers }, { "buffer_bytes", volume.BufferBytes },
    { "memory_bytes", volume.MemoryBytes },
    { "uploaded_bytes",
      volume.UploadedStaticBytes + volume.UploadedOrderBytes + volume.UploadedImageBytes },
    { "seconds", volume.Seconds } };
}

nlohmann::json ToJson(const vtkShadowedSliceReport& volume)
{
  return { { "features", volume.Features }, { "lights", volume.Lights },
    { "shadowed_lights", volume.ShadowedLights }, { "sweeps", volume.Sweeps },
    { "front_to_back_sweeps", volume.FrontToBackSweeps }, { "slices", volume.Slices },
    { "slices_drawn", volume.SlicesDrawn }, { "slice_spacing", volume.SliceSpacing },
    { "eye_passes", volume.EyePasses }, { "light_passes", volume.LightPasses },
    { "occlusion_passes", volume.OcclusionPasses }, { "image_buffers", volume.ImageBuffers },
    { "image_buffer_bytes", volume.ImageBufferBytes }, { "light_buffers", volume.LightBuffers },
    { "light_buffer_bytes", volume.LightBufferBytes },
    { "light_buffer_size", volume.LightBufferSize }, { "light_channels", volume.LightChannels },
    { "blocks", volume.Blocks }, { "blocks_drawn", volume.BlocksDrawn },
    { "texture_bytes", volume.TextureBytes }, { "uploaded_bytes", volume.UploadedBytes },
    { "image_sample_distance", volume.ImageSampleDistance }, { "seconds", volume.Seconds } };
}

nlohmann::json ToJson(const vtkImplicitFlowVolumeReport& volume)
{
  return { { "features", volume.Features }, { "surfaces", volume.Surfaces },
    { "uniform_cells", volume.UniformCells }, { "split_cells", volume.SplitCells },
    { "empty_cells", volume.EmptyCells }, { "textures", volume.Textures },
    { "texture_bytes", volume.TextureBytes }, { "passes", volume.Passes },
    { "image_buffer_bytes", volume.ImageBufferBytes }, { "sample_distance", volume.SampleDistance },
    { "seconds", volume.Seconds } };
}
}

void SceneReport::AddVolume(const vtkTetrahedraReport& volume)
{
  this->Features.insert("volumes");
  this->Passes += volume.Passes;
  this->Buffers += volume.Buffers;
  this->Bytes += volume.BufferBytes;
  this->Volumes.push_back(volume);
}

void SceneReport::AddVolume(const vtkShadowedSliceReport& volume)
{
  this->Features.insert("slices");
  if (volume.ShadowedLights > 0)
  {
    this->Features.insert("shadows");
  }
  this->Passes += volume.EyePasses + volume.LightPasses + volume.OcclusionPasses;
  this->Buffers += volume.ImageBuffers + volume.LightBuffers;
  this->Bytes += volume.ImageBufferBytes + volume.LightBufferBytes;
  this->SlicedVolumes.push_back(volume);
}

void SceneReport::AddVolume(const vtkImplicitFlowVolumeReport& volume)
{
  this->Features.insert("inflow-textures");
  this->Passes += volume.Passes;
  this->Buffers += 1;
  this->Bytes += volume.ImageBufferBytes;
  this->InflowVolumes.push_back(volume);
}

nlohmann::json ToJson(const SceneReport& report)
{
  const vtkExtractionReport& extraction = report.Extraction;
  nlohmann::json volumes = nlohmann::json::array();
  for (const vtkTetrahedraReport& volume : report.Volumes)
  {
    volumes.push_back(ToJson(volume));
  }
  nlohmann::json slicedVolumes = nlohmann::json::array();
  for (const vtkShadowedSliceReport& volume : report.SlicedVolumes)
  {
    slicedVolumes.push_back(ToJson(volume));
  }
  nlohmann::json inflowVolumes = nlohmann::json::array();
  for (const vtkImplicitFlowVolumeReport& volume : report.InflowVolumes)
  {
    inflowVolumes.push_back(ToJson(volume));
  }
  return { { "id", report.Id }, { "figure", report.Figure },
    { "size", { report.Width, report.Height } },
    { "seconds", report.BuildSeconds + report.RenderSeconds },
    { "build_seconds", report.BuildSeconds }, { "extract_seconds", report.ExtractSeconds },
    { "render_seconds", report.RenderSeconds }, { "frames", report.Frames },
    { "frame_seconds", report.FrameSeconds }, { "movie", report.HasMovie },
    { "features", report.Features }, { "panels", report.Panels },
    { "surface_panels", report.SurfacePanels }, { "occlusion_panels", report.OcclusionPanels },
    { "passes", report.Passes }, { "buffers", report.Buffers }, { "bytes", report.Bytes },
    { "volumes", volumes }, { "sliced_volumes", slicedVolumes },
    { "inflow_volumes", inflowVolumes }, { "filters", report.Filters },
    { "intervals", report.Intervals }, { "criteria", report.Criteria },
    { "tetrahedra", report.Tetrahedra }, { "boundary_triangles", report.BoundaryTriangles },
    { "slabs", report.Slabs }, { "simplices", report.Simplices },
    { "flow_cells", report.FlowCells }, { "flow_cells_left_out", report.FlowCellsLeftOut },
    { "inflow_passes", report.InflowPasses }, { "time_passes", report.TimePasses },
    { "extraction",
      { { "cells", extraction.Cells }, { "cells_visited", extraction.CellsVisited },
        { "cells_with_output", extraction.CellsWithOutput },
        { "lower_dimensional_cells", extraction.LowerDimensionalCells },
        { "non_finite_cells", extraction.NonFiniteCells },
        { "blanked_cells", extraction.BlankedCells },
        { "linearized_cells", extraction.LinearizedCells },
        { "unsupported_cells", extraction.UnsupportedCells },
        { "collapsed_simplices", extraction.CollapsedSimplices },
        { "arrays_interpolated", extraction.ArraysInterpolated },
        { "arrays_copied", extraction.ArraysCopied }, { "passes", extraction.Passes },
        { "working_bytes", extraction.WorkingBytes } } } };
}
}
