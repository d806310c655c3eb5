// SPDX-License-Identifier: BSD-3-Clause
// Writes a folder for the test of the plugin's representation: representation.json, a list of
// pictures (what was extracted from which data or source, how it was drawn, from where), and each
// picture as `<name>.png`. ParaView is asked the same and must draw the same. The data are those
// that ExtractionNumbers leaves there.
#include "Support/Inputs/DataFiles.h"
#include "ParaView/Extractions/FlowExtraction.h"
#include "ParaView/Extractions/PictureStage.h"
#include "ParaView/Extractions/TimeVaryingExtraction.h"

#include "vtkAnalyticFieldSource.h"
#include "vtkAnalyticFlowSource.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkFlowVolume.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkVolume.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

using nlohmann::json;
using Mapper = vtkTimeWeightedTetrahedraMapper;

namespace
{
// Two touching intervals of the temperature around a hot disk, seen from aside; colours and
// opacities as rows of value, red, green, blue and of value, opacity.
const json COMMON = { { "data", "disk_out_ref" }, { "array", "Temp" },
  { "intervals", { { 360.0, 480.0 }, { 480.0, 800.0 } } }, { "size", { 400, 300 } },
  { "background", { 0.925, 0.929, 0.933 } },
  { "camera",
    { { "position", { 15.0, -18.0, 11.0 } }, { "focus", { 0.0, 0.0, 1.5 } },
      { "up", { 0.0, 0.0, 1.0 } }, { "angle", 30.0 } } },
  { "unit", 2.0 }, { "blend", Mapper::AUTOMATIC_BLEND }, { "sort", Mapper::AUTOMATIC_SORT },
  { "integration", Mapper::LINEAR_SEGMENT }, { "path", Mapper::AUTOMATIC_PATH },
  { "delta_t", "DeltaT" }, { "priorities", json::array() } };

const json BY_TEMPERATURE = { { "color_by", { "POINTS", "Temp" } },
  { "colors",
    { { 360.0, 0.23, 0.30, 0.75 }, { 500.0, 0.87, 0.87, 0.87 }, { 800.0, 0.71, 0.02, 0.15 } } },
  { "opacities", { { 360.0, 0.1 }, { 480.0, 0.4 }, { 800.0, 2.0 } } } };

const json BY_INTERVAL = { { "color_by", { "CELLS", "IntervalId" } },
  { "colors", { { 0.0, 0.22, 0.44, 0.72 }, { 1.0, 0.93, 0.69, 0.26 } } },
  { "opacities", { { 0.0, 0.4 }, { 1.0, 0.8 } } } };

// Vortex tubes that move, appear and fade: early green, in between yellow, late red, thicker where
// they stay longer.
const json BY_TIME = { { "source", "AnalyticField" },
  { "source_properties",
    { { "Field", vtkAnalyticFieldSource::VORTEX }, { "WholeExtent", { 0, 71, 0, 71, 0, 71 } },
      { "Bounds", { -0.9, 0.9, -0.9, 0.9, -0.9, 0.9 } }, { "NumberOfTimeSteps", 3 },
      { "TimeRange", { 0.0, 2.0 } } } },
  { "properties", { { "Intervals", { 0.4, 0.8 } } } }, { "size", { 600, 450 } },
  { "camera",
    { { "position", { 2.8, -1.25, 1.0 } }, { "focus", { 0.0, 0.0, -0.06 } },
      { "up", { 0.0, 0.0, 1.0 } }, { "angle", 30.0 } } },
  { "color_by", { "POINTS", "Time" } },
  { "colors", { { 0.0, 0.05, 0.60, 0.25 }, { 1.0, 0.98, 0.85, 0.20 }, { 2.0, 0.80, 0.08, 0.10 } } },
  { "opacities", { { 0.0, 0.5 }, { 2.0, 0.5 } } }, { "unit", 0.012 } };

// Two stream volumes around a sphere, from a rectangle upstream, coloured by how long the flow
// took.
const json FLOW = { { "source", "AnalyticFlow" },
  { "source_properties",
    { { "Field", vtkAnalyticFlowSource::SPHERE }, { "WholeExtent", { 0, 39, 0, 39, 0, 39 } },
      { "Bounds", { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 } } } },
  { "surfaces",
    { { { "kind", "Rectangle" },
      { "properties",
        { { "Center", { -0.875, 0.0, 0.0 } }, { "Normal", { 1.0, 0.0, 0.0 } },
          { "Lengths", { 1.5, 1.5 } } } } } } },
  { "meshes", json::array() }, { "field", json::object() }, { "mapping", { { "Formula", "v" } } },
  { "volume", { { "Intervals", { 0.3, 0.45, 0.55, 0.7 } }, { "TimeRange", { 0.1, 1.5 } } } },
  { "size", { 480, 360 } },
  { "camera",
    { { "position", { 1.5, -4.5, 2.0 } }, { "focus", { 0.0, 0.0, 0.0 } },
      { "up", { 0.0, 0.0, 1.0 } }, { "angle", 30.0 } } },
  { "color_by", { "POINTS", "AdvectionTime" } },
  { "colors", { { 0.1, 0.10, 0.25, 0.70 }, { 0.8, 0.90, 0.90, 0.85 }, { 1.5, 0.75, 0.20, 0.10 } } },
  { "opacities", { { 0.1, 0.6 }, { 1.5, 0.9 } } }, { "unit", 0.2 } };

json MakeCase(const std::string& name, const json& colors, const json& changes)
{
  json result = COMMON;
  result.update(colors);
  result.update(changes);
  result["name"] = name;
  return result;
}

std::vector<json> AllCases()
{
  return { MakeCase("by-temperature", BY_TEMPERATURE, json::object()),
    MakeCase("averaged-unsorted", BY_TEMPERATURE,
      { { "integration", Mapper::AVERAGE_COLOR }, { "sort", Mapper::NO_SORT } }),
    MakeCase("extent-in-time", BY_TEMPERATURE, { { "delta_t", "AsH3" }, { "unit", 0.1 } }),
    MakeCase("by-interval", BY_INTERVAL, { { "sort", Mapper::CENTROID_SORT } }),
    MakeCase("outer-first", BY_INTERVAL,
      { { "blend", Mapper::PRIORITY_BLEND }, { "priorities", { { 0, 2.0 } } } }),
    MakeCase("opengl", BY_INTERVAL,
      { { "path", Mapper::OPENGL_PATH }, { "blend", Mapper::OPTICAL_DEPTH_BLEND } }),
    MakeCase("by-time", BY_TIME, json::object()), MakeCase("flow", FLOW, json::object()) };
}

void SetUpMapper(Mapper* mapper, const json& picture)
{
  const bool isOfCells = picture["color_by"][0] == "CELLS";
  mapper->SetScalarMode(
    isOfCells ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  mapper->SelectScalarArray(picture["color_by"][1].get<std::string>().c_str());
  mapper->SetBlendMode(picture["blend"]);
  mapper->SetSortMode(picture["sort"]);
  mapper->SetIntegrationMode(picture["integration"]);
  mapper->SetRenderPath(picture["path"]);
  if (picture["delta_t"] != "DeltaT")
  {
    mapper->SetDeltaTArrayName(picture["delta_t"].get<std::string>().c_str());
  }
  for (const json& priority : picture["priorities"])
  {
    mapper->SetLayerPriority(priority[0], priority[1]);
  }
}

vtkSmartPointer<vtkAlgorithm> MakeExtraction(const json& picture)
{
  if (picture.contains("volume"))
  {
    return MakeFlowVolume(picture);
  }
  if (picture.contains("source"))
  {
    return MakeTimeVaryingVolume(picture);
  }
  const auto filter = vtkSmartPointer<vtkIntervalVolume>::New();
  filter->SetInputData(interlume::ReadData(picture["data"].get<std::string>() + ".vtu"));
  filter->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, picture["array"].get<std::string>().c_str());
  filter->SetNumberOfIntervals(static_cast<int>(picture["intervals"].size()));
  int interval = 0;
  for (const json& range : picture["intervals"])
  {
    filter->SetInterval(interval++, range[0], range[1]);
  }
  return filter;
}

void Draw(const json& picture, const std::string& folder)
{
  const vtkSmartPointer<vtkAlgorithm> extraction = MakeExtraction(picture);
  vtkNew<Mapper> mapper;
  mapper->SetInputConnection(extraction->GetOutputPort());
  SetUpMapper(mapper, picture);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  SetUpProperty(volume->GetProperty(), picture);

  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  SavePicture(picture, renderer, folder);
}
}

int main(int argc, char* argv[])
{
  return WritePictures(argc, argv, "representation.json", AllCases(), Draw);
}
