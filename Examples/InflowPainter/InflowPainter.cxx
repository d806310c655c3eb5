// SPDX-License-Identifier: BSD-3-Clause
// Lets the user paint on the inflow of a flow, and shows the paint advected through the volume. The
// painted image is saved as a PNG file. If the file exists, it is loaded first.
//
//   InflowPainter post.vts Velocity paint.png
//   InflowPainter post.vts Velocity paint.png --points 96 --record events.log
//   InflowPainter post.vts Velocity paint.png --replay events.log --picture painter.png
//
// In the left view, the left button paints; sliders and keys change the brush (see
// PainterWindow.h). In the right view, the left button rotates the camera.

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
/// Sets the sample dimensions: \a points along the longest edge of the field's bounding box, and
/// about the same spacing along the other edges.
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

/// Computes the width and height in pixels of an image with the aspect ratio of the plane.
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

bool WriteImage(vtkRenderWindow* window, const std::string& file)
{
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->SetFileName(file.c_str());
  writer->Write();
  return writer->GetErrorCode() == 0;
}
}

int main(int argc, char* argv[])
{
  std::map<std::string, std::string> options{ { "--points", "64" }, { "--record", "" },
    { "--replay", "" }, { "--picture", "" } };
  bool isValid = argc >= 4 && argc % 2 == 0;
  for (int i = 4; isValid && i < argc; i += 2)
  {
    isValid = options.count(argv[i]) > 0;
    options[argv[i]] = argv[i + 1];
  }
  const int points = std::atoi(options["--points"].c_str());
  if (!isValid || points < 2 || points > 1000)
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
    std::cerr << argv[1] << " does not contain a dataset.\n";
    return EXIT_FAILURE;
  }
  // This surface is placed automatically where the flow enters the field.
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
  // Each error in the report has three entries: mean, 99th percentile and maximum.
  vtkInterlumeReport* report = filter->GetReport();
  std::cout << "Interpolation between samples: the mean error is "
            << report->GetNumber("SamplingErrorU") << " in u and "
            << report->GetNumber("SamplingErrorV") << " in v, the 99th percentile "
            << report->GetNumber("SamplingErrorU", 1) << " and "
            << report->GetNumber("SamplingErrorV", 1) << ". Surface boundaries pass through "
            << report->GetNumber("SamplingSplitCells") << " of "
            << report->GetNumber("SamplingChecks") << " checked cells.\n";

  int size[2];
  GetPageSize(inflow, size);
  PainterWindow painter(flow, inflow, size[0], size[1]);
  painter.SetFile(argv[3]);
  if (std::ifstream(argv[3]))
  {
    painter.HandleKey('l');
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
  return options["--picture"].empty() || WriteImage(painter.GetWindow(), options["--picture"])
    ? EXIT_SUCCESS
    : EXIT_FAILURE;
}
