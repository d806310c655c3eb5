// SPDX-License-Identifier: BSD-3-Clause
// The defaults in the plugin's server-manager XML are those of the C++ classes, for every property;
// the properties whose default comes from the data have a domain that gives it.
#include "vtkAnalyticFieldSource.h"
#include "vtkAnalyticFlowSource.h"
#include "vtkAreaLight.h"
#include "vtkConstructiveModelSource.h"
#include "vtkDeltaWingSource.h"
#include "vtkFlowLIC.h"
#include "vtkFlowVolume.h"
#include "vtkImplicitFlowField.h"
#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkInflowMapping.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkNew.h"
#include "vtkProjectiveLight.h"
#include "vtkShadowedScenePass.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkSimplexTimeSlice.h"
#include "vtkSmartPointer.h"
#include "vtkStreamSurfaceParameters.h"
#include "vtkTaperedCylinderSource.h"
#include "vtkTerminationBox.h"
#include "vtkTerminationCylinder.h"
#include "vtkTerminationInflow.h"
#include "vtkTerminationMesh.h"
#include "vtkTerminationPlane.h"
#include "vtkTerminationSphere.h"
#include "vtkTerminationSurfaceSource.h"
#include "vtkTerminationTube.h"
#ifdef INTERLUME_ENABLE_TETGEN
#include "vtkTetrahedralMesher.h"
#endif
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkTurbulenceSource.h"
#include "vtkVortexAxis.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUtilities.h"

#include <cstdlib>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace
{
int Failures = 0;

void Check(bool condition, const std::string& what)
{
  if (!condition)
  {
    ++Failures;
    std::cerr << "failed: " << what << "\n";
  }
}

template <typename Value>
std::string Text(Value value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

template <typename Value>
std::string Text(const Value* values, int number)
{
  std::string text = Text(values[0]);
  for (int i = 1; i < number; ++i)
  {
    text += " " + Text(values[i]);
  }
  return text;
}

// A property's name in the XML and the value a fresh object has.
using Defaults = std::map<std::string, std::string>;

bool TakesValueFromData(vtkXMLDataElement* property)
{
  return property->GetAttribute("is_internal") ||
    property->FindNestedElementWithName("ArrayRangeDomain") ||
    property->FindNestedElementWithName("ProposedRangeDomain") ||
    property->FindNestedElementWithName("DataTypeDomain") ||
    property->FindNestedElementWithName("ArrayListDomain") ||
    property->FindNestedElementWithName("BoundsDomain") ||
    property->FindNestedElementWithName("ProxyListDomain") ||
    property->FindNestedElementWithName("InputArrayDomain");
}

// Appends the elements of a kind with a value of an attribute, at any depth.
void FindElements(vtkXMLDataElement* root, const std::string& kind, const char* attribute,
  const std::string& value, std::vector<vtkXMLDataElement*>& found)
{
  for (int i = 0; root && i < root->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* element = root->GetNestedElement(i);
    const char* given = element->GetAttribute(attribute);
    if (element->GetName() == kind && given && given == value)
    {
      found.push_back(element);
    }
    FindElements(element, kind, attribute, value, found);
  }
}

// Compares the properties whose names start with the prefix.
void CompareWithXML(const std::string& file, const std::string& proxyKind,
  const std::string& className, const std::string& prefix, const Defaults& defaults)
{
  vtkSmartPointer<vtkXMLDataElement> root;
  root.TakeReference(vtkXMLUtilities::ReadElementFromFile(file.c_str()));
  std::vector<vtkXMLDataElement*> proxies;
  FindElements(root, proxyKind, "class", className, proxies);
  Check(proxies.size() == 1, file + " has a " + proxyKind + " of " + className);
  if (proxies.size() != 1)
  {
    return;
  }
  if (const char* base = proxies.front()->GetAttribute("base_proxyname"))
  {
    // Or one of another file, as those that ParaView brings.
    FindElements(root, proxyKind, "name", base, proxies);
  }
  std::vector<vtkXMLDataElement*> elements;
  for (vtkXMLDataElement* proxy : proxies)
  {
    for (int i = 0; i < proxy->GetNumberOfNestedElements(); ++i)
    {
      elements.push_back(proxy->GetNestedElement(i));
    }
  }

  std::size_t compared = 0;
  for (vtkXMLDataElement* property : elements)
  {
    const std::string kind = property->GetName();
    if (kind.find("Property") == std::string::npos || kind == "PropertyGroup" ||
      property->GetAttribute("information_only"))
    {
      continue;
    }
    const std::string name = property->GetAttribute("name");
    if (name.compare(0, prefix.size(), prefix) != 0)
    {
      continue;
    }
    const auto expected = defaults.find(name);
    if (expected == defaults.end())
    {
      Check(TakesValueFromData(property), className + "." + name + " is compared or has a domain");
      continue;
    }
    const char* given = property->GetAttribute("default_values");
    Check((given ? given : "") == expected->second,
      className + "." + name + ": XML '" + (given ? given : "") + "', C++ '" + expected->second +
        "'");
    ++compared;
  }
  Check(compared == defaults.size(), className + ": the XML has every compared property");
}

// What a temporal source has in common with the others, and its own defaults.
template <typename Source>
void CompareSource(Source* source, const std::string& folder, Defaults defaults)
{
  defaults["NumberOfTimeSteps"] = Text(source->GetNumberOfTimeSteps());
  defaults["TimeRange"] = Text(source->GetTimeRange(), 2);
  defaults["OutputScalarType"] = Text(source->GetOutputScalarType());
  defaults["ArrayName"] = source->GetArrayName();
  CompareWithXML(folder + "/Sources.xml", "SourceProxy", source->GetClassName(), "", defaults);
}

// The surfaces that streamlines end at. Those of the plugin are the same by other values; lengths
// of 0 are those of the field, or 1 where there is none.
void CompareTerminationSurfaces(const std::string& file)
{
  const auto compare = [&](const char* className, Defaults defaults)
  {
    defaults["Id"] = Text(vtkNew<vtkTerminationSphere>()->GetId());
    CompareWithXML(file, "Proxy", className, "", defaults);
  };
  vtkNew<vtkTerminationInflow> inflow;
  compare("vtkTerminationInflow", { { "Size", Text(inflow->GetSize()) } });
  vtkNew<vtkTerminationPlane> plane;
  const double* origin = plane->GetOrigin();
  const double* point1 = plane->GetPoint1();
  const double* point2 = plane->GetPoint2();
  compare("vtkTerminationPlane",
    { { "Origin", Text(origin, 3) }, { "Point1", Text(point1, 3) }, { "Point2", Text(point2, 3) },
      { "Unbounded", Text(plane->GetUnbounded()) } });
  double center[3];
  for (int i = 0; i < 3; ++i)
  {
    center[i] = 0.5 * (point1[i] + point2[i]);
  }
  compare("vtkPVTerminationRectangle",
    { { "Center", Text(center, 3) }, { "Normal", "0 0 1" }, { "Lengths", "0 0" },
      { "Angle", "0" } });
  vtkNew<vtkTerminationSphere> sphere;
  compare("vtkTerminationSphere",
    { { "Center", Text(sphere->GetCenter(), 3) }, { "Radius", Text(sphere->GetRadius()) },
      { "Axis", Text(sphere->GetAxis(), 3) } });
  vtkNew<vtkTerminationCylinder> cylinder;
  const double* start = cylinder->GetPoint1();
  const double* end = cylinder->GetPoint2();
  for (int i = 0; i < 3; ++i)
  {
    center[i] = 0.5 * (start[i] + end[i]);
  }
  compare("vtkPVTerminationCylinder",
    { { "Center", Text(center, 3) }, { "Axis", "0 0 1" }, { "Length", "0" },
      { "Radius", Text(cylinder->GetRadius()) }, { "Capped", Text(cylinder->GetCapped()) } });
  vtkNew<vtkTerminationBox> box;
  double bounds[6];
  box->GetBounds(bounds);
  compare("vtkPVTerminationBox",
    { { "Position", Text(bounds[0]) + " " + Text(bounds[2]) + " " + Text(bounds[4]) },
      { "Lengths",
        Text(bounds[1] - bounds[0]) + " " + Text(bounds[3] - bounds[2]) + " " +
          Text(bounds[5] - bounds[4]) } });
  vtkNew<vtkTerminationTube> tube;
  compare("vtkPVTerminationTube",
    { { "Start", Text(start, 3) }, { "End", Text(end, 3) }, { "Points", "" },
      { "Radius", Text(tube->GetRadius()) }, { "Capped", Text(tube->GetCapped()) } });
  vtkNew<vtkTerminationSurfaceSource> source;
  CompareWithXML(file, "SourceProxy", "vtkTerminationSurfaceSource", "",
    { { "ResolutionU", Text(source->GetResolutionU()) },
      { "ResolutionV", Text(source->GetResolutionV()) } });
}

void CompareFlowFilters(const std::string& folder)
{
  vtkNew<vtkImplicitFlowField> field;
  Check(
    field->GetNumberOfTerminationSurfaces() == 0, "vtkImplicitFlowField starts without a surface");
  Check(field->GetNumberOfMeanArrays() == 0, "vtkImplicitFlowField starts without means");
  vtkNew<vtkTerminationMesh> mesh;
  vtkNew<vtkTerminationTube> tube;
  CompareWithXML(folder + "/ImplicitFlowField.xml", "SourceProxy", "vtkPVImplicitFlowField", "",
    { { "TubeRadius", Text(tube->GetRadius()) }, { "MeshPeriodicU", Text(mesh->GetPeriodicU()) },
      { "MeshPeriodicV", Text(mesh->GetPeriodicV()) },
      { "DomainFaces", Text(field->GetDomainFaces()) },
      { "DomainFaceId", Text(field->GetDomainFaceId()) },
      { "CriticalPointSpheres", Text(field->GetCriticalPointSpheres()) },
      { "CriticalPointId", Text(field->GetCriticalPointId()) },
      { "CriticalPointRadius", Text(field->GetCriticalPointRadius()) },
      { "SampleMode", Text(field->GetSampleMode()) },
      { "SampleDimensions", Text(field->GetSampleDimensions(), 3) },
      { "SampleBounds", Text(field->GetSampleBounds(), 6) },
      { "SamplingChecks", Text(field->GetSamplingChecks()) },
      { "Direction", Text(field->GetDirection()) }, { "Integrator", Text(field->GetIntegrator()) },
      { "MaximumError", Text(field->GetMaximumError()) },
      { "MaximumTime", Text(field->GetMaximumTime()) },
      { "MaximumNumberOfSteps", Text(field->GetMaximumNumberOfSteps()) },
      { "MinimumSpeed", Text(field->GetMinimumSpeed()) },
      { "ArrivalTolerance", Text(field->GetArrivalTolerance()) },
      { "ComputeMaximumSpeed", Text(field->GetComputeMaximumSpeed()) },
      { "ComputeArcLength", Text(field->GetComputeArcLength()) },
      { "ComputeMeanVorticity", Text(field->GetComputeMeanVorticity()) }, { "MeanArrays", "" },
      { "KeepSteps", Text(field->GetKeepSteps()) },
      { "RefinementLevels", Text(field->GetRefinementLevels()) },
      { "ShareStreamlines", Text(field->GetShareStreamlines()) }, { "CheckpointFileName", "" },
      { "CheckpointInterval", Text(field->GetCheckpointInterval()) } });

  vtkNew<vtkInflowMapping> mapping;
  CompareWithXML(folder + "/InflowMapping.xml", "SourceProxy", "vtkPVInflowMapping", "",
    { { "Formula", mapping->GetFormula(vtkInflowMapping::ALL) }, { "FormulasById", "" },
      { "Rings", "" }, { "ImageId", Text(static_cast<int>(vtkInflowMapping::ALL)) } });

  vtkNew<vtkFlowVolume> volume;
  // In ParaView with one of Inflow's range, which has a domain.
  Check(volume->GetNumberOfIntervals() == 0, "vtkFlowVolume starts without an interval");
  CompareWithXML(folder + "/FlowVolume.xml", "SourceProxy", "vtkFlowVolume", "",
    { { "TimeRange", Text(volume->GetTimeRange(), 2) },
      { "MaximumTimeJump", Text(volume->GetMaximumTimeJump()) }, { "StreamSurfaces", "" },
      { "TimeSurfaces", "" },
      { "GenerateStreamSurfaces", Text(volume->GetGenerateStreamSurfaces()) },
      { "GenerateTimeSurfaces", Text(volume->GetGenerateTimeSurfaces()) },
      { "GenerateNormals", Text(volume->GetGenerateNormals()) },
      { "ParametersAsTextureCoordinates", Text(volume->GetParametersAsTextureCoordinates()) },
      { "OutputPointsPrecision", Text(volume->GetOutputPointsPrecision()) } });

  vtkNew<vtkStreamSurfaceParameters> parameters;
  Check(parameters->GetNumberOfStartPoints() == 0,
    "vtkStreamSurfaceParameters starts without a start point");
  CompareWithXML(folder + "/StreamSurfaceParameters.xml", "SourceProxy",
    "vtkPVStreamSurfaceParameters", "",
    { { "StartPoints", "" }, { "LengthScale", Text(parameters->GetLengthScale()) },
      { "TimeScale", Text(parameters->GetTimeScale()) },
      { "Resolution", Text(parameters->GetResolution()) } });

  vtkNew<vtkFlowLIC> lic;
  CompareWithXML(folder + "/FlowLIC.xml", "SourceProxy", "vtkFlowLIC", "",
    { { "NoiseScale", Text(lic->GetNoiseScale()) }, { "Length", Text(lic->GetLength()) },
      { "StepLength", Text(lic->GetStepLength()) }, { "Kernel", Text(lic->GetKernel()) },
      { "Seed", Text(lic->GetSeed()) }, { "Contrast", Text(lic->GetContrast()) } });

  vtkNew<vtkVortexAxis> axis;
  CompareWithXML(folder + "/VortexAxis.xml", "SourceProxy", "vtkVortexAxis", "",
    { { "Axis", Text(axis->GetAxis(), 3) }, { "NumberOfPlanes", Text(axis->GetNumberOfPlanes()) },
      { "UseSeed", Text(axis->GetUseSeed()) }, { "Seed", Text(axis->GetSeed(), 3) },
      { "FrameVelocity", Text(axis->GetFrameVelocity(), 3) },
      { "SearchRadius", Text(axis->GetSearchRadius()) },
      { "MinimumSwirlStrength", Text(axis->GetMinimumSwirlStrength()) } });
  CompareWithXML(
    folder + "/FlowCriticalPoints.xml", "SourceProxy", "vtkFlowCriticalPoints", "", {});
}
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: " << argv[0] << " PLUGIN_FOLDER\n";
    return EXIT_FAILURE;
  }
  const std::string folder = argv[1];

  vtkNew<vtkIntervalVolume> interval;
  Check(interval->GetNumberOfIntervals() == 0, "vtkIntervalVolume starts without an interval");
  Check(interval->GetNumberOfCriteria() == 0, "vtkIntervalVolume starts without a criterion");
  CompareWithXML(folder + "/IntervalVolume.xml", "SourceProxy", "vtkIntervalVolume", "",
    { { "Criteria", "" }, { "GenerateBoundaries", Text(interval->GetGenerateBoundaries()) },
      { "KeepWholeCells", Text(interval->GetKeepWholeCells()) },
      { "ReportBalance", Text(interval->GetReportBalance()) },
      { "OutputPointsPrecision", Text(interval->GetOutputPointsPrecision()) },
      { "UseValueIndex", Text(interval->GetUseValueIndex()) },
      { "KeepMemory", Text(interval->GetKeepMemory()) } });

  vtkNew<vtkIsotableContour> contour;
  Check(contour->GetNumberOfContours() == 0, "vtkIsotableContour starts without a value");
  CompareWithXML(folder + "/IsotableContour.xml", "SourceProxy", "vtkIsotableContour", "",
    { { "MergePoints", Text(contour->GetMergePoints()) },
      { "OutputPointsPrecision", Text(contour->GetOutputPointsPrecision()) },
      { "ReportBalance", Text(contour->GetReportBalance()) },
      { "UseValueIndex", Text(contour->GetUseValueIndex()) } });

  vtkNew<vtkSimplexTimeSlice> slice;
  CompareWithXML(folder + "/SimplexTimeSlice.xml", "SourceProxy", "vtkSimplexTimeSlice", "",
    { { "Time", Text(slice->GetTime()) }, { "UseAnimationTime", Text(slice->GetFollowTime()) } });

  vtkNew<vtkTimeVaryingIntervalVolume> inTime;
  Check(
    inTime->GetNumberOfIntervals() == 0, "vtkTimeVaryingIntervalVolume starts without an interval");
  for (int kind = 0; kind < vtkTimeVaryingIntervalVolume::NUMBER_OF_BOUNDARY_KINDS; ++kind)
  {
    Check(
      !inTime->GetGenerateBoundary(kind), "vtkTimeVaryingIntervalVolume starts without boundaries");
  }
  const int* steps = inTime->GetTimeStepRange();
  const double* direction = inTime->GetProjectionDirection();
  CompareWithXML(folder + "/TimeVaryingIntervalVolume.xml", "SourceProxy",
    "vtkTimeVaryingIntervalVolume", "",
    { { "TimeStepRange", Text(steps[0]) + " " + Text(steps[1]) },
      { "ProjectionDirection",
        Text(direction[0]) + " " + Text(direction[1]) + " " + Text(direction[2]) + " " +
          Text(direction[3]) },
      { "GenerateTetrahedra", Text(inTime->GetGenerateTetrahedra()) }, { "Boundaries", "" },
      { "GenerateSimplices", Text(inTime->GetGenerateSimplices()) },
      { "ReportBalance", Text(inTime->GetReportBalance()) },
      { "OutputPointsPrecision", Text(inTime->GetOutputPointsPrecision()) } });

#ifdef INTERLUME_ENABLE_TETGEN
  vtkNew<vtkTetrahedralMesher> mesher;
  CompareWithXML(folder + "/TetrahedralMesher.xml", "SourceProxy", "vtkTetrahedralMesher", "",
    { { "QualityBound", Text(mesher->GetQualityBound()) },
      { "MinimumDihedralAngle", Text(mesher->GetMinimumDihedralAngle()) },
      { "MaximumVolume", Text(mesher->GetMaximumVolume()) },
      { "MaximumNumberOfAddedPoints", Text(mesher->GetMaximumNumberOfAddedPoints()) },
      { "PreserveBoundary", Text(mesher->GetPreserveBoundary()) },
      { "FillNestedShells", Text(mesher->GetFillNestedShells()) },
      { "SplitContacts", Text(mesher->GetSplitContacts()) },
      { "TimeLimit", Text(mesher->GetTimeLimit()) } });
#endif

  vtkNew<vtkAnalyticFieldSource> field;
  CompareSource(field.GetPointer(), folder,
    { { "Field", Text(field->GetField()) }, { "WholeExtent", Text(field->GetWholeExtent(), 6) },
      { "Bounds", Text(field->GetBounds(), 6) }, { "Constant", Text(field->GetConstant()) },
      { "Gradient", Text(field->GetGradient(), 3) }, { "Rate", Text(field->GetRate()) },
      { "Center", Text(field->GetCenter(), 3) }, { "Velocity", Text(field->GetVelocity(), 3) },
      { "Radius", Text(field->GetRadius()) }, { "Growth", Text(field->GetGrowth()) } });
  vtkNew<vtkTaperedCylinderSource> cylinder;
  CompareSource(cylinder.GetPointer(), folder,
    { { "Dimensions", Text(cylinder->GetDimensions(), 3) },
      { "Radii", Text(cylinder->GetRadii(), 2) }, { "Height", Text(cylinder->GetHeight()) },
      { "OuterRadius", Text(cylinder->GetOuterRadius()) }, { "Speed", Text(cylinder->GetSpeed()) },
      { "StrouhalNumber", Text(cylinder->GetStrouhalNumber()) } });
  vtkNew<vtkDeltaWingSource> wing;
  CompareSource(wing.GetPointer(), folder,
    { { "Dimensions", Text(wing->GetDimensions(), 3) },
      { "SweepAngle", Text(wing->GetSweepAngle()) },
      { "BreakdownPosition", Text(wing->GetBreakdownPosition()) },
      { "BreakdownAmplitude", Text(wing->GetBreakdownAmplitude()) },
      { "BreakdownFrequency", Text(wing->GetBreakdownFrequency()) },
      { "SpiralFrequency", Text(wing->GetSpiralFrequency()) } });

  vtkNew<vtkConstructiveModelSource> model;
  CompareWithXML(folder + "/Sources.xml", "SourceProxy", "vtkConstructiveModelSource", "",
    { { "Model", Text(model->GetModel()) }, { "Resolution", Text(model->GetResolution()) },
      { "OutputMode", Text(model->GetOutputMode()) },
      { "NumberOfSubsamples", Text(model->GetNumberOfSubsamples()) } });
  vtkNew<vtkTurbulenceSource> turbulence;
  CompareWithXML(folder + "/Sources.xml", "SourceProxy", "vtkTurbulenceSource", "",
    { { "WholeExtent", Text(turbulence->GetWholeExtent(), 6) },
      { "Bounds", Text(turbulence->GetBounds(), 6) }, { "Sum", Text(turbulence->GetSum()) },
      { "NumberOfOctaves", Text(turbulence->GetNumberOfOctaves()) },
      { "Frequency", Text(turbulence->GetFrequency()) },
      { "Amplitude", Text(turbulence->GetAmplitude()) },
      { "Offset", Text(turbulence->GetOffset()) }, { "Seed", Text(turbulence->GetSeed()) },
      { "Falloff", Text(turbulence->GetFalloff()) },
      { "VerticalAxis", Text(turbulence->GetVerticalAxis()) },
      { "TopFraction", Text(turbulence->GetTopFraction()) },
      { "Envelope", Text(turbulence->GetEnvelope()) } });

  vtkNew<vtkAnalyticFlowSource> flow;
  CompareWithXML(folder + "/Sources.xml", "SourceProxy", "vtkAnalyticFlowSource", "",
    { { "Field", Text(flow->GetField()) }, { "WholeExtent", Text(flow->GetWholeExtent(), 6) },
      { "Bounds", Text(flow->GetBounds(), 6) },
      { "OutputScalarType", Text(flow->GetOutputScalarType()) },
      { "Center", Text(flow->GetCenter(), 3) }, { "Velocity", Text(flow->GetVelocity(), 3) },
      { "Axis", Text(flow->GetAxis(), 3) }, { "AngularVelocity", Text(flow->GetAngularVelocity()) },
      { "SaddleRates", Text(flow->GetSaddleRates(), 3) },
      { "NodeRates", Text(flow->GetNodeRates(), 3) }, { "Swirl", Text(flow->GetSwirl()) },
      { "Strength", Text(flow->GetStrength()) }, { "Separation", Text(flow->GetSeparation(), 3) },
      { "CoreRadius", Text(flow->GetCoreRadius()) }, { "Radius", Text(flow->GetRadius()) },
      { "Inside", Text(flow->GetInside()) },
      { "SpanwiseVelocity", Text(flow->GetSpanwiseVelocity()) },
      { "Amplitudes", Text(flow->GetAmplitudes(), 3) }, { "Period", Text(flow->GetPeriod()) },
      { "Thickness", Text(flow->GetThickness()) }, { "Height", Text(flow->GetHeight()) },
      { "AxisTilt", Text(flow->GetAxisTilt(), 2) }, { "AxisBend", Text(flow->GetAxisBend(), 2) },
      { "MaximumWind", Text(flow->GetMaximumWind()) }, { "EyeRadius", Text(flow->GetEyeRadius()) },
      { "Updraft", Text(flow->GetUpdraft()) }, { "Circulation", Text(flow->GetCirculation()) },
      { "Strain", Text(flow->GetStrain()) } });

  CompareTerminationSurfaces(folder + "/TerminationSurfaces.xml");
  CompareFlowFilters(folder);

  // The representation's own properties; the others are those of ParaView's volumes.
  vtkNew<vtkTimeWeightedTetrahedraMapper> mapper;
  Check(mapper->GetDeltaTArrayName() == nullptr, "the mapper takes DeltaT where there is one");
  Check(mapper->GetLayerPriority(3) == 3.0, "the mapper's priorities are the layers' numbers");
  CompareWithXML(folder + "/IntervalVolumeRepresentation.xml", "ScalarVolumeRepresentationProxy",
    "vtkIntervalVolumeRepresentation", "Interval",
    { { "IntervalBlendMode", Text(mapper->GetBlendMode()) },
      { "IntervalSortMode", Text(mapper->GetSortMode()) },
      { "IntervalIntegrationMode", Text(mapper->GetIntegrationMode()) },
      { "IntervalRenderPath", Text(mapper->GetRenderPath()) },
      { "IntervalAutoAdjustLevelOfDetail", Text(mapper->GetAutoAdjustLevelOfDetail()) },
      { "IntervalDeltaTArrayName", "DeltaT" },
      { "IntervalLayerArrayName", mapper->GetLayerArrayName() },
      { "IntervalLayerPriorities", "" } });

  // A light kit has five lights: one shadow at first, and shading, without which they are too
  // bright; scattered light is as bright as surfaces.
  vtkNew<vtkShadowedSliceMapper> slices;
  vtkNew<vtkProjectiveLight> light;
  vtkNew<vtkAreaLight> lamp;
  vtkNew<vtkShadowedScenePass> scene;
  CompareWithXML(folder + "/ShadowedSliceRepresentation.xml", "ScalarVolumeRepresentationProxy",
    "vtkShadowedSliceRepresentation", "",
    { { "Ambient", "0" }, { "Diffuse", "1" }, { "Specular", "0" }, { "SpecularPower", "100" },
      { "ShadowedShade", "1" }, { "ShadowedTwoSidedLighting", "1" },
      { "Shadows", Text(slices->GetShadows()) }, { "MaximumNumberOfShadows", "1" },
      { "ColoredShadows", "0" }, { "SceneShadows", "0" }, { "ShadowGridResolution", "64" },
      { "ViewLightAngle", "0" },
      { "SceneDepthMapResolution", Text(scene->GetDepthMapResolution()) },
      { "SceneDepthBias", Text(scene->GetDepthBias()) },
      { "SliceSpacing", Text(slices->GetSliceSpacing()) },
      { "LightBufferSize", Text(slices->GetLightBufferSize()) },
      { "LightLookup", Text(slices->GetLightLookup()) },
      { "ImageSampleDistance", Text(slices->GetImageSampleDistance()) },
      { "AutoAdjustSampleDistances", Text(slices->GetAutoAdjustSampleDistances()) },
      { "ShadowedUseSeparateOpacityArray", "0" }, { "ShadowedOpacityComponent", "0" },
      { "ShadowedUseCropping", Text(slices->GetCropping()) }, { "ShadowedCroppingOrigin", "0 0 0" },
      { "ShadowedCroppingScale", "1 1 1" }, { "ShadowedInput", "" }, { "ProjectiveLight", "0" },
      { "ProjectiveLightPositional", Text(light->GetPositional()) },
      { "ProjectiveLightViewUp", Text(light->GetViewUp(), 3) },
      { "ProjectiveLightImage", light->GetImage() ? "image" : "" },
      { "ProjectiveLightEdgeWidth", Text(light->GetEdgeWidth()) },
      { "ProjectiveLightColor", Text(light->GetDiffuseColor(), 3) },
      { "ProjectiveLightIntensity", Text(light->GetIntensity()) },
      { "ProjectiveLightShadows", Text(light->GetShadowAttenuation()) }, { "AreaLight", "0" },
      { "AreaLightPositional", Text(lamp->GetPositional()) },
      { "AreaLightShape", Text(lamp->GetShape()) },
      { "AreaLightViewUp", Text(lamp->GetViewUp(), 3) },
      { "AreaLightImage", lamp->GetEmitter() ? "image" : "" },
      { "AreaLightColor", Text(lamp->GetDiffuseColor(), 3) },
      { "AreaLightIntensity", Text(lamp->GetIntensity()) },
      { "AreaLightShadows", Text(lamp->GetShadowAttenuation()) },
      { "SoftShadowMethod", Text(slices->GetSoftShadowMethod()) },
      { "NumberOfLightSamples", Text(slices->GetNumberOfLightSamples()) },
      { "MultipleScattering", Text(slices->GetMultipleScattering()) },
      { "ScatteringPhaseFunction", Text(slices->GetPhaseFunction()) },
      { "ScatteringAnisotropy", Text(slices->GetAnisotropy()) },
      { "ScatteringPhaseTable", slices->GetPhaseTable() ? "points" : "" },
      { "ScatteringAlbedo", slices->GetScatteringAlbedo() ? "points" : "" },
      { "ScatteringBrightness", "0.35" },
      { "ScatteringForwardSpread", Text(slices->GetForwardSpread()) },
      { "ScatteringBackwardLayers", Text(slices->GetBackwardLayers()) },
      { "ScatteringGridSize", Text(slices->GetScatteringGridSize()) } });
  vtkNew<vtkImplicitFlowVolumeMapper> inflow;
  Check(!inflow->GetTimeGate(), "paint is put in always at first");
  const double* paint = inflow->GetDefaultColor();
  CompareWithXML(folder + "/InflowTextureRepresentation.xml", "DisplayedVolumeRepresentationProxy",
    "vtkInflowTextureRepresentation", "Inflow",
    { { "InflowTexture", inflow->GetNumberOfInflowTextures() > 0 ? "image" : "" },
      { "InflowSurfaceTexture", inflow->GetInflowTexture(0) ? "image" : "" },
      { "InflowSurfaceId", "0" }, { "InflowDefaultColor", Text(paint, 3) },
      { "InflowDefaultOpacity", Text(paint[3]) },
      { "InflowDetailTexture", inflow->GetDetailTexture() ? "image" : "" },
      { "InflowDetailMode", Text(inflow->GetDetailMode()) },
      { "InflowDetailScale", Text(inflow->GetDetailScale(), 3) }, { "InflowPulseLength", "1" },
      { "InflowTimeGateTarget", Text(inflow->GetTimeGateTarget()) },
      { "InflowTimePeriod", Text(inflow->GetTimePeriod()) },
      { "InflowTimePhase", Text(inflow->GetTimePhase()) },
      { "InflowUseOpacityArray", *inflow->GetOpacityArray() ? "1" : "0" }, { "InflowShade", "0" },
      { "InflowShadows", Text(inflow->GetShadows()) },
      { "InflowLightBufferSize", Text(inflow->GetLightBufferSize()) },
      { "InflowUseCropping", Text(inflow->GetCropping()) }, { "InflowCroppingOrigin", "0 0 0" },
      { "InflowCroppingScale", "1 1 1" }, { "InflowPaintFilter", Text(inflow->GetPaintFilter()) },
      { "InflowMaximumPaintSamples", Text(inflow->GetMaximumPaintSamples()) },
      { "InflowSampleDistance", Text(inflow->GetSampleDistance()) },
      { "InflowImageSampleDistance", Text(inflow->GetImageSampleDistance()) } });
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
