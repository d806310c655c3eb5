// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Costs/Feature.h"

#include "Gallery/SceneReport.h"

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

#include <functional>

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

bool HasBoundaries(vtkTimeVaryingIntervalVolume* filter)
{
  bool isAny = false;
  for (int kind = 0; kind < vtkTimeVaryingIntervalVolume::NUMBER_OF_BOUNDARY_KINDS; ++kind)
  {
    isAny = isAny || filter->GetGenerateBoundary(kind);
  }
  return isAny;
}

/// Appends features of objects of class Type to a list of features.
template <typename Type>
class FeatureList
{
public:
  FeatureList(const char* name, std::vector<Feature>& features)
    : Class(name)
    , Features(features)
  {
  }

  /// Adds a feature that is switched on by passing \a on to the setter \a set. \a isOn returns true
  /// if the feature is on. \a own is Feature::Own.
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
      const Value before = std::invoke(get, typed);
      std::invoke(set, typed, on);
      return std::function<void()>([=]() { std::invoke(set, typed, before); });
    };
    this->Features.push_back(feature);
  }
  /// Adds a feature that is on if the value returned by the getter \a get differs from \a off.
  template <typename Get, typename Set, typename Own, typename Value = bool>
  void Add(const char* name, Get get, Set set, const Own& own, Value on = true, Value off = false)
  {
    this->AddIf(
      name, [=](Type* object) { return std::invoke(get, object) != off; }, get, set, own, on);
  }

private:
  const char* Class;
  std::vector<Feature>& Features;
};

void AddExtractions(std::vector<Feature>& features)
{
  using Interval = vtkIntervalVolume;
  FeatureList<Interval> intervals("vtkIntervalVolume", features);
  intervals.Add("GenerateBoundaries", &Interval::GetGenerateBoundaries,
    &Interval::SetGenerateBoundaries, [](Interval* filter) { return CountCells(filter, 1); });
  intervals.Add("KeepInteriorCells", &Interval::GetKeepInteriorCells,
    &Interval::SetKeepInteriorCells,
    [](Interval* filter) {
      return SumValues(filter->GetReport(), { "InteriorCells", "NonPlanarFaces" });
    });
  intervals.Add("GenerateOriginArrays", &Interval::GetGenerateOriginArrays,
    &Interval::SetGenerateOriginArrays,
    [](Interval* filter) { return CountArray(filter, "OriginPoints"); });
  intervals.Add("UseValueIndex", &Interval::GetUseValueIndex, &Interval::SetUseValueIndex,
    [](Interval* filter)
    {
      return filter->GetReport()->GetNumber("Cells") -
        filter->GetReport()->GetNumber("CellsVisited");
    });

  using Contour = vtkIsotableContour;
  FeatureList<Contour> contours("vtkIsotableContour", features);
  contours.Add("UseValueIndex", &Contour::GetUseValueIndex, &Contour::SetUseValueIndex,
    [](Contour* filter)
    {
      return filter->GetReport()->GetNumber("Cells") -
        filter->GetReport()->GetNumber("CellsVisited");
    });

  using InTime = vtkTimeVaryingIntervalVolume;
  FeatureList<InTime> inTime("vtkTimeVaryingIntervalVolume", features);
  inTime.Add("GenerateSimplices", &InTime::GetGenerateSimplices, &InTime::SetGenerateSimplices,
    [](InTime* filter) { return CountCells(filter, 2); });
  // The feature is on if boundaries of any kind are generated.
  inTime.Add("GenerateBoundaries", &HasBoundaries, &InTime::SetGenerateBoundaries,
    [](InTime* filter) { return SumValues(filter->GetReport(), { "Boundaries" }); });
}

void AddFlows(std::vector<Feature>& features)
{
  using Field = vtkImplicitFlowField;
  FeatureList<Field> fields("vtkImplicitFlowField", features);
  fields.Add(
    "RefinementLevels", &Field::GetRefinementLevels, &Field::SetRefinementLevels,
    [](Field* filter) { return SumValues(filter->GetReport(), { "AddedSamples" }); }, 1, 0);
  fields.Add(
    "SamplingChecks", &Field::GetSamplingChecks, &Field::SetSamplingChecks,
    [](Field* filter) { return filter->GetReport()->GetNumber("SamplingChecks"); }, 500, 0);
  fields.Add("InterpolateStreamlines", &Field::GetInterpolateStreamlines,
    &Field::SetInterpolateStreamlines,
    [](Field* filter) {
      return SumValues(filter->GetReport(), { "InterpolatedSamples", "InterpolationChecks" });
    });
  fields.Add("StoreStepCounts", &Field::GetStoreStepCounts, &Field::SetStoreStepCounts,
    [](Field* filter) { return CountArray(filter, "AdvectionSteps"); });
  fields.Add("ComputeMaximumSpeed", &Field::GetComputeMaximumSpeed, &Field::SetComputeMaximumSpeed,
    [](Field* filter) { return CountArray(filter, "MaximumSpeed"); });
  fields.Add("ComputeArcLength", &Field::GetComputeArcLength, &Field::SetComputeArcLength,
    [](Field* filter) { return CountArray(filter, "ArcLength"); });
  fields.Add("ComputeMeanVorticity", &Field::GetComputeMeanVorticity,
    &Field::SetComputeMeanVorticity,
    [](Field* filter) { return CountArray(filter, "MeanVorticity"); });
  fields.Add("ComputeLocalAttributes", &Field::GetComputeLocalAttributes,
    &Field::SetComputeLocalAttributes,
    [](Field* filter) { return CountArray(filter, "LocalVorticity"); });

  using Volume = vtkFlowVolume;
  FeatureList<Volume> volumes("vtkFlowVolume", features);
  volumes.Add("GenerateStreamSurfaces", &Volume::GetGenerateStreamSurfaces,
    &Volume::SetGenerateStreamSurfaces, [](Volume* filter) { return CountCells(filter, 1); });
  volumes.Add("GenerateTimeSurfaces", &Volume::GetGenerateTimeSurfaces,
    &Volume::SetGenerateTimeSurfaces, [](Volume* filter) { return CountCells(filter, 2); });
  volumes.Add("GenerateNormals", &Volume::GetGenerateNormals, &Volume::SetGenerateNormals,
    [](Volume* filter) { return filter->GetReport()->GetNumber("NormalPasses"); });
}

void AddDrawings(std::vector<Feature>& features)
{
  using Slices = vtkShadowedSliceMapper;
  FeatureList<Slices> slices("vtkShadowedSliceMapper", features);
  slices.AddIf(
    "Shadows", [](Slices* mapper) { return mapper->GetReport()->GetNumber("ShadowedLights") > 0; },
    &Slices::GetShadows, &Slices::SetShadows,
    [](Slices* mapper) {
      return SumValues(mapper->GetReport(), { "LightBuffers", "LightPasses", "LightBufferBytes" });
    },
    true);
  slices.Add(
    "ScatteringMode", &Slices::GetScatteringMode, &Slices::SetScatteringMode,
    [](Slices* mapper) {
      return SumValues(mapper->GetReport(), { "ScatteringCells", "ScatteringBytes" });
    },
    static_cast<int>(Slices::FORWARD_SCATTERING), static_cast<int>(Slices::NO_SCATTERING));

  using Paint = vtkImplicitFlowVolumeMapper;
  FeatureList<Paint> paints("vtkImplicitFlowVolumeMapper", features);
  paints.Add("Shadows", &Paint::GetShadows, &Paint::SetShadows,
    [](Paint* mapper) {
      return SumValues(mapper->GetReport(), { "LightBuffers", "Sweeps", "LightBufferBytes" });
    });

  using Tetrahedra = vtkTimeWeightedTetrahedraMapper;
  FeatureList<Tetrahedra> tetrahedra("vtkTimeWeightedTetrahedraMapper", features);
  tetrahedra.AddIf(
    "MPVONC_SORT",
    [](Tetrahedra* mapper)
    { return mapper->GetReport()->GetNumber("SortMode") != Tetrahedra::NO_SORT; },
    &Tetrahedra::GetSortMode, &Tetrahedra::SetSortMode,
    [](Tetrahedra* mapper)
    {
      return SumValues(
        mapper->GetReport(), { "Sorted", "HasAdjacency", "Cycles", "Gaps", "UploadedOrderBytes" });
    },
    static_cast<int>(Tetrahedra::MPVONC_SORT));
  tetrahedra.AddIf(
    "PRIORITY_BLEND",
    [](Tetrahedra* mapper)
    { return mapper->GetReport()->GetNumber("BlendMode") == Tetrahedra::PRIORITY_BLEND; },
    &Tetrahedra::GetBlendMode, &Tetrahedra::SetBlendMode,
    [](Tetrahedra* mapper) { return mapper->GetReport()->GetNumber("Layers"); },
    static_cast<int>(Tetrahedra::PRIORITY_BLEND));

  using Scene = vtkShadowedScenePass;
  FeatureList<Scene> scenes("vtkShadowedScenePass", features);
  scenes.Add("Shadows", &Scene::GetShadows, &Scene::SetShadows,
    [](Scene* pass)
    {
      return SumValues(
        pass->GetReport(), { "DepthMaps", "SampleMaps", "DepthMapBytes", "SampleMapBytes" });
    });
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
