// SPDX-License-Identifier: BSD-3-Clause
// Tests the progress of an image, also before its first pixel, and its abort in each part.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Drawing/ImageCases.h"
#include "Support/Images/VolumeStage.h"
#include "Tetrahedra/MapperImage.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkRenderWindow.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

namespace
{

using namespace reference;

/// Observes a mapper and its window. Unless IsFast, the functions take as long as the mapper and
/// the window wait between events, so that none is omitted.
class Observer
{
public:
  Observer(vtkTimeWeightedTetrahedraMapper* mapper, vtkRenderWindow* window)
    : Window(window)
  {
    mapper->AddObserver(vtkCommand::ProgressEvent, this, &Observer::AddProgress);
    window->AddObserver(vtkCommand::AbortCheckEvent, this, &Observer::CheckAbort);
  }

  void AddProgress(vtkObject*, unsigned long, void* fraction)
  {
    this->Fractions.push_back(*static_cast<double*>(fraction));
    this->Wait(210);
  }

  void CheckAbort(vtkObject*, unsigned long, void*)
  {
    ++this->Checks;
    if (this->Checks == this->AbortedCheck)
    {
      this->Window->SetAbortRender(1);
    }
    this->Wait(110);
  }

  std::vector<double> Fractions;
  int Checks = 0;
  /// Number of the check that aborts, or 0.
  int AbortedCheck = 0;
  bool IsFast = false;

private:
  void Wait(int milliseconds) const
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(this->IsFast ? 0 : milliseconds));
  }

  vtkRenderWindow* Window;
};

double GetSum(const RgbaImage& image)
{
  double sum = 0.0;
  for (const double value : image.Values)
  {
    sum += std::abs(value);
  }
  return sum;
}

}

int TestTetrahedraMapperProgress(int, char*[])
{
  Check check;
  auto grid = MakeCube(6);
  auto property = MakeRamp(0.1, 1.0, 0.25);
  VolumeStage stage(std::array<int, 2>{ { 64, 64 } });
  vtkNew<vtkTimeWeightedTetrahedraMapper> mapper;
  mapper->SetInputData(static_cast<vtkDataSet*>(grid));
  mapper->SetRenderPath(vtkTimeWeightedTetrahedraMapper::SOFTWARE_PATH);
  stage.SetVolume(mapper, property);
  stage.SetCamera(LookAt(grid, { { 0.3, -0.4, 1.0 } }, false));
  const RgbaImage expected = stage.Capture(1);

  Observer observer(mapper, stage.GetWindow());
  grid->Modified();
  grid->GetPoints()->Modified();
  grid->GetPoints()->SetPoint(0, 0.01, 0.0, 0.0);
  const RgbaImage changed = stage.Capture(1);
  const std::vector<double> fractions = observer.Fractions;
  check.That(fractions.size() >= 4, "several events");
  check.That(std::is_sorted(fractions.begin(), fractions.end()), "progress increases");
  check.That(!fractions.empty() && fractions.front() > 0.0 && fractions.front() < 0.2 &&
      fractions.back() <= 1.0,
    "progress before the first pixel");
  check.That(std::string(mapper->GetProgressText()) == "Rendering", "text");

  const int checks = observer.Checks;
  check.That(checks >= 3, "several checks");
  for (int aborted : { 1, 2, 3, checks })
  {
    const std::string name = "abort at check " + std::to_string(aborted);
    observer.Checks = 0;
    observer.AbortedCheck = aborted;
    observer.IsFast = false;
    grid->GetPoints()->SetPoint(0, 0.01 * aborted, 0.01, 0.0);
    grid->GetPoints()->Modified();
    grid->Modified();
    check.That(GetSum(stage.Capture(1)) == 0.0, name);
    check.Equal(observer.Checks, aborted, name + ": checks");
    observer.AbortedCheck = 0;
    observer.IsFast = true;
    const RgbaImage after = stage.Capture(1);
    vtkNew<vtkTimeWeightedTetrahedraMapper> fresh;
    fresh->SetInputData(static_cast<vtkDataSet*>(grid));
    fresh->SetRenderPath(vtkTimeWeightedTetrahedraMapper::SOFTWARE_PATH);
    VolumeStage other(std::array<int, 2>{ { 64, 64 } });
    other.SetVolume(fresh, property);
    other.SetCamera(LookAt(grid, { { 0.3, -0.4, 1.0 } }, false));
    check.That(after.Values == other.Capture(1).Values, name + ": the image after it");
  }
  check.That(GetSum(expected) > 0.0 && GetSum(changed) > 0.0, "images");
  return check.Result();
}
