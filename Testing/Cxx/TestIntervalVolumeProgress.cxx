// Progress is told and never runs backwards, an abort leaves a valid output, and PrintSelf prints
// every public value.
#include "ReferenceCheck.h"
#include "ReferenceField.h"
#include "ReferenceGrid.h"
#include "ReferenceLattice.h"
#include "ReferenceMesh.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <sstream>

namespace
{

using namespace reference;

struct Watch
{
  std::vector<double> Progress;
  double AbortAt = 2;
};

void OnProgress(vtkObject* caller, unsigned long, void* client, void* data)
{
  auto* watch = static_cast<Watch*>(client);
  watch->Progress.push_back(*static_cast<double*>(data));
  if (watch->Progress.back() >= watch->AbortAt)
  {
    vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
  }
}

void Observe(vtkAlgorithm* filter, Watch& watch)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(OnProgress);
  command->SetClientData(&watch);
  filter->AddObserver(vtkCommand::ProgressEvent, command);
}

void CheckFilter(vtkUnstructuredGridAlgorithm* filter, vtkDataSet* data, int type, Check& check)
{
  filter->SetInputDataObject(data);
  Watch watch;
  Observe(filter, watch);
  filter->Update();
  const vtkIdType cells = filter->GetOutput()->GetNumberOfCells();
  check.That(cells > 0, "there is output");
  check.That(watch.Progress.size() >= 3, "progress is told at least three times");
  check.That(std::is_sorted(watch.Progress.begin(), watch.Progress.end()), "progress grows");
  check.That(!watch.Progress.empty() && watch.Progress.front() >= 0 && watch.Progress.back() <= 1,
    "progress is between 0 and 1");

  for (double at : { 0.0, 0.3, 0.6, 0.9 })
  {
    watch = Watch();
    watch.AbortAt = at;
    filter->Modified();
    filter->Update();
    check.That(IsValid(filter->GetOutput(), type), "an aborted output is valid");
    check.That(filter->GetOutput()->GetNumberOfCells() <= cells, "and no larger");
    check.That(at > 0 || filter->GetOutput()->GetNumberOfCells() == 0,
      "aborted at once, the output is empty");
  }
  watch = Watch();
  filter->SetAbortExecute(0);
  filter->Modified();
  filter->Update();
  check.Equal(filter->GetOutput()->GetNumberOfCells(), cells, "cells after an abort is taken back");
}

template <typename Filter>
std::string Printed(Filter* filter)
{
  std::ostringstream text;
  filter->Print(text);
  return text.str();
}

void CheckPrinted(const std::string& text, const std::vector<std::string>& expected, Check& check)
{
  for (const std::string& part : expected)
  {
    check.That(text.find(part) != std::string::npos, "PrintSelf prints " + part);
  }
}

void CheckPrint(Check& check)
{
  const std::vector<std::string> report = { "Cells", "CellsVisited", "CellsWithOutput",
    "LowerDimensionalCells", "NonFiniteCells", "BlankedCells", "LinearizedCells",
    "UnsupportedCells", "CollapsedSimplices", "ArraysInterpolated", "ArraysCopied", "Passes",
    "WorkingBytes" };
  vtkNew<vtkIntervalVolume> volume;
  volume->SetInterval(0, 1.25, 2.5);
  volume->SetInterval(1, 3.125, 4.75);
  volume->AddCriterion("density", 17.5, 18.25);
  const std::string volumeText = Printed(volume.Get());
  CheckPrinted(volumeText, report, check);
  CheckPrinted(volumeText,
    { "GenerateBoundaries", "OutputPointsPrecision", "UseValueIndex", "1.25", "2.5", "3.125",
      "4.75", "density", "17.5", "18.25" },
    check);
  vtkNew<vtkIsotableContour> contour;
  contour->SetValue(0, 6.375);
  contour->SetValue(1, 7.625);
  const std::string contourText = Printed(contour.Get());
  CheckPrinted(contourText, report, check);
  CheckPrinted(contourText, { "OutputPointsPrecision", "UseValueIndex", "6.375", "7.625" }, check);
}

}

int TestIntervalVolumeProgress(int, char*[])
{
  Check check;
  auto image = MakeImage({ 40, 40, 40 });
  AddRandomField(image, 2);
  auto mesh = MakeMesh(MeshKind::Mixed, { 20, 20, 20 });
  AddRandomField(mesh, 2);
  vtkDataSet* const inputs[] = { image, mesh };
  for (vtkDataSet* data : inputs)
  {
    check.SetContext(std::string("intervals of ") + data->GetClassName());
    vtkNew<vtkIntervalVolume> volume;
    volume->SetInterval(0, 0.2, 0.4);
    volume->GenerateBoundariesOn();
    CheckFilter(volume, data, VTK_TETRA, check);
    check.SetContext(std::string("contours of ") + data->GetClassName());
    vtkNew<vtkIsotableContour> contour;
    contour->SetValue(0, 0.4);
    CheckFilter(contour, data, VTK_TRIANGLE, check);
  }
  check.SetContext("print");
  CheckPrint(check);
  return check.Result();
}
