// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/SceneReport.h"

#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkStringArray.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <vector>

namespace gallery
{
namespace
{
/// Values in the reports of extraction filters for which the maximum over all filters is reported,
/// not the sum.
const std::set<std::string> LARGEST{ "ArraysInterpolated", "ArraysCopied", "Passes",
  "WorkingBytes" };

/// Returns the JSON key of a value: "tetrahedra_drawn" for "TetrahedraDrawn".
std::string GetKey(const std::string& name)
{
  std::string key;
  for (char letter : name)
  {
    key += std::isupper(letter) && !key.empty() ? "_" : "";
    key += static_cast<char>(std::tolower(letter));
  }
  return key;
}

nlohmann::json ValueToJson(vtkInterlumeReport* report, const std::string& name)
{
  if (vtkStringArray::SafeDownCast(report->GetAbstractArray(name.c_str())))
  {
    return report->GetText(name);
  }
  const double number = report->GetNumber(name);
  return vtkIdTypeArray::SafeDownCast(report->GetArray(name.c_str()))
    ? nlohmann::json(static_cast<vtkIdType>(number))
    : nlohmann::json(number);
}

nlohmann::json ToJson(vtkInterlumeReport* report, std::initializer_list<const char*> names)
{
  nlohmann::json values;
  for (const char* name : names)
  {
    values[GetKey(name)] = ValueToJson(report, name);
  }
  return values;
}

/// Returns the entry of \a names whose index is stored as \a value in \a report.
const char* GetMode(
  vtkInterlumeReport* report, const char* value, const std::vector<const char*>& names)
{
  return names.at(static_cast<std::size_t>(report->GetNumber(value)));
}

nlohmann::json VolumeToJson(vtkInterlumeReport* volume)
{
  nlohmann::json values = ToJson(volume,
    { "SortReason", "Features", "Tetrahedra", "TetrahedraDrawn", "BoundaryTriangles", "Passes",
      "Layers", "Cycles", "Gaps", "ControlPoints", "PixelStride", "Buffers", "BufferBytes",
      "MemoryBytes", "Seconds" });
  values["path"] = GetMode(volume, "RenderPath", { "opengl", "software" });
  values["blend"] = GetMode(
    volume, "BlendMode", { "composite", "maximum", "additive", "priority", "optical-depth" });
  values["sort"] = GetMode(volume, "SortMode", { "none", "centroid", "mpvonc" });
  values["sorted"] = volume->GetNumber("Sorted") > 0;
  values["adjacency"] = volume->GetNumber("HasAdjacency") > 0;
  values["uploaded_bytes"] = static_cast<vtkIdType>(
    SumValues(volume, { "UploadedStaticBytes", "UploadedOrderBytes", "UploadedImageBytes" }));
  return values;
}

nlohmann::json SlicedVolumeToJson(vtkInterlumeReport* volume)
{
  nlohmann::json values = ToJson(volume,
    { "Features", "Lights", "ShadowedLights", "Sweeps", "FrontToBackSweeps", "Slices",
      "SlicesDrawn", "SliceSpacing", "LightPasses", "OcclusionPasses", "ImageBuffers",
      "ImageBufferBytes", "LightBuffers", "LightBufferBytes", "LightBufferSize", "LightChannels",
      "Blocks", "BlocksDrawn", "TextureBytes", "UploadedBytes", "ImageSampleDistance", "Seconds" });
  values["eye_passes"] = ValueToJson(volume, "ImagePasses");
  return values;
}

nlohmann::json InflowVolumeToJson(vtkInterlumeReport* volume)
{
  return ToJson(volume,
    { "Features", "Surfaces", "UniformCells", "SplitCells", "EmptyCells", "Textures",
      "TextureBytes", "Passes", "ImageBufferBytes", "SampleDistance", "Seconds" });
}

nlohmann::json ToJson(const SceneReport::VolumeReports& volumes,
  nlohmann::json (*volumeToJson)(vtkInterlumeReport* volume))
{
  nlohmann::json list = nlohmann::json::array();
  for (vtkInterlumeReport* volume : volumes)
  {
    list.push_back(volumeToJson(volume));
  }
  return list;
}

nlohmann::json ToJson(const std::map<std::string, vtkIdType>& numbers)
{
  nlohmann::json values;
  for (const auto& [name, number] : numbers)
  {
    values[GetKey(name)] = number;
  }
  return values;
}

void Append(SceneReport::VolumeReports& volumes, vtkInterlumeReport* volume)
{
  volumes.push_back(vtkSmartPointer<vtkInterlumeReport>::New());
  volumes.back()->DeepCopy(volume);
}
}

double SumValues(vtkInterlumeReport* report, std::initializer_list<const char*> names)
{
  double sum = 0.0;
  for (const char* name : names)
  {
    // For an unknown name, GetNumber() is called once to report the error.
    const vtkIdType size = report->Has(name) ? report->GetSize(name) : 1;
    for (vtkIdType entry = 0; entry < size; ++entry)
    {
      sum += report->GetNumber(name, entry);
    }
  }
  return sum;
}

void SceneReport::AddExtraction(vtkInterlumeReport* filter)
{
  for (auto& [name, value] : this->Extraction)
  {
    const auto number = filter->GetCount(name);
    value = LARGEST.count(name) > 0 ? std::max(value, number) : value + number;
  }
}

void SceneReport::AddVolume(vtkInterlumeReport* volume)
{
  this->Features.insert("volumes");
  this->Passes += volume->GetNumber("Passes");
  this->Buffers += volume->GetNumber("Buffers");
  this->Bytes += volume->GetNumber("BufferBytes");
  Append(this->Volumes, volume);
}

void SceneReport::AddSlicedVolume(vtkInterlumeReport* volume)
{
  this->Features.insert("slices");
  if (volume->GetNumber("ShadowedLights") > 0)
  {
    this->Features.insert("shadows");
  }
  this->Passes += SumValues(volume, { "ImagePasses", "LightPasses", "OcclusionPasses" });
  this->Buffers += SumValues(volume, { "ImageBuffers", "LightBuffers" });
  this->Bytes += SumValues(volume, { "ImageBufferBytes", "LightBufferBytes" });
  Append(this->SlicedVolumes, volume);
}

void SceneReport::AddInflowVolume(vtkInterlumeReport* volume)
{
  this->Features.insert("inflow-textures");
  this->Passes += volume->GetNumber("Passes");
  this->Buffers += 1;
  this->Bytes += volume->GetNumber("ImageBufferBytes");
  Append(this->InflowVolumes, volume);
}

nlohmann::json ToJson(const SceneReport& report)
{
  return { { "id", report.Id }, { "figure", report.Figure },
    { "size", { report.Width, report.Height } },
    { "seconds", report.BuildSeconds + report.RenderSeconds },
    { "build_seconds", report.BuildSeconds }, { "extract_seconds", report.ExtractSeconds },
    { "render_seconds", report.RenderSeconds }, { "frames", report.Frames },
    { "frame_seconds", report.FrameSeconds }, { "movie", report.HasMovie },
    { "features", report.Features }, { "panels", report.Panels },
    { "surface_panels", report.SurfacePanels }, { "occlusion_panels", report.OcclusionPanels },
    { "passes", report.Passes }, { "buffers", report.Buffers }, { "bytes", report.Bytes },
    { "volumes", ToJson(report.Volumes, &VolumeToJson) },
    { "sliced_volumes", ToJson(report.SlicedVolumes, &SlicedVolumeToJson) },
    { "inflow_volumes", ToJson(report.InflowVolumes, &InflowVolumeToJson) },
    { "filters", report.Filters }, { "intervals", report.Intervals },
    { "criteria", report.Criteria }, { "tetrahedra", report.Tetrahedra },
    { "boundary_triangles", report.BoundaryTriangles }, { "slabs", report.Slabs },
    { "simplices", report.Simplices }, { "flow_cells", report.FlowCells },
    { "flow_cells_left_out", report.SkippedFlowCells }, { "inflow_passes", report.InflowPasses },
    { "time_passes", report.TimePasses }, { "extraction", ToJson(report.Extraction) } };
}
}
