// SPDX-License-Identifier: BSD-3-Clause
#include "ParaView/Extractions/FlowExtraction.h"

#include "ParaView/Extractions/PropertySetters.h"
#include "vtkAnalyticFlowSource.h"
#include "vtkFlowLIC.h"
#include "vtkFlowVolume.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkImplicitFlowField.h"
#include "vtkInflowMapping.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRTAnalyticSource.h"
#include "vtkStreamSurfaceParameters.h"
#include "vtkTerminationBox.h"
#include "vtkTerminationCylinder.h"
#include "vtkTerminationMesh.h"
#include "vtkTerminationPlane.h"
#include "vtkTerminationSphere.h"
#include "vtkTerminationSurfaceSource.h"
#include "vtkTerminationTube.h"
#include "vtkVortexAxis.h"

#include <array>
#include <stdexcept>
#include <string>

using nlohmann::json;

namespace
{
using Vector = std::array<double, 3>;

// The corners that the rectangle's proxy has for a normal along x: u along y, v along z.
vtkSmartPointer<vtkTerminationSurface> MakeRectangle(const json& properties)
{
  if (properties.at("Normal") != json{ 1.0, 0.0, 0.0 })
  {
    throw std::runtime_error("a rectangle here has the normal x");
  }
  const Vector center = properties.at("Center");
  const std::array<double, 2> lengths = properties.at("Lengths");
  const double low[2] = { center[1] - 0.5 * lengths[0], center[2] - 0.5 * lengths[1] };
  auto plane = vtkSmartPointer<vtkTerminationPlane>::New();
  plane->SetOrigin(center[0], low[0], low[1]);
  plane->SetPoint1(center[0], low[0] + lengths[0], low[1]);
  plane->SetPoint2(center[0], low[0], low[1] + lengths[1]);
  return plane;
}

vtkSmartPointer<vtkTerminationSurface> MakeSphere(const json& properties)
{
  auto sphere = vtkSmartPointer<vtkTerminationSphere>::New();
  sphere->SetCenter(properties.at("Center").get<Vector>().data());
  sphere->SetRadius(properties.at("Radius"));
  sphere->SetAxis(properties.at("Axis").get<Vector>().data());
  return sphere;
}

// The points that the cylinder's proxy has for an axis along z.
vtkSmartPointer<vtkTerminationSurface> MakeCylinder(const json& properties)
{
  if (properties.at("Axis") != json{ 0.0, 0.0, 2.0 })
  {
    throw std::runtime_error("a cylinder here has the axis 2 z");
  }
  const Vector center = properties.at("Center");
  const double half = 0.5 * properties.at("Length").get<double>();
  auto cylinder = vtkSmartPointer<vtkTerminationCylinder>::New();
  cylinder->SetPoint1(center[0], center[1], center[2] - half);
  cylinder->SetPoint2(center[0], center[1], center[2] + half);
  cylinder->SetRadius(properties.at("Radius"));
  cylinder->SetCapped(properties.at("Capped") == 1);
  return cylinder;
}

vtkSmartPointer<vtkTerminationSurface> MakeBox(const json& properties)
{
  const Vector position = properties.at("Position");
  const Vector lengths = properties.at("Lengths");
  auto box = vtkSmartPointer<vtkTerminationBox>::New();
  box->SetBounds(position[0], position[0] + lengths[0], position[1], position[1] + lengths[1],
    position[2], position[2] + lengths[2]);
  return box;
}

vtkSmartPointer<vtkTerminationSurface> MakeTube(const json& properties)
{
  auto tube = vtkSmartPointer<vtkTerminationTube>::New();
  const json& points = properties.at("Points");
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    tube->AddPoint(points[i], points[i + 1], points[i + 2]);
  }
  tube->SetRadius(properties.at("Radius"));
  tube->SetCapped(properties.at("Capped") == 1);
  return tube;
}

vtkSmartPointer<vtkTerminationSurface> MakeParallelogram(const json& properties)
{
  auto plane = vtkSmartPointer<vtkTerminationPlane>::New();
  plane->SetOrigin(properties.at("Origin").get<Vector>().data());
  plane->SetPoint1(properties.at("Point1").get<Vector>().data());
  plane->SetPoint2(properties.at("Point2").get<Vector>().data());
  plane->SetUnbounded(properties.at("Unbounded") == 1);
  return plane;
}

// Each line as a tube.
void AddTubes(vtkImplicitFlowField* field, vtkPolyData* lines, double radius)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    lines->GetLines()->GetCellAtId(line, ids);
    vtkNew<vtkTerminationTube> tube;
    tube->SetRadius(radius);
    for (const vtkIdType id : *ids)
    {
      const double* x = lines->GetPoint(id);
      tube->AddPoint(x[0], x[1], x[2]);
    }
    field->AddTerminationSurface(tube);
  }
}

Setters<vtkImplicitFlowField> FieldSetters()
{
  using Field = vtkImplicitFlowField;
  return {
    { "DomainFaces", [](Field* field, const json& on) { field->SetDomainFaces(on == 1); } },
    { "DomainFaceId", [](Field* field, const json& id) { field->SetDomainFaceId(id); } },
    { "CriticalPointSpheres",
      [](Field* field, const json& on) { field->SetCriticalPointSpheres(on == 1); } },
    { "CriticalPointId", [](Field* field, const json& id) { field->SetCriticalPointId(id); } },
    { "CriticalPointRadius",
      [](Field* field, const json& radius) { field->SetCriticalPointRadius(radius); } },
    { "SampleMode", [](Field* field, const json& mode) { field->SetSampleMode(mode); } },
    { "SampleDimensions",
      [](Field* field, const json& points)
      { field->SetSampleDimensions(points[0], points[1], points[2]); } },
    { "SampleBounds",
      [](Field* field, const json& bounds)
      { field->SetSampleBounds(bounds.get<std::array<double, 6>>().data()); } },
    { "Direction", [](Field* field, const json& value) { field->SetDirection(value); } },
    { "Integrator", [](Field* field, const json& value) { field->SetIntegrator(value); } },
    { "MaximumError", [](Field* field, const json& value) { field->SetMaximumError(value); } },
    { "MaximumTime", [](Field* field, const json& value) { field->SetMaximumTime(value); } },
    { "MaximumNumberOfSteps",
      [](Field* field, const json& value) { field->SetMaximumNumberOfSteps(value); } },
    { "MinimumSpeed", [](Field* field, const json& value) { field->SetMinimumSpeed(value); } },
    { "ComputeMaximumSpeed",
      [](Field* field, const json& on) { field->SetComputeMaximumSpeed(on == 1); } },
    { "ComputeArcLength",
      [](Field* field, const json& on) { field->SetComputeArcLength(on == 1); } },
    { "ComputeMeanVorticity",
      [](Field* field, const json& on) { field->SetComputeMeanVorticity(on == 1); } },
    { "KeepSteps", [](Field* field, const json& on) { field->SetKeepSteps(on == 1); } },
  };
}

Setters<vtkInflowMapping> MappingSetters()
{
  using Mapping = vtkInflowMapping;
  return {
    { "Formula",
      [](Mapping* mapping, const json& formula)
      { mapping->SetFormula(Mapping::ALL, formula.get<std::string>().c_str()); } },
    { "FormulasById",
      [](Mapping* mapping, const json& rows)
      {
        for (const json& row : rows)
        {
          mapping->SetFormula(row[0], row[1].get<std::string>().c_str());
        }
      } },
    { "Rings",
      [](Mapping* mapping, const json& rows)
      {
        for (const json& row : rows)
        {
          mapping->AddRing(row[0], row[1], row[2], row[3], row[4], row[5]);
        }
      } },
  };
}

Setters<vtkFlowVolume> VolumeSetters()
{
  using Volume = vtkFlowVolume;
  return {
    { "Intervals", SetIntervals<Volume> },
    { "TimeRange",
      [](Volume* volume, const json& range) { volume->SetTimeRange(range[0], range[1]); } },
    { "StreamSurfaces",
      [](Volume* volume, const json& values)
      {
        for (std::size_t i = 0; i < values.size(); ++i)
        {
          volume->SetStreamSurface(static_cast<int>(i), values[i]);
        }
      } },
    { "TimeSurfaces",
      [](Volume* volume, const json& times)
      {
        for (std::size_t i = 0; i < times.size(); ++i)
        {
          volume->SetTimeSurface(static_cast<int>(i), times[i]);
        }
      } },
    { "GenerateStreamSurfaces",
      [](Volume* volume, const json& on) { volume->SetGenerateStreamSurfaces(on == 1); } },
    { "GenerateTimeSurfaces",
      [](Volume* volume, const json& on) { volume->SetGenerateTimeSurfaces(on == 1); } },
    { "GenerateNormals",
      [](Volume* volume, const json& on) { volume->SetGenerateNormals(on == 1); } },
    { "OutputPointsPrecision",
      [](Volume* volume, const json& value) { volume->SetOutputPointsPrecision(value); } },
  };
}
}

vtkSmartPointer<vtkAlgorithm> MakeFlow(const json& extraction)
{
  using Source = vtkAnalyticFlowSource;
  const auto source = vtkSmartPointer<Source>::New();
  SetProperties<Source>(source, extraction.at("source_properties"),
    { { "Field", [](Source* flow, const json& value) { flow->SetField(value); } },
      { "WholeExtent",
        [](Source* flow, const json& value)
        { flow->SetWholeExtent(value.get<std::array<int, 6>>().data()); } },
      { "Bounds",
        [](Source* flow, const json& value)
        { flow->SetBounds(value.get<std::array<double, 6>>().data()); } },
      { "Center",
        [](Source* flow, const json& value) { flow->SetCenter(value[0], value[1], value[2]); } } });
  return source;
}

vtkSmartPointer<vtkTerminationSurface> MakeTerminationSurface(const json& surface)
{
  using Maker = vtkSmartPointer<vtkTerminationSurface> (*)(const json&);
  const std::map<std::string, Maker> makers = { { "Rectangle", MakeRectangle },
    { "Sphere", MakeSphere }, { "Cylinder", MakeCylinder }, { "Box", MakeBox },
    { "Tube", MakeTube }, { "Parallelogram", MakeParallelogram } };
  const json& properties = surface.at("properties");
  auto made = makers.at(surface.at("kind"))(properties);
  made->SetId(properties.value("Id", -1));
  return made;
}

vtkSmartPointer<vtkAlgorithm> MakeSurfaceMesh(const json& surface)
{
  const auto source = vtkSmartPointer<vtkTerminationSurfaceSource>::New();
  source->SetSurface(MakeTerminationSurface(surface));
  return source;
}

vtkSmartPointer<vtkAlgorithm> MakeVortexAxis(const json& extraction)
{
  using Axis = vtkVortexAxis;
  const auto axis = vtkSmartPointer<Axis>::New();
  const auto flow = MakeFlow(extraction);
  axis->SetInputConnection(flow->GetOutputPort());
  SetProperties<Axis>(axis, extraction.at("axis"),
    { { "NumberOfPlanes", [](Axis* line, const json& value) { line->SetNumberOfPlanes(value); } },
      { "SearchRadius", [](Axis* line, const json& value) { line->SetSearchRadius(value); } } });
  return axis;
}

vtkSmartPointer<vtkImplicitFlowField> MakeFlowField(const json& extraction)
{
  auto field = vtkSmartPointer<vtkImplicitFlowField>::New();
  const auto flow = MakeFlow(extraction);
  field->SetInputConnection(flow->GetOutputPort());
  for (const json& surface : extraction.at("surfaces"))
  {
    field->AddTerminationSurface(MakeTerminationSurface(surface));
  }
  for (const json& surface : extraction.at("meshes"))
  {
    const auto source = MakeSurfaceMesh(surface);
    source->Update();
    vtkNew<vtkTerminationMesh> mesh;
    mesh->SetMesh(vtkPolyData::SafeDownCast(source->GetOutputDataObject(0)));
    field->AddTerminationSurface(mesh);
  }
  if (extraction.contains("axis"))
  {
    const auto axis = MakeVortexAxis(extraction);
    axis->Update();
    AddTubes(
      field, vtkPolyData::SafeDownCast(axis->GetOutputDataObject(0)), extraction.at("TubeRadius"));
  }
  SetProperties<vtkImplicitFlowField>(field, extraction.at("field"), FieldSetters());
  return field;
}

vtkSmartPointer<vtkInflowMapping> MakeInflowMapping(const json& extraction)
{
  auto mapping = vtkSmartPointer<vtkInflowMapping>::New();
  const auto field = MakeFlowField(extraction);
  mapping->SetInputConnection(field->GetOutputPort());
  SetProperties<vtkInflowMapping>(mapping, extraction.at("mapping"), MappingSetters());
  if (extraction.contains("image"))
  {
    vtkNew<vtkRTAnalyticSource> wavelet;
    const std::array<int, 6> extent = extraction.at("image");
    wavelet->SetWholeExtent(extent[0], extent[1], extent[2], extent[3], extent[4], extent[5]);
    wavelet->Update();
    mapping->SetImage(extraction.at("ImageId"), wavelet->GetOutput());
  }
  return mapping;
}

vtkSmartPointer<vtkFlowVolume> MakeFlowVolume(const json& extraction)
{
  auto volume = vtkSmartPointer<vtkFlowVolume>::New();
  const auto mapping = MakeInflowMapping(extraction);
  volume->SetInputConnection(mapping->GetOutputPort());
  SetProperties<vtkFlowVolume>(volume, extraction.at("volume"), VolumeSetters());
  return volume;
}

vtkSmartPointer<vtkStreamSurfaceParameters> MakeStreamSurfaceParameters(
  const json& extraction, vtkFlowVolume* volume)
{
  using Parameters = vtkStreamSurfaceParameters;
  auto parameters = vtkSmartPointer<Parameters>::New();
  SetProperties<Parameters>(parameters, extraction.at("texture"),
    { { "LengthScale", [](Parameters* made, const json& value) { made->SetLengthScale(value); } },
      { "TimeScale", [](Parameters* made, const json& value) { made->SetTimeScale(value); } },
      { "Resolution", [](Parameters* made, const json& value) { made->SetResolution(value); } },
      { "StartPoints", [](Parameters* made, const json& value) {
         made->AddStartPoint(value[0], value[1], value[2]);
       } } });
  auto* mapping = vtkInflowMapping::SafeDownCast(volume->GetInputAlgorithm());
  auto* field = vtkImplicitFlowField::SafeDownCast(mapping->GetInputAlgorithm());
  parameters->SetMapping(mapping);
  for (int i = 0; i < field->GetNumberOfUsedSurfaces(); ++i)
  {
    parameters->AddTerminationSurface(field->GetUsedSurface(i), field->GetUsedSurfaceId(i));
  }
  parameters->SetInputConnection(volume->GetOutputPort(1));
  return parameters;
}

vtkSmartPointer<vtkFlowLIC> MakeFlowLIC(const json& extraction, vtkFlowVolume* volume)
{
  auto lic = vtkSmartPointer<vtkFlowLIC>::New();
  SetProperties<vtkFlowLIC>(lic, extraction.at("lic"),
    { { "NoiseScale", [](vtkFlowLIC* made, const json& value) { made->SetNoiseScale(value); } },
      { "Length", [](vtkFlowLIC* made, const json& value) { made->SetLength(value); } },
      { "StepLength", [](vtkFlowLIC* made, const json& value) { made->SetStepLength(value); } },
      { "Kernel", [](vtkFlowLIC* made, const json& value) { made->SetKernel(value); } },
      { "Seed", [](vtkFlowLIC* made, const json& value) { made->SetSeed(value); } },
      { "Contrast", [](vtkFlowLIC* made, const json& value) { made->SetContrast(value); } } });
  const auto field = MakeFlow(extraction);
  lic->SetInputConnection(volume->GetOutputPort(1));
  lic->SetFieldConnection(field->GetOutputPort());
  return lic;
}
