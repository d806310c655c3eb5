// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/FlowFields.h"

#include "Support/AnalyticFlows/ReferenceFlowMaps.h"

#include "vtkImageData.h"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

namespace flow
{
namespace
{
using reference::FlowVector;
/// Returns the position of a point after it has moved with the field for the given time.
using Formula = std::function<FlowVector(const FlowVector&, double)>;

constexpr double Pi = 3.14159265358979323846;

class CaseList
{
public:
  explicit CaseList(const BenchOptions& options)
    : Points(options.Pick(64, 32, 8))
    , Seeds(MakeSeeds(options.Pick(1000, 200, 30), 0.8, options.Seed))
    , StiffSeeds(MakeSeeds(options.Pick(60, 24, 8), 0.8, options.Seed))
  {
  }

  vtkSmartPointer<vtkAnalyticFlowSource> NewSource(int field) const
  {
    auto source = vtkSmartPointer<vtkAnalyticFlowSource>::New();
    source->SetField(field);
    source->SetDimensions(this->Points, this->Points, this->Points);
    return source;
  }

  /// If \a formula is null, the reference is TrilinearFlow.
  void Add(const std::string& name, vtkAnalyticFlowSource* source, const Formula& formula = nullptr,
    bool isStiff = false)
  {
    source->Update();
    constexpr double face = 0.97;
    const Case what = { name, source->GetOutput(), isStiff ? this->StiffSeeds : this->Seeds,
      { { -face, face, -face, face, -face, face } }, true };
    if (!formula)
    {
      this->Cases.push_back({ what, Reference::FromInterpolatedField(what), isStiff });
      return;
    }
    const vtkSmartPointer<vtkAnalyticFlowSource> reused = source;
    const Reference exact(
      what.Seeds, [reused](const double x[3], double v[3]) { reused->Evaluate(x, v); },
      [formula](double x[3], double time)
      {
        const FlowVector position = formula({ { x[0], x[1], x[2] } }, time);
        std::copy(position.begin(), position.end(), x);
      });
    this->Cases.push_back({ what, exact, isStiff });
  }

  void AddSaddle(const std::string& name, const FlowVector& rates, bool isStiff)
  {
    const auto source = this->NewSource(vtkAnalyticFlowSource::SADDLE);
    source->SetSaddleRates(rates[0], rates[1], rates[2]);
    this->Add(
      name, source,
      [rates](const FlowVector& x, double t) { return reference::MapSaddle(x, {}, rates, t); },
      isStiff);
  }

  std::vector<FieldCase> Take() { return std::move(this->Cases); }

private:
  int Points;
  vtkSmartPointer<vtkPolyData> Seeds;
  vtkSmartPointer<vtkPolyData> StiffSeeds;
  std::vector<FieldCase> Cases;
};

void AddRotation(CaseList& cases)
{
  const FlowVector center = { { -1.2, -1.2, 0.0 } };
  const FlowVector axis = { { 0.0, 0.0, 1.0 } };
  const auto rotation = cases.NewSource(vtkAnalyticFlowSource::ROTATION);
  rotation->SetCenter(center[0], center[1], center[2]);
  cases.Add("rotation", rotation,
    [center, axis](const FlowVector& x, double t)
    { return reference::MapRotation(x, center, axis, 1.0, t); });
}

void AddLinearFields(CaseList& cases)
{
  const FlowVector velocity = { { 1.0, 0.4, -0.3 } };
  const auto uniform = cases.NewSource(vtkAnalyticFlowSource::UNIFORM);
  uniform->SetVelocity(velocity[0], velocity[1], velocity[2]);
  cases.Add("uniform", uniform,
    [velocity](const FlowVector& x, double t) { return reference::MapUniform(x, velocity, t); });

  AddRotation(cases);
  cases.AddSaddle("saddle", { { 1.0, 1.0, -2.0 } }, false);

  const FlowVector axis = { { 0.0, 0.0, 1.0 } };
  const FlowVector rates = { { -1.0, -0.8, -0.6 } };
  constexpr double swirl = 3.0;
  const auto spiral = cases.NewSource(vtkAnalyticFlowSource::NODE);
  spiral->SetNodeRates(rates[0], rates[1], rates[2]);
  spiral->SetSwirl(swirl);
  cases.Add("spiral", spiral,
    [rates, axis](const FlowVector& x, double t)
    { return reference::MapNode(x, {}, rates, axis, swirl, t); });
}

void AddStiffSaddle(CaseList& cases, const std::string& name, double ratio)
{
  cases.AddSaddle(name, { { -1.0, ratio, 0.5 * ratio } }, true);
}

void AddOtherFields(CaseList& cases)
{
  const auto pair = cases.NewSource(vtkAnalyticFlowSource::SOURCE_SINK);
  pair->SetSeparation(2.4, 0.0, 0.0);
  pair->SetStrength(2.0 * Pi);
  cases.Add("source-sink", pair);
  cases.Add("sphere", cases.NewSource(vtkAnalyticFlowSource::SPHERE));
  cases.Add("abc", cases.NewSource(vtkAnalyticFlowSource::ABC));
}
}

std::vector<FieldCase> MakeFieldCases(const BenchOptions& options)
{
  CaseList cases(options);
  AddLinearFields(cases);
  AddOtherFields(cases);
  AddStiffSaddle(cases, "stiff-1e2", 1e2);
  AddStiffSaddle(cases, "stiff-1e4", 1e4);
  AddStiffSaddle(cases, "stiff-1e6", 1e6);
  return cases.Take();
}

std::vector<Case> MakeSharingCases(const BenchOptions& options)
{
  CaseList cases(options);
  const auto shear = cases.NewSource(vtkAnalyticFlowSource::SHEAR);
  shear->SetThickness(0.1);
  cases.Add("shear", shear);
  AddRotation(cases);
  AddOtherFields(cases);
  cases.Add("hurricane", cases.NewSource(vtkAnalyticFlowSource::HURRICANE));
  AddStiffSaddle(cases, "stiff-1e2", 1e2);
  std::vector<Case> found;
  for (const FieldCase& field : cases.Take())
  {
    found.push_back(field.What);
  }
  return found;
}
}
