// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/SpaceTime/Interval4dCases.h"

#include "Benchmarks/Data/BenchData.h"
#include "Support/Inputs/DataFiles.h"
#include "Support/Inputs/ExodusTimeSource.h"

#include "vtkTimeVaryingIntervalVolume.h"

#include "vtkAnalyticFieldSource.h"
#include "vtkDeltaWingSource.h"
#include "vtkNew.h"
#include "vtkTaperedCylinderSource.h"

#include <stdexcept>

namespace interval4d
{
namespace
{
const char* const MugFile = "mug.ex2";

template <typename Source>
vtkSmartPointer<StoredTimeSteps> StoreTimeSteps(Source* source, int steps)
{
  source->SetNumberOfTimeSteps(steps);
  source->SetTimeRange(0.0, steps - 1.0);
  auto stored = vtkSmartPointer<StoredTimeSteps>::New();
  stored->AddStepsFrom(source);
  return stored;
}

Case MakeVortex(int steps, int points)
{
  vtkNew<vtkAnalyticFieldSource> source;
  source->SetFieldToVortex();
  source->SetDimensions(points, points, points);
  Case made{ "vortex-" + std::to_string(steps), StoreTimeSteps(source.Get(), steps), 0.6, 0.85,
    {} };
  if (points == 128)
  {
    made.Stated = steps == 2 ? StatedCounts{ 319304, 882044 } : StatedCounts{ 654846, 1807460 };
  }
  return made;
}

Case MakeWave(int points)
{
  vtkNew<vtkAnalyticFieldSource> source;
  source->SetFieldToWave();
  source->SetBounds(-2.0, 2.0, -1.0, 1.0, -1.0, 1.0);
  source->SetDimensions(2 * points, points, points);
  Case made{ "wave-2", StoreTimeSteps(source.Get(), 2), 0.77, 0.97, {} };
  if (points == 20)
  {
    made.Stated = { 82840, 234726 };
  }
  return made;
}

Case MakeCylinder(int points)
{
  vtkNew<vtkTaperedCylinderSource> source;
  source->SetDimensions(2 * points, 2 * points, points);
  Case made{ "cylinder-2", StoreTimeSteps(source.Get(), 2), 0.9915, 0.9925, {} };
  if (points == 32)
  {
    made.Stated = { 349624, 941098 };
  }
  return made;
}

Case MakeDelta()
{
  vtkNew<vtkDeltaWingSource> source;
  return { "delta-2", StoreTimeSteps(source.Get(), 2), 0.38, 0.7,
    StatedCounts{ 1003290, 2963812 } };
}

Case ReadMug()
{
  vtkNew<interlume::ExodusTimeSource> source;
  source->SetFileName(interlume::DataFile(MugFile));
  vtkNew<StoredTimeSteps> all;
  all->AddStepsFrom(source);
  Case made{ "mug", vtkSmartPointer<StoredTimeSteps>::New(), 0.3, 0.5, {} };
  for (int step = 0; step < all->GetNumberOfSteps(); ++step)
  {
    made.Steps->AddStep(all->GetStepTime(step),
      CopyWithOneArray(vtkDataSet::SafeDownCast(all->GetStep(step)), "diffused"));
  }
  return made;
}
}

vtkIdType Case::GetNumberOfCells() const
{
  return this->Steps->GetStep(0)->GetNumberOfElements(vtkDataObject::CELL);
}

vtkSmartPointer<vtkTimeVaryingIntervalVolume> Case::NewFilter() const
{
  auto filter = vtkSmartPointer<vtkTimeVaryingIntervalVolume>::New();
  filter->SetInputConnection(this->Steps->GetOutputPort());
  filter->SetInterval(0, this->Lower, this->Upper);
  return filter;
}

std::vector<std::string> GetCaseNames(const BenchOptions& options)
{
  return options.Pick<std::vector<std::string>>(
    { "vortex-2", "vortex-3", "wave-2", "cylinder-2", "delta-2", "mug" },
    { "vortex-2", "vortex-3", "wave-2", "cylinder-2", "mug" },
    { "vortex-3", "wave-2", "cylinder-2" });
}

Case MakeCase(const std::string& name, const BenchOptions& options)
{
  const bool isTiny = options.Size == BenchOptions::TINY;
  if (name == "vortex-2")
  {
    return MakeVortex(2, options.Pick(128, 128, 24));
  }
  if (name == "vortex-3")
  {
    return MakeVortex(3, options.Pick(128, 64, 24));
  }
  if (name == "wave-2")
  {
    return MakeWave(isTiny ? 10 : 20);
  }
  if (name == "cylinder-2")
  {
    return MakeCylinder(isTiny ? 12 : 32);
  }
  if (name == "delta-2")
  {
    return MakeDelta();
  }
  if (name == "mug")
  {
    return ReadMug();
  }
  throw std::runtime_error("The suite interval4d has no case " + name);
}
}
