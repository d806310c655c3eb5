// SPDX-License-Identifier: BSD-3-Clause
// Tests progress and aborts of images: the times and fractions of the events, and for each of the
// three volume mappers an abort at each event, after which the next image is complete.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Drawing/DrawingAborts.h"
#include "Support/Drawing/ImageCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Images/FlowImages.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Images/VolumeStage.h"

#include "Refinement/RenderProgress.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace
{

using namespace reference;
using interlume::RenderProgress;
using Clock = std::chrono::steady_clock;

constexpr std::array<int, 2> SIZE = { { 500, 400 } };

double GetSeconds(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Records the progress events of a mapper, and may abort the window at one of them.
class ProgressLog
{
public:
  ProgressLog(vtkAlgorithm* mapper, vtkRenderWindow* window)
    : Mapper(mapper)
    , Window(window)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject*, unsigned long, void* log, void* fraction)
      { static_cast<ProgressLog*>(log)->Add(*static_cast<double*>(fraction)); });
    this->Tag = mapper->AddObserver(vtkCommand::VolumeMapperRenderProgressEvent, command);
  }
  ~ProgressLog() { this->Mapper->RemoveObserver(this->Tag); }

  void Begin(int abortAt = -1)
  {
    this->Fractions.clear();
    this->Times.clear();
    this->AbortAt = abortAt;
    this->Start = Clock::now();
  }

  /// Checks that events are at least EVENT_SECONDS apart, and that fractions do not decrease.
  void Test(Check& check, const std::string& name) const
  {
    double last = 0.0;
    for (const double time : this->Times)
    {
      // RenderProgress uses another clock.
      check.That(time - last > 0.95 * RenderProgress::EVENT_SECONDS, name + ": time of an event");
      last = time;
    }
    check.That(std::is_sorted(this->Fractions.begin(), this->Fractions.end()) &&
        (this->Fractions.empty() ||
          (this->Fractions.front() >= 0.0 && this->Fractions.back() <= 1.0)),
      name + ": fractions");
  }

  std::vector<double> Fractions;

private:
  void Add(double fraction)
  {
    if (static_cast<int>(this->Times.size()) == this->AbortAt)
    {
      this->Window->SetAbortRender(1);
    }
    this->Fractions.push_back(fraction);
    this->Times.push_back(GetSeconds(this->Start));
  }

  vtkAlgorithm* Mapper;
  vtkRenderWindow* Window;
  unsigned long Tag = 0;
  int AbortAt = -1;
  Clock::time_point Start;
  std::vector<double> Times;
};

void TestEvents(Check& check)
{
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkTimeWeightedTetrahedraMapper> mapper;
  ProgressLog log(mapper, window);
  log.Begin();
  RenderProgress progress(window, mapper);
  check.That(!progress.IsAborted(0.0), "not aborted");
  check.That(log.Fractions.empty(), "no event at once");
  constexpr int steps = 50;
  for (int i = 0; i < steps; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const std::size_t events = log.Fractions.size();
    const double fraction = static_cast<double>(i) / steps;
    progress.IsAborted(fraction);
    check.That(log.Fractions.size() == events || log.Fractions.back() == fraction,
      "the fraction of an event");
  }
  check.That(!log.Fractions.empty(), "events");
  log.Test(check, "events");
  window->SetAbortRender(1);
  check.That(progress.IsAborted(1.0) && progress.WasAborted(), "aborted");
  window->SetAbortRender(0);
  check.That(!progress.IsAborted(1.0) && !progress.WasAborted(), "not aborted any more");
}

/// Tests progress and aborts of the window's image. The camera moves before each image, so that no
/// part of the previous image is reused.
void TestImage(Check& check, const std::string& name, VolumeStage& stage, vtkAlgorithm* mapper)
{
  vtkRenderWindow* window = stage.GetWindow();
  vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
  ProgressLog log(mapper, window);
  camera->Azimuth(20.0);
  ReadWindow(window);
  camera->Azimuth(-20.0);
  log.Begin();
  const auto start = Clock::now();
  const RgbaImage complete = ReadWindow(window);
  const double seconds = GetSeconds(start);
  log.Test(check, name);
  const int events = static_cast<int>(log.Fractions.size());
  // A fast OpenGL draws the image without events. The limit is high, since the time includes
  // waiting for other programs.
  check.That(events > 0 || seconds < 20.0 * RenderProgress::EVENT_SECONDS,
    name + ": events in " + std::to_string(seconds) + " s");
  for (int event = 0; event < events; ++event)
  {
    const std::string at = name + ", abort at event " + std::to_string(event);
    camera->Azimuth(20.0);
    ReadWindow(window);
    camera->Azimuth(-20.0);
    log.Begin(event);
    const RgbaImage aborted = ReadWindow(window);
    const bool isAborted = static_cast<int>(log.Fractions.size()) > event;
    window->SetAbortRender(0);
    log.Begin();
    check.That(!isAborted || CompareImages(aborted, complete).Max > 0.0, at + ": incomplete");
    check.That(CompareImages(ReadWindow(window), complete).Max == 0.0, at + ": the next image");
  }
}

void TestTetrahedra(Check& check)
{
  VolumeStage stage(SIZE);
  vtkNew<vtkTimeWeightedTetrahedraMapper> mapper;
  const auto grid = MakeCube(40);
  mapper->SetInputData(static_cast<vtkDataSet*>(grid));
  mapper->SetRenderPath(vtkTimeWeightedTetrahedraMapper::SOFTWARE_PATH);
  stage.SetVolume(mapper, MakeRamp(0.1, 1.0, 2.0));
  stage.SetCamera(LookAt(grid, { { 0.3, -0.4, 1.0 } }, false));
  TestImage(check, "tetrahedra", stage, mapper);
  CheckDrawingAborts(stage.GetWindow(), check);
}

void TestSlices(Check& check)
{
  ShadowScene scene =
    MakeScene(MakeImage(64, MakeSphere(0.15, 0.45)), MakeTranslucentProperty(0.6, true));
  VolumeStage stage(SIZE);
  vtkNew<vtkShadowedSliceMapper> mapper;
  SetScene(stage, mapper, scene);
  TestImage(check, "slices", stage, mapper);
  CheckDrawingAborts(stage.GetWindow(), check);
}

void TestFlow(Check& check)
{
  VolumeStage stage(SIZE);
  vtkNew<vtkImplicitFlowVolumeMapper> mapper;
  const auto voxels = MakeFlowVoxels(65,
    [](const Position3& x) {
      return FlowEnd{ true, 0, x[1] + 0.5, x[2] + 0.5, x[0] + 0.5 };
    });
  const auto paint = MakePaint(33, 33,
    [](double u, double v) {
      return Color4{ { u, 0.4, v, 0.5 } };
    });
  mapper->SetInputData(static_cast<vtkDataSet*>(voxels));
  mapper->SetInflowTexture(0, paint);
  vtkNew<vtkVolumeProperty> property;
  property->SetScalarOpacityUnitDistance(0.3);
  stage.SetVolume(mapper, property);
  stage.SetCamera(LookAt({ { 0.0, 0.0, 0.0 } }, 0.87, { { -0.5, 0.6, -0.4 } }, false));
  TestImage(check, "flow", stage, mapper);
}
}

int TestRenderProgress(int, char*[])
{
  return RunChecks({ TestEvents, TestTetrahedra, TestSlices, TestFlow });
}
