// SPDX-License-Identifier: BSD-3-Clause
// Paints on the inflow of a flow and shows the paint carried along, while it is painted. The paint
// is a PNG file that any program can read, and that this one goes on with when it is there.
//
//   InflowPainter post.vts Velocity paint.png
//   InflowPainter post.vts Velocity paint.png --points 96 --record events.log
//   InflowPainter post.vts Velocity paint.png --replay events.log --picture painter.png
//
// On the left, the left button paints; sliders and keys choose the brush (PainterWindow.h has
// them). On the right, the left button turns the view.

#include "../MakeReader.h"
#include "PainterWindow.h"

#include <vtkDataObject.h>
#include <vtkImageData.h>
#include <vtkImplicitFlowField.h>
#include <vtkInteractorEventRecorder.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkTerminationInflow.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <string>

namespace
{
/// As many cells along the longest edge as are asked for, as long along the others.
void SetImage(vtkImplicitFlowField* filter, vtkDataSet* field, int points)
{
  double bounds[6];
  field->GetBounds(bounds);
  double lengths[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    lengths[axis] = bounds[2 * axis + 1] - bounds[2 * axis];
  }
  const double cell = *std::max_element(lengths, lengths + 3) / (points - 1);
  int numbers[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    numbers[axis] = std::max(2, static_cast<int>(std::lround(lengths[axis] / cell)) + 1);
  }
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  filter->SetSampleDimensions(numbers[0], numbers[1], numbers[2]);
}

/// Columns and rows of a page with the proportions of a rectangle.
void GetPageSize(vtkTerminationPlane* plane, int size[2])
{
  constexpr double longest = 512.0;
  const double width =
    std::sqrt(vtkMath::Distance2BetweenPoints(plane->GetOrigin(), plane->GetPoint1()));
  const double height =
    std::sqrt(vtkMath::Distance2BetweenPoints(plane->GetOrigin(), plane->GetPoint2()));
  const double scale = longest / std::max(width, height);
  size[0] = std::max(16, static_cast<int>(std::lround(scale * width)));
  size[1] = std::max(16, static_cast<int>(std::lround(scale * height)));
}

bool WritePicture(vtkRenderWindow* window, const std::string& file)
{
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(file.c_str());
  writer->Write();
  return writer->GetErrorCode() == 0;
}
}

int main(int argc, char* argv[])
{
  std::map<std::string, std::string> options{ { "--points", "64" }, { "--record", "" },
    { "--replay", "" }, { "--picture", "" } };
  bool isUnderstood = argc >= 4 && argc % 2 == 0;
  for (int i = 4; isUnderstood && i < argc; i += 2)
  {
    isUnderstood = options.count(argv[i]) > 0;
    options[argv[i]] = argv[i + 1];
  }
  const int points = std::atoi(options["--points"].c_str());
  if (!isUnderstood || points < 2 || points > 1000)
  {
    std::cerr
      << "usage: InflowPainter FLOW VECTORS PAINT.png [--points 2...1000] [--record EVENTS] "
         "[--replay EVENTS] [--picture FILE.png]\n";
    return EXIT_FAILURE;
  }

  vtkSmartPointer<vtkAlgorithm> reader = MakeReader(argv[1]);
  reader->Update();
  vtkDataSet* field = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  if (!field)
  {
    std::cerr << argv[1] << " has no grid\n";
    return EXIT_FAILURE;
  }
  // The rectangle is placed where the flow comes in.
  vtkNew<vtkTerminationInflow> inflow;
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetInputConnection(reader->GetOutputPort());
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, argv[2]);
  filter->AddTerminationSurface(inflow);
  SetImage(filter, field, points);
  filter->Update();
  auto* flow = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
  if (flow->GetNumberOfPoints() == 0)
  {
    return EXIT_FAILURE;
  }
  // Errors are the mean, the one that 99 % do not exceed, and the largest.
  vtkInterlumeReport* report = filter->GetReport();
  std::cout << "Between voxels, u is off by " << report->GetNumber("SamplingErrorU")
            << " in the mean, v by " << report->GetNumber("SamplingErrorV")
            << "; 99 in 100 by less than " << report->GetNumber("SamplingErrorU", 1) << " and "
            << report->GetNumber("SamplingErrorV", 1) << "; borders go through "
            << report->GetNumber("SamplingSplitCells") << " of "
            << report->GetNumber("SamplingChecks") << " cells.\n";

  int size[2];
  GetPageSize(inflow, size);
  PainterWindow painter(flow, inflow, size[0], size[1]);
  painter.SetFile(argv[3]);
  if (std::ifstream(argv[3]))
  {
    painter.TakeKey('l');
  }
  painter.GetInteractor()->Initialize();
  painter.GetWindow()->Render();
  vtkNew<vtkInteractorEventRecorder> recorder;
  recorder->SetInteractor(painter.GetInteractor());
  if (!options["--replay"].empty())
  {
    recorder->SetFileName(options["--replay"].c_str());
    recorder->Play();
  }
  else
  {
    if (!options["--record"].empty())
    {
      recorder->SetFileName(options["--record"].c_str());
      recorder->On();
      recorder->Record();
    }
    painter.GetInteractor()->Start();
  }
  return options["--picture"].empty() || WritePicture(painter.GetWindow(), options["--picture"])
    ? EXIT_SUCCESS
    : EXIT_FAILURE;
}
