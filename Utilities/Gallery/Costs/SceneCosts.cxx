// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Costs/SceneCosts.h"

#include "Gallery/Costs/ContextCount.h"
#include "Gallery/Costs/Feature.h"
#include "Gallery/Picture.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"
#include "Gallery/Stopwatch.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkNew.h"
#include "vtkRenderPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowedScenePass.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <set>
#include <utility>

namespace gallery
{
namespace
{
/// Takes one run of a state, and says what it took.
using Run = std::function<Costs()>;

double Quantile(std::vector<double> values, double share)
{
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0
                        : values[static_cast<std::size_t>(share * (values.size() - 1.0) + 0.5)];
}

/// Runs of one state: what it takes, with the median of times, and each time.
struct State
{
  Costs Taken;
  std::vector<double> Seconds;
};
State Repeat(const Run& run, int runs)
{
  State state;
  // The first one compiles and uploads, which is in no time.
  state.Taken = run();
  for (int i = 0; i < runs; ++i)
  {
    state.Taken = run();
    state.Seconds.push_back(state.Taken.Seconds);
  }
  state.Taken.Seconds = Quantile(state.Seconds, 0.5);
  return state;
}

/// Measures a feature in three states; \a begin makes all of them start alike.
FeatureCosts Measure(const Feature& feature, vtkObject* object, const Run& run,
  const std::function<void()>& begin, int runs)
{
  FeatureCosts costs;
  costs.Class = feature.Class;
  costs.Feature = feature.Name;
  begin();
  const State before = Repeat(run, runs);
  costs.OwnOff = feature.Own(object);
  const std::function<void()> switchOff = feature.SwitchOn(object);
  begin();
  const State on = Repeat(run, runs);
  costs.OwnOn = feature.Own(object);
  switchOff();
  begin();
  const State after = Repeat(run, runs);
  costs.OwnAfter = feature.Own(object);
  costs.Left = Subtract(after.Taken, before.Taken);
  costs.Added = Subtract(on.Taken, before.Taken);
  costs.Seconds = before.Taken.Seconds;
  costs.Spread = Quantile(before.Seconds, 0.75) - Quantile(before.Seconds, 0.25);
  return costs;
}

/// Measures the features of an object that are off and were not measured before.
class Meter
{
public:
  Meter(SceneCosts& costs, int runs, const std::string& onlyClass)
    : Found(costs)
    , Runs(runs)
    , OnlyClass(onlyClass)
  {
  }

  void Add(vtkObject* object, const Run& run, const std::function<void()>& begin)
  {
    for (const Feature& feature : AllFeatures())
    {
      const bool isAsked = this->OnlyClass.empty() || this->OnlyClass == feature.Class;
      if (isAsked && feature.Class == object->GetClassName() && !feature.IsOn(object) &&
        this->Measured.insert({ feature.Class, feature.Name }).second)
      {
        this->Found.Features.push_back(Measure(feature, object, run, begin, this->Runs));
      }
    }
  }

private:
  SceneCosts& Found;
  int Runs;
  std::string OnlyClass;
  std::set<std::pair<std::string, std::string>> Measured;
};

void AddFilter(vtkAlgorithm* filter, Meter& meter)
{
  vtkNew<vtkCallbackCommand> nothing;
  // A feature may have nothing to do here, which filters say.
  const unsigned long tag = filter->AddObserver(vtkCommand::WarningEvent, nothing);
  const Run run = [filter]()
  {
    filter->Modified();
    const Stopwatch watch;
    filter->Update();
    Costs taken;
    taken.Seconds = watch.Seconds();
    ExecutionCosts made;
    made.AddOutputs(filter);
    taken.Arrays = made.Arrays;
    taken.Bytes = static_cast<double>(made.Bytes);
    taken.Passes = 1.0;
    return taken;
  };
  meter.Add(filter, run, []() {});
  filter->RemoveObserver(tag);
}

/// The passes that what a renderer draws reports.
double CountPasses(vtkRenderer* renderer)
{
  double passes = 0.0;
  vtkVolumeCollection* volumes = renderer->GetVolumes();
  vtkCollectionSimpleIterator cookie;
  volumes->InitTraversal(cookie);
  while (vtkVolume* volume = volumes->GetNextVolume(cookie))
  {
    vtkObject* mapper = volume->GetMapper();
    if (auto* slices = vtkShadowedSliceMapper::SafeDownCast(mapper))
    {
      const vtkShadowedSliceReport& report = slices->GetReport();
      passes +=
        report.EyePasses + report.LightPasses + report.OcclusionPasses + report.SoftShadowPasses;
    }
    else if (auto* paint = vtkImplicitFlowVolumeMapper::SafeDownCast(mapper))
    {
      passes += paint->GetReport().Passes + paint->GetReport().Slices;
    }
    else if (auto* tetrahedra = vtkTimeWeightedTetrahedraMapper::SafeDownCast(mapper))
    {
      passes += tetrahedra->GetReport().Passes;
    }
  }
  if (auto* scene = vtkShadowedScenePass::SafeDownCast(renderer->GetPass()))
  {
    const vtkShadowedSceneReport& report = scene->GetReport();
    passes += report.DepthMaps + report.SampleMaps + report.EyeDepthPasses + report.ReceiverPasses;
  }
  return passes;
}

void AddPanel(Panel& panel, int width, int height, Meter& meter)
{
  // The first drawing prepares what the panel is drawn by.
  panel.Draw(width, height);
  vtkRenderer* renderer = panel.GetRenderer();
  vtkSmartPointer<vtkRenderWindow> window;
  const auto open = [&]()
  {
    window = MakeWindow(width, height);
    window->AddRenderer(renderer);
  };
  // A pass compiles what the picture before had before it knows of a change, and OpenGL keeps that.
  const std::function<void()> begin = [&]()
  {
    open();
    panel.DrawIn(window);
    open();
  };
  const Run run = [&]()
  {
    const Stopwatch watch;
    panel.DrawIn(window);
    Costs taken;
    taken.Seconds = watch.Seconds();
    const ContextCount count = CountContext(window);
    taken.Buffers = count.Buffers;
    taken.Bytes = static_cast<double>(count.Bytes);
    taken.Words = static_cast<double>(count.Words);
    taken.Passes = CountPasses(renderer);
    return taken;
  };
  vtkVolumeCollection* volumes = renderer->GetVolumes();
  std::vector<vtkSmartPointer<vtkObject>> objects;
  for (int i = 0; i < volumes->GetNumberOfItems(); ++i)
  {
    objects.emplace_back(static_cast<vtkVolume*>(volumes->GetItemAsObject(i))->GetMapper());
  }
  if (renderer->GetPass())
  {
    objects.emplace_back(renderer->GetPass());
  }
  for (vtkObject* object : objects)
  {
    meter.Add(object, run, begin);
  }
}
}

Costs Subtract(const Costs& one, const Costs& other)
{
  return { one.Passes - other.Passes, one.Buffers - other.Buffers, one.Bytes - other.Bytes,
    one.Words - other.Words, one.Arrays - other.Arrays, one.Seconds - other.Seconds };
}

SceneCosts MeasureSceneCosts(
  const Scene& scene, int width, int height, int runs, const std::string& onlyClass)
{
  SceneCosts costs;
  costs.Scene = scene.Id;
  Meter meter(costs, runs, onlyClass);
  Stage stage(width, height);
  std::vector<vtkSmartPointer<vtkAlgorithm>> filters;
  {
    const ExecutionWatch watch;
    scene.Build(stage);
    costs.Executed = watch.GetClasses();
    filters = watch.GetAlgorithms();
  }
  for (vtkAlgorithm* filter : filters)
  {
    AddFilter(filter, meter);
  }
  filters.clear();
  for (const std::unique_ptr<Panel>& panel : stage.FitPanels())
  {
    AddPanel(*panel, width, height, meter);
  }
  return costs;
}
}
