// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Costs/SceneCosts.h"

#include "Gallery/Costs/ContextCount.h"
#include "Gallery/Costs/ExecutionWatch.h"
#include "Gallery/Costs/Feature.h"
#include "Gallery/GalleryImage.h"
#include "Gallery/Scene.h"
#include "Gallery/SceneReport.h"
#include "Gallery/Stage.h"
#include "Gallery/Stopwatch.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkNew.h"
#include "vtkRenderPass.h"
#include "vtkShadowedScenePass.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"

#include <algorithm>
#include <ctime>
#include <functional>
#include <iterator>
#include <memory>
#include <set>
#include <utility>

namespace gallery
{
namespace
{
double Quantile(std::vector<double> values, double fraction)
{
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0
                        : values[static_cast<std::size_t>(fraction * (values.size() - 1.0) + 0.5)];
}

double GetSpread(const std::vector<double>& values)
{
  return Quantile(values, 0.75) - Quantile(values, 0.25);
}

/// Measures the CPU time of all threads since construction.
class ProcessorWatch
{
public:
  double Seconds() const
  {
    return static_cast<double>(std::clock() - this->Start) / CLOCKS_PER_SEC;
  }

private:
  std::clock_t Start = std::clock();
};

/// An object of a scene that may have features.
struct Subject
{
  vtkObject* Object;
  /// Performs one run and returns its costs.
  std::function<Costs()> Run;
  /// Called before the runs in each state of a feature (not yet switched on, on, off again), so
  /// that all states start under the same conditions.
  std::function<void()> Begin;
};

/// Differences between the times of two subjects that run alternately.
struct Pairs
{
  std::vector<double> Differences;
  /// Times of the second subject.
  std::vector<double> Seconds;

  /// Adds up to \a maximum pairs of runs within the time limit, but at least two. The subjects take
  /// turns at running first.
  void Add(const Subject& one, const Subject& other, const CostSettings& settings, int maximum)
  {
    const Stopwatch watch;
    for (int i = 0; i < maximum && (i < 2 || watch.Seconds() < settings.Limit); ++i)
    {
      const double before = i % 2 == 0 ? 0.0 : one.Run().Seconds;
      this->Seconds.push_back(other.Run().Seconds);
      const double seconds = i % 2 == 0 ? one.Run().Seconds : before;
      this->Differences.push_back(seconds - this->Seconds.back());
    }
  }
};

/// Measures each feature at the first object in which it is off.
class Meter
{
public:
  explicit Meter(const CostSettings& settings)
    : Settings(settings)
  {
  }

  const std::vector<FeatureCosts>& Get() const { return this->Found; }

  /// Measures the features of \a subject. \a never is its counterpart in a copy of the scene in
  /// which no feature is ever switched on. The object of \a never is null if there is no
  /// counterpart.
  void Add(const Subject& subject, const Subject& never)
  {
    // Pairs of runs before any feature is switched on.
    Pairs without;
    for (const Feature& feature : AllFeatures())
    {
      const bool isSelected = feature.Class == subject.Object->GetClassName() &&
        (this->Settings.OnlyClass.empty() || this->Settings.OnlyClass == feature.Class);
      if (isSelected && !feature.IsOn(subject.Object) &&
        this->Measured.insert({ feature.Class, feature.Name }).second)
      {
        if (never.Object && without.Differences.empty())
        {
          never.Begin();
          subject.Begin();
          // Two warm-up pairs fill caches and are not evaluated.
          Pairs().Add(subject, never, this->Settings, 2);
          without.Add(subject, never, this->Settings, this->Settings.Pairs);
        }
        this->Found.push_back(this->Measure(feature, subject, never, without));
      }
    }
  }

private:
  FeatureCosts Measure(
    const Feature& feature, const Subject& subject, const Subject& never, const Pairs& without)
  {
    FeatureCosts costs;
    costs.Class = feature.Class;
    costs.Feature = feature.Name;
    Costs stateCosts[3];
    double* own[3] = { &costs.OwnOff, &costs.OwnOn, &costs.OwnAfter };
    Pairs pairs[3];
    std::function<void()> switchOff;
    for (int state = 0; state < 3; ++state)
    {
      if (state == 1)
      {
        switchOff = feature.SwitchOn(subject.Object);
      }
      else if (state == 2)
      {
        switchOff();
      }
      subject.Begin();
      // The first run compiles shaders and uploads data; it is not timed.
      stateCosts[state] = subject.Run();
      if (never.Object && state > 0)
      {
        // The counterpart must start under the same conditions.
        never.Begin();
        never.Run();
        pairs[state].Add(subject, never, this->Settings, this->Settings.Pairs);
      }
      if (state == 2 && ExceedsNoise(pairs[2], without))
      {
        // More pairs are measured to distinguish a true difference from noise.
        pairs[state].Add(subject, never, this->Settings, 3 * this->Settings.Pairs);
      }
      *own[state] = feature.Own(subject.Object);
    }
    costs.Left = Subtract(stateCosts[2], stateCosts[0]);
    costs.Added = Subtract(stateCosts[1], stateCosts[0]);
    const double usual = Quantile(without.Differences, 0.5);
    costs.Left.Seconds = Quantile(pairs[2].Differences, 0.5) - usual;
    costs.Added.Seconds = Quantile(pairs[1].Differences, 0.5) - usual;
    costs.Seconds = Quantile(pairs[2].Seconds, 0.5);
    costs.Noise = GetNoise(pairs[2], without);
    costs.Pairs = static_cast<int>(pairs[2].Differences.size());
    costs.PairsOn = static_cast<int>(pairs[1].Differences.size());
    return costs;
  }

  static double GetNoise(const Pairs& after, const Pairs& without)
  {
    return std::max(GetSpread(after.Differences), GetSpread(without.Differences));
  }
  static bool ExceedsNoise(const Pairs& after, const Pairs& without)
  {
    return Quantile(after.Differences, 0.5) - Quantile(without.Differences, 0.5) >
      GetNoise(after, without);
  }

  std::vector<FeatureCosts> Found;
  const CostSettings& Settings;
  std::set<std::pair<std::string, std::string>> Measured;
};

/// Adds the number of arrays and the bytes of all outputs of \a filter to \a costs.
void AddOutputs(vtkAlgorithm* filter, Costs& costs)
{
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    for (int type = 0; output && type < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++type)
    {
      vtkFieldData* arrays = output->GetAttributesAsFieldData(type);
      costs.Arrays += arrays ? arrays->GetNumberOfArrays() : 0;
    }
    costs.Bytes += output ? 1024.0 * static_cast<double>(output->GetActualMemorySize()) : 0.0;
  }
}

Subject MakeSubject(vtkAlgorithm* filter)
{
  const auto run = [filter]()
  {
    vtkNew<vtkCallbackCommand> ignore;
    // Ignores warnings: filters warn if a feature has no effect on their input.
    const unsigned long tag = filter->AddObserver(vtkCommand::WarningEvent, ignore);
    filter->Modified();
    const ProcessorWatch watch;
    filter->Update();
    Costs costs;
    costs.Seconds = watch.Seconds();
    filter->RemoveObserver(tag);
    AddOutputs(filter, costs);
    costs.Passes = 1.0;
    return costs;
  };
  return { filter, run, []() {} };
}

/// Returns the number of passes reported by the volume mappers and the render pass.
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
      passes += SumValues(slices->GetReport(),
        { "ImagePasses", "LightPasses", "OcclusionPasses", "SoftShadowPasses" });
    }
    else if (auto* paint = vtkImplicitFlowVolumeMapper::SafeDownCast(mapper))
    {
      passes += SumValues(paint->GetReport(), { "Passes", "Slices" });
    }
    else if (auto* tetrahedra = vtkTimeWeightedTetrahedraMapper::SafeDownCast(mapper))
    {
      passes += tetrahedra->GetReport()->GetNumber("Passes");
    }
  }
  if (auto* scene = vtkShadowedScenePass::SafeDownCast(renderer->GetPass()))
  {
    passes += SumValues(
      scene->GetReport(), { "DepthMaps", "SampleMaps", "CameraDepthPasses", "ReceiverPasses" });
  }
  return passes;
}

/// A panel that is drawn in a separate window. Subject::Begin() opens a new window.
class DrawnPanel
{
public:
  DrawnPanel(Panel& panel, const CostSettings& settings)
    : Drawn(panel)
    , Settings(settings)
  {
    // The first call to Draw() creates the panel's render passes.
    panel.Draw(settings.Width, settings.Height);
  }
  DrawnPanel(const DrawnPanel&) = delete;
  void operator=(const DrawnPanel&) = delete;

  /// Returns the objects that may have features: the volume mappers and the render pass.
  std::vector<Subject> GetSubjects()
  {
    std::vector<Subject> subjects;
    vtkRenderer* renderer = this->Drawn.GetRenderer();
    vtkVolumeCollection* volumes = renderer->GetVolumes();
    for (int i = 0; i < volumes->GetNumberOfItems(); ++i)
    {
      subjects.push_back(
        this->MakeSubject(static_cast<vtkVolume*>(volumes->GetItemAsObject(i))->GetMapper()));
    }
    if (renderer->GetPass())
    {
      subjects.push_back(this->MakeSubject(renderer->GetPass()));
    }
    return subjects;
  }

private:
  Subject MakeSubject(vtkObject* object)
  {
    return { object, [this]() { return this->Run(); },
      [this]()
      {
        // In a new window, a pass first compiles the shaders of its previous state, and OpenGL
        // retains them. Drawing in another window before keeps these shaders out of the measured
        // window.
        this->Open();
        this->Drawn.DrawIn(this->Window);
        this->Open();
      } };
  }

  void Open()
  {
    this->Window = MakeWindow(this->Settings.Width, this->Settings.Height);
    this->Window->AddRenderer(this->Drawn.GetRenderer());
  }

  Costs Run()
  {
    const ProcessorWatch watch;
    this->Drawn.DrawIn(this->Window);
    Costs costs;
    costs.Seconds = watch.Seconds();
    const ContextCount count = CountContextResources(this->Window);
    costs.Buffers = count.Buffers;
    costs.Bytes = static_cast<double>(count.Bytes);
    costs.Words = static_cast<double>(count.Words);
    costs.Passes = CountPasses(this->Drawn.GetRenderer());
    return costs;
  }

  Panel& Drawn;
  const CostSettings& Settings;
  vtkSmartPointer<vtkRenderWindow> Window;
};

/// A built scene and its filters.
class BuiltScene
{
public:
  BuiltScene(const Scene& scene, const CostSettings& settings)
    : Settings(settings)
    , SceneStage({ settings.Width, settings.Height })
  {
    const ExecutionWatch watch;
    scene.Build(this->SceneStage);
    this->Filters = watch.GetAlgorithms();
  }

  std::vector<Subject> GetFilters() const
  {
    std::vector<Subject> subjects;
    std::transform(
      this->Filters.begin(), this->Filters.end(), std::back_inserter(subjects), &MakeSubject);
    return subjects;
  }

  /// Releases the filters, which are not needed while panels are drawn.
  void DropFilters() { this->Filters.clear(); }

  std::size_t GetNumberOfPanels() { return this->SceneStage.FitPanels().size(); }
  DrawnPanel Draw(std::size_t panel)
  {
    return DrawnPanel(*this->SceneStage.FitPanels()[panel], this->Settings);
  }

private:
  const CostSettings& Settings;
  Stage SceneStage;
  std::vector<vtkSmartPointer<vtkAlgorithm>> Filters;
};

/// Measures the features of \a subjects. Times are relative to those of the counterparts in
/// \a never.
void Add(Meter& meter, const std::vector<Subject>& subjects, const std::vector<Subject>& never)
{
  for (std::size_t i = 0; i < subjects.size(); ++i)
  {
    const bool isSame = i < never.size() &&
      std::string(never[i].Object->GetClassName()) == subjects[i].Object->GetClassName();
    meter.Add(subjects[i], isSame ? never[i] : Subject{ nullptr, {}, {} });
  }
}
}

bool FeatureCosts::IsWithinNoise() const
{
  return this->Left.Seconds <= this->Noise;
}

Costs Subtract(const Costs& one, const Costs& other)
{
  return { one.Passes - other.Passes, one.Buffers - other.Buffers, one.Bytes - other.Bytes,
    one.Words - other.Words, one.Arrays - other.Arrays, one.Seconds - other.Seconds };
}

std::vector<FeatureCosts> MeasureSceneCosts(const Scene& scene, const CostSettings& settings)
{
  Meter meter(settings);
  BuiltScene built(scene, settings);
  const auto never = settings.Pairs > 0 ? std::make_unique<BuiltScene>(scene, settings)
                                        : std::unique_ptr<BuiltScene>();
  Add(meter, built.GetFilters(), never ? never->GetFilters() : std::vector<Subject>());
  built.DropFilters();
  if (never)
  {
    never->DropFilters();
  }
  for (std::size_t i = 0; i < built.GetNumberOfPanels(); ++i)
  {
    DrawnPanel panel = built.Draw(i);
    if (never)
    {
      DrawnPanel without = never->Draw(i);
      Add(meter, panel.GetSubjects(), without.GetSubjects());
    }
    else
    {
      Add(meter, panel.GetSubjects(), {});
    }
  }
  return meter.Get();
}
}
