// SPDX-License-Identifier: BSD-3-Clause
#include "ParaView/Extractions/FlowNumbers.h"

#include "ParaView/Extractions/ExtractionMeasures.h"
#include "ParaView/Extractions/FlowExtraction.h"
#include "vtkAnalyticFlowSource.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFlowCriticalPoints.h"
#include "vtkFlowLIC.h"
#include "vtkFlowStatus.h"
#include "vtkFlowVolume.h"
#include "vtkImplicitFlowField.h"
#include "vtkInflowMapping.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamSurfaceParameters.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

using nlohmann::json;

namespace
{
json CountValues(vtkDataArray* array)
{
  std::map<int, vtkIdType> counts;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    ++counts[static_cast<int>(array->GetTuple1(i))];
  }
  json result = json::object();
  for (const auto& count : counts)
  {
    result[std::to_string(count.first)] = count.second;
  }
  return result;
}

// Of a component where it is finite.
double Sum(vtkDataArray* array, int component)
{
  double sum = 0.0;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const double value = array->GetComponent(i, component);
    sum += std::isfinite(value) ? value : 0.0;
  }
  return sum;
}

json MeasureSamples(vtkDataSet* samples)
{
  vtkPointData* arrays = samples->GetPointData();
  vtkDataArray* parameters = arrays->GetArray(vtkFlowStatus::ParametersArray());
  return { { "number", samples->GetNumberOfPoints() },
    { "statuses", CountValues(arrays->GetArray(vtkFlowStatus::StatusArray())) },
    { "ids", CountValues(arrays->GetArray(vtkFlowStatus::IdArray())) }, { "u", Sum(parameters, 0) },
    { "v", Sum(parameters, 1) }, { "time", Sum(arrays->GetArray(vtkFlowStatus::TimeArray()), 0) },
    { "inflow", Sum(arrays->GetArray(vtkFlowStatus::InflowArray()), 0) } };
}

json CountCriticalPoints(const json& extraction)
{
  vtkNew<vtkFlowCriticalPoints> points;
  const auto flow = MakeFlow(extraction);
  points->SetInputConnection(flow->GetOutputPort());
  points->Update();
  return CountValues(points->GetOutput()->GetPointData()->GetArray("CriticalPointType"));
}

// Texture coordinates of the stream surfaces.
json MeasureTexture(const json& extraction, vtkFlowVolume* volume)
{
  const auto parameters = MakeStreamSurfaceParameters(extraction, volume);
  parameters->Update();
  vtkPointData* arrays = parameters->GetOutput()->GetPointData();
  vtkDataArray* texture = arrays->GetArray("StreamTexture");
  return { { "contours", CountValues(arrays->GetArray("ContourId")) },
    { "length", Sum(texture, 0) }, { "time", Sum(texture, 1) } };
}

// Of line integral convolution at the points of the stream surfaces.
double MeasureLIC(const json& extraction, vtkFlowVolume* volume)
{
  const auto lic = MakeFlowLIC(extraction, volume);
  lic->Update();
  return Sum(
    vtkDataSet::SafeDownCast(lic->GetOutputDataObject(0))->GetPointData()->GetArray("LIC"), 0);
}

json Measure(json extraction)
{
  const auto mapping = MakeInflowMapping(extraction);
  mapping->Update();
  extraction["points"] = MeasureSamples(vtkDataSet::SafeDownCast(mapping->GetOutputDataObject(0)));
  const auto volume = MakeFlowVolume(extraction);
  volume->Update();
  const char* const ids[] = { "IntervalId", "StreamSurfaceId", "TimeSurfaceId" };
  extraction["outputs"] = json::array();
  for (int port = 0; port < 3; ++port)
  {
    if (volume->GetOutput(port)->GetNumberOfCells() == 0)
    {
      throw std::runtime_error(std::string("no cells to measure by ") + ids[port]);
    }
    extraction["outputs"].push_back(MeasureExtraction(volume->GetOutput(port), ids[port]));
  }
  if (extraction.contains("texture"))
  {
    extraction["textured"] = MeasureTexture(extraction, volume);
    extraction["lic_sum"] = MeasureLIC(extraction, volume);
  }
  extraction["critical_points"] = CountCriticalPoints(extraction);
  if (extraction.contains("axis"))
  {
    const auto axis = MakeVortexAxis(extraction);
    axis->Update();
    extraction["axis_points"] =
      vtkPolyData::SafeDownCast(axis->GetOutputDataObject(0))->GetNumberOfPoints();
  }
  return extraction;
}

json FlowProperties(int field, int points)
{
  return { { "Field", field }, { "WholeExtent", { 0, points, 0, points, 0, points } },
    { "Bounds", { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 } } };
}

json Surface(const char* kind, const json& properties)
{
  return { { "kind", kind }, { "properties", properties } };
}

const json BOTH_SURFACES = { { "GenerateStreamSurfaces", 1 }, { "GenerateTimeSurfaces", 1 } };

json Volume(json properties)
{
  properties.update(BOTH_SURFACES);
  return properties;
}

// Around a sphere, from a rectangle upstream: two intervals, and surfaces inside them.
json FromRectangle()
{
  return { { "source_properties", FlowProperties(vtkAnalyticFlowSource::SPHERE, 19) },
    { "surfaces",
      { Surface("Rectangle",
        { { "Center", { -0.875, 0.0, 0.125 } }, { "Normal", { 1.0, 0.0, 0.0 } },
          { "Lengths", { 1.5, 1.25 } } }) } },
    { "meshes", json::array() }, { "field", json::object() },
    { "mapping", { { "Formula", "u + v/4" } } },
    { "volume",
      Volume({ { "Intervals", { 0.25, 0.5, 0.5, 0.75 } }, { "TimeRange", { 0.2, 1.2 } },
        { "StreamSurfaces", { 0.4 } }, { "TimeSurfaces", { 0.6, 0.9 } },
        { "GenerateNormals", 1 } }) },
    { "texture", { { "LengthScale", 4.0 }, { "TimeScale", 0.5 }, { "Resolution", 64 } } },
    { "lic", { { "NoiseScale", 0.125 }, { "Contrast", 0.25 } } } };
}

// Between a source and a sink: two surfaces with ids, rings on one and a formula of the other's
// faces, on an image of samples, forward by the classical method.
json ToSphereAndBox()
{
  return { { "source_properties", FlowProperties(vtkAnalyticFlowSource::SOURCE_SINK, 23) },
    { "surfaces",
      { Surface("Sphere",
          { { "Center", { 0.5, 0.0, 0.0 } }, { "Radius", 0.25 }, { "Axis", { 1.0, 0.0, 0.0 } },
            { "Id", 7 } }),
        Surface("Box",
          { { "Position", { -0.9375, -0.875, -0.75 } }, { "Lengths", { 1.875, 1.75, 1.5 } },
            { "Id", 20 } }) } },
    { "meshes", json::array() },
    { "field",
      { { "Direction", 1 }, { "Integrator", 2 }, { "SampleMode", 1 },
        { "SampleDimensions", { 17, 15, 13 } },
        { "SampleBounds", { -0.75, 0.75, -0.625, 0.625, -0.5, 0.5 } },
        { "ComputeArcLength", 1 } } },
    { "mapping",
      { { "Formula", "v" }, { "FormulasById", { { 22, "u*v" }, { 23, "2 - v" } } },
        { "Rings", { { 7, 0.5, 0.5, 0.25, 0.125, 1.0 }, { 7, 0.0, 0.75, 0.0, 0.25, 0.5 } } } } },
    { "volume",
      Volume({ { "Intervals", { 0.25, 0.75 } }, { "TimeSurfaces", { 1.0 } },
        { "OutputPointsPrecision", 1 } }) },
    { "texture", { { "StartPoints", { 0.75, 0.0, 0.0 } } } },
    { "lic",
      { { "NoiseScale", 0.25 }, { "Length", 1.0 }, { "StepLength", 0.125 }, { "Kernel", 0 },
        { "Seed", 3 } } } };
}

// A hurricane: a closed cylinder, the mesh of a sphere, and an image over u and v.
json FromCylinderAndMesh()
{
  return { { "source_properties", FlowProperties(vtkAnalyticFlowSource::HURRICANE, 15) },
    { "surfaces",
      { Surface("Cylinder",
        { { "Center", { 0.0, 0.0, -0.25 } }, { "Axis", { 0.0, 0.0, 2.0 } }, { "Radius", 0.625 },
          { "Length", 1.0 }, { "Capped", 1 } }) } },
    { "meshes",
      { Surface("Sphere",
        { { "Center", { 0.5, 0.5, 0.5 } }, { "Radius", 0.25 }, { "Axis", { 0.0, 0.0, 1.0 } } }) } },
    { "field", { { "MaximumTime", 4.0 }, { "KeepSteps", 1 } } },
    { "mapping", { { "Formula", "u" } } }, { "image", { -10, 10, -8, 8, 0, 0 } }, { "ImageId", 0 },
    { "volume",
      Volume({ { "Intervals", { 130.0, 200.0 } }, { "StreamSurfaces", { 160.0 } },
        { "TimeSurfaces", { 0.5, 1.0 } } }) },
    { "texture", json::object() }, { "lic", json::object() } };
}

// A tornado: the tube around its axis and the domain's faces.
json FromAxisAndFaces()
{
  return { { "source_properties", FlowProperties(vtkAnalyticFlowSource::TORNADO, 15) },
    { "surfaces", json::array() }, { "meshes", json::array() },
    { "axis", { { "NumberOfPlanes", 11 }, { "SearchRadius", 0.5 } } }, { "TubeRadius", 0.125 },
    { "field", { { "DomainFaces", 1 }, { "DomainFaceId", 50 }, { "MaximumTime", 3.0 } } },
    { "mapping", { { "Formula", "v + f/100" } } },
    { "volume", Volume({ { "StreamSurfaces", { 1.0 } }, { "TimeSurfaces", { 0.5 } } }) } };
}

// All of a plane, a tube and spheres around critical points.
json FromPlaneAndTube()
{
  return { { "source_properties", FlowProperties(vtkAnalyticFlowSource::COUPLED_CHARGE, 15) },
    { "surfaces",
      { Surface("Parallelogram",
          { { "Origin", { 0.75, -0.5, -0.5 } }, { "Point1", { 0.75, 0.5, -0.25 } },
            { "Point2", { 0.875, -0.5, 0.5 } }, { "Unbounded", 1 } }),
        Surface("Tube",
          { { "Points", { 0.0, -0.5, -0.5, 0.0, 0.0, -0.375, 0.0, 0.5, -0.5 } },
            { "Radius", 0.125 }, { "Capped", 1 } }) } },
    { "meshes", json::array() },
    { "field", { { "CriticalPointSpheres", 1 }, { "CriticalPointRadius", 1.5 } } },
    { "mapping", { { "Formula", "u" } } },
    { "volume", Volume({ { "Intervals", { 0.25, 0.75 } }, { "TimeSurfaces", { 0.125 } } }) } };
}
}

json MeasureFlowVolumes()
{
  return { Measure(FromRectangle()), Measure(ToSphereAndBox()), Measure(FromCylinderAndMesh()),
    Measure(FromAxisAndFaces()), Measure(FromPlaneAndTube()) };
}
