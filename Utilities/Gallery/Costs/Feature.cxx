// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Costs/Feature.h"

#include "vtkDataSet.h"
#include "vtkFlowVolume.h"
#include "vtkImplicitFlowField.h"
#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkPointData.h"
#include "vtkShadowedScenePass.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkTimeWeightedTetrahedraMapper.h"

#include <numeric>

namespace gallery
{
namespace
{
double CountCells(vtkAlgorithm* filter, int port)
{
  auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(port));
  return output ? static_cast<double>(output->GetNumberOfCells()) : 0.0;
}

double CountArray(vtkAlgorithm* filter, const char* name)
{
  auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  return output && output->GetPointData()->HasArray(name) ? 1.0 : 0.0;
}

template <typename Number>
double Sum(const Number* begin, const Number* end)
{
  return static_cast<double>(std::accumulate(begin, end, Number(0)));
}

bool HasBoundaries(vtkTimeVaryingIntervalVolume* filter)
{
  bool isAny = false;
  for (int kind = 0; kind < vtkTimeVaryingIntervalVolume::NUMBER_OF_BOUNDARY_KINDS; ++kind)
  {
    isAny = isAny || filter->GetGenerateBoundary(kind);
  }
  return isAny;
}

/// Features of a class, by calls of its own type.
template <typename Type>
class FeatureList
{
public:
  FeatureList(const char* name, std::vector<Feature>& features)
    : Class(name)
    , Features(features)
  {
  }

  /// A setting, with the value that is on, and what tells whether it was.
  template <typename IsOn, typename Get, typename Set, typename Own, typename Value>
  void AddIf(
    const char* name, const IsOn& isOn, const Get& get, const Set& set, const Own& own, Value on)
  {
    Feature feature;
    feature.Class = this->Class;
    feature.Name = name;
    feature.IsOn = [=](vtkObject* object) { return isOn(static_cast<Type*>(object)); };
    feature.Own = [=](vtkObject* object)
    { return static_cast<double>(own(static_cast<Type*>(object))); };
    feature.SwitchOn = [=](vtkObject* object)
    {
      auto* typed = static_cast<Type*>(object);
      const Value before = get(typed);
      set(typed, on);
      return std::function<void()>([=]() { set(typed, before); });
    };
    this->Features.push_back(feature);
  }
  /// A setting that is on where it is not off's value.
  template <typename Get, typename Set, typename Own, typename Value>
  void Add(const char* name, const Get& get, const Set& set, const Own& own, Value on, Value off)
  {
    this->AddIf(
      name, [=](Type* object) { return get(object) != off; }, get, set, own, on);
  }

private:
  const char* Class;
  std::vector<Feature>& Features;
};

void AddExtractions(std::vector<Feature>& features)
{
  using Interval = vtkIntervalVolume;
  FeatureList<Interval> intervals("vtkIntervalVolume", features);
  intervals.Add(
    "GenerateBoundaries", [](Interval* filter) { return filter->GetGenerateBoundaries(); },
    [](Interval* filter, bool on) { filter->SetGenerateBoundaries(on); },
    [](Interval* filter) { return CountCells(filter, 1); }, true, false);
  intervals.Add(
    "KeepWholeCells", [](Interval* filter) { return filter->GetKeepWholeCells(); },
    [](Interval* filter, bool on) { filter->SetKeepWholeCells(on); },
    [](Interval* filter)
    { return filter->GetReport().WholeCells + filter->GetReport().WarpedFaces; },
    true, false);
  intervals.Add(
    "KeepOrigins", [](Interval* filter) { return filter->GetKeepOrigins(); },
    [](Interval* filter, bool on) { filter->SetKeepOrigins(on); },
    [](Interval* filter) { return CountArray(filter, "OriginPoints"); }, true, false);
  intervals.Add(
    "UseValueIndex", [](Interval* filter) { return filter->GetUseValueIndex(); },
    [](Interval* filter, bool on) { filter->SetUseValueIndex(on); },
    [](Interval* filter) { return filter->GetReport().Cells - filter->GetReport().CellsVisited; },
    true, false);

  using Contour = vtkIsotableContour;
  FeatureList<Contour> contours("vtkIsotableContour", features);
  contours.Add(
    "UseValueIndex", [](Contour* filter) { return filter->GetUseValueIndex(); },
    [](Contour* filter, bool on) { filter->SetUseValueIndex(on); },
    [](Contour* filter) { return filter->GetReport().Cells - filter->GetReport().CellsVisited; },
    true, false);

  using InTime = vtkTimeVaryingIntervalVolume;
  FeatureList<InTime> inTime("vtkTimeVaryingIntervalVolume", features);
  inTime.Add(
    "GenerateSimplices", [](InTime* filter) { return filter->GetGenerateSimplices(); },
    [](InTime* filter, bool on) { filter->SetGenerateSimplices(on); },
    [](InTime* filter) { return CountCells(filter, 2); }, true, false);
  // Off are none of the kinds.
  inTime.Add(
    "GenerateBoundaries", &HasBoundaries,
    [](InTime* filter, bool on) { filter->SetGenerateBoundaries(on); },
    [](InTime* filter)
    {
      const auto& cells = filter->GetReport().Boundaries;
      return Sum(cells.data(), cells.data() + cells.size());
    },
    true, false);
}

void AddFlows(std::vector<Feature>& features)
{
  using Field = vtkImplicitFlowField;
  FeatureList<Field> fields("vtkImplicitFlowField", features);
  fields.Add(
    "RefinementLevels", [](Field* filter) { return filter->GetRefinementLevels(); },
    [](Field* filter, int levels) { filter->SetRefinementLevels(levels); },
    [](Field* filter)
    {
      const auto& added = filter->GetReport().AddedSamples;
      return Sum(added.data(), added.data() + added.size());
    },
    1, 0);
  fields.Add(
    "SamplingChecks", [](Field* filter) { return filter->GetSamplingChecks(); },
    [](Field* filter, int checks) { filter->SetSamplingChecks(checks); },
    [](Field* filter) { return filter->GetReport().Sampling.Checks; }, 500, 0);
  fields.Add(
    "ShareStreamlines", [](Field* filter) { return filter->GetShareStreamlines(); },
    [](Field* filter, bool on) { filter->SetShareStreamlines(on); },
    [](Field* filter)
    { return filter->GetReport().SharedSamples + filter->GetReport().SharedChecks; },
    true, false);
  fields.Add(
    "KeepSteps", [](Field* filter) { return filter->GetKeepSteps(); },
    [](Field* filter, bool on) { filter->SetKeepSteps(on); },
    [](Field* filter) { return CountArray(filter, "AdvectionSteps"); }, true, false);
  fields.Add(
    "ComputeMaximumSpeed", [](Field* filter) { return filter->GetComputeMaximumSpeed(); },
    [](Field* filter, bool on) { filter->SetComputeMaximumSpeed(on); },
    [](Field* filter) { return CountArray(filter, "MaximumSpeed"); }, true, false);
  fields.Add(
    "ComputeArcLength", [](Field* filter) { return filter->GetComputeArcLength(); },
    [](Field* filter, bool on) { filter->SetComputeArcLength(on); },
    [](Field* filter) { return CountArray(filter, "ArcLength"); }, true, false);
  fields.Add(
    "ComputeMeanVorticity", [](Field* filter) { return filter->GetComputeMeanVorticity(); },
    [](Field* filter, bool on) { filter->SetComputeMeanVorticity(on); },
    [](Field* filter) { return CountArray(filter, "MeanVorticity"); }, true, false);

  using Volume = vtkFlowVolume;
  FeatureList<Volume> volumes("vtkFlowVolume", features);
  volumes.Add(
    "GenerateStreamSurfaces", [](Volume* filter) { return filter->GetGenerateStreamSurfaces(); },
    [](Volume* filter, bool on) { filter->SetGenerateStreamSurfaces(on); },
    [](Volume* filter) { return CountCells(filter, 1); }, true, false);
  volumes.Add(
    "GenerateTimeSurfaces", [](Volume* filter) { return filter->GetGenerateTimeSurfaces(); },
    [](Volume* filter, bool on) { filter->SetGenerateTimeSurfaces(on); },
    [](Volume* filter) { return CountCells(filter, 2); }, true, false);
  volumes.Add(
    "GenerateNormals", [](Volume* filter) { return filter->GetGenerateNormals(); },
    [](Volume* filter, bool on) { filter->SetGenerateNormals(on); },
    [](Volume* filter) { return filter->GetReport().NormalPasses; }, true, false);
}

void AddDrawings(std::vector<Feature>& features)
{
  using Slices = vtkShadowedSliceMapper;
  FeatureList<Slices> slices("vtkShadowedSliceMapper", features);
  slices.AddIf(
    "Shadows", [](Slices* mapper) { return mapper->GetReport().ShadowedLights > 0; },
    [](Slices* mapper) { return mapper->GetShadows(); },
    [](Slices* mapper, bool on) { mapper->SetShadows(on); },
    [](Slices* mapper)
    {
      const vtkShadowedSliceReport& report = mapper->GetReport();
      return report.LightBuffers + report.LightPasses + report.LightBufferBytes;
    },
    true);
  slices.Add(
    "MultipleScattering", [](Slices* mapper) { return mapper->GetMultipleScattering(); },
    [](Slices* mapper, int mode) { mapper->SetMultipleScattering(mode); },
    [](Slices* mapper)
    { return mapper->GetReport().ScatteringCells + mapper->GetReport().ScatteringBytes; },
    static_cast<int>(Slices::FORWARD_SCATTERING), static_cast<int>(Slices::NO_SCATTERING));

  using Paint = vtkImplicitFlowVolumeMapper;
  FeatureList<Paint> paints("vtkImplicitFlowVolumeMapper", features);
  paints.Add(
    "Shadows", [](Paint* mapper) { return mapper->GetShadows(); },
    [](Paint* mapper, bool on) { mapper->SetShadows(on); },
    [](Paint* mapper)
    {
      const vtkImplicitFlowVolumeReport& report = mapper->GetReport();
      return report.LightBuffers + report.Sweeps + report.LightBufferBytes;
    },
    true, false);

  using Tetrahedra = vtkTimeWeightedTetrahedraMapper;
  FeatureList<Tetrahedra> tetrahedra("vtkTimeWeightedTetrahedraMapper", features);
  tetrahedra.AddIf(
    "MPVONC_SORT",
    [](Tetrahedra* mapper) { return mapper->GetReport().SortMode != Tetrahedra::NO_SORT; },
    [](Tetrahedra* mapper) { return mapper->GetSortMode(); },
    [](Tetrahedra* mapper, int mode) { mapper->SetSortMode(mode); },
    [](Tetrahedra* mapper)
    {
      const vtkTetrahedraReport& report = mapper->GetReport();
      return (report.Sorted ? 1 : 0) + (report.HasAdjacency ? 1 : 0) + report.Cycles + report.Gaps +
        report.UploadedOrderBytes;
    },
    static_cast<int>(Tetrahedra::MPVONC_SORT));
  tetrahedra.AddIf(
    "PRIORITY_BLEND",
    [](Tetrahedra* mapper) { return mapper->GetReport().BlendMode == Tetrahedra::PRIORITY_BLEND; },
    [](Tetrahedra* mapper) { return mapper->GetBlendMode(); },
    [](Tetrahedra* mapper, int mode) { mapper->SetBlendMode(mode); },
    [](Tetrahedra* mapper) { return mapper->GetReport().Layers; },
    static_cast<int>(Tetrahedra::PRIORITY_BLEND));

  using Scene = vtkShadowedScenePass;
  FeatureList<Scene> scenes("vtkShadowedScenePass", features);
  scenes.Add(
    "Shadows", [](Scene* pass) { return pass->GetShadows(); },
    [](Scene* pass, bool on) { pass->SetShadows(on); },
    [](Scene* pass)
    {
      const vtkShadowedSceneReport& report = pass->GetReport();
      return report.DepthMaps + report.SampleMaps + report.DepthMapBytes + report.SampleMapBytes;
    },
    true, false);
}
}

const std::vector<Feature>& AllFeatures()
{
  static const std::vector<Feature> features = []()
  {
    std::vector<Feature> all;
    AddExtractions(all);
    AddFlows(all);
    AddDrawings(all);
    return all;
  }();
  return features;
}
}
