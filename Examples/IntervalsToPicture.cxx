// SPDX-License-Identifier: BSD-3-Clause
// Renders adjacent intervals of one array into a PNG file. The last interval is opaque, the others
// are translucent.
//
//   IntervalsToPicture hydrogen_orbital.vti probability_density orbital.png 0.04 0.12 0.3 1

#include "MakeReader.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataObject.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkIntervalVolume.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkThreshold.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc < 6)
  {
    std::cerr << "usage: IntervalsToPicture INPUT ARRAY IMAGE.png BOUND BOUND [BOUND ...]\n";
    return EXIT_FAILURE;
  }
  vtkSmartPointer<vtkAlgorithm> reader = MakeReader(argv[1]);
  const int count = argc - 5;

  vtkNew<vtkIntervalVolume> intervals;
  intervals->SetInputConnection(reader->GetOutputPort());
  intervals->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, argv[2]);
  intervals->SetNumberOfIntervals(count);
  for (int i = 0; i < count; ++i)
  {
    intervals->SetInterval(i, std::atof(argv[4 + i]), std::atof(argv[5 + i]));
  }

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.925, 0.929, 0.933);
  renderer->UseDepthPeelingOn();
  for (int i = 0; i < count; ++i)
  {
    // One mesh contains all intervals; the cell array IntervalId distinguishes them.
    vtkNew<vtkThreshold> one;
    one->SetInputConnection(intervals->GetOutputPort());
    one->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "IntervalId");
    one->SetThresholdFunction(vtkThreshold::THRESHOLD_BETWEEN);
    one->SetLowerThreshold(i);
    one->SetUpperThreshold(i);
    vtkNew<vtkDataSetSurfaceFilter> surface;
    surface->SetInputConnection(one->GetOutputPort());
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputConnection(surface->GetOutputPort());
    normals->SetFeatureAngle(50.0);

    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(normals->GetOutputPort());
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    const double fraction = count > 1 ? static_cast<double>(i) / (count - 1) : 1.0;
    actor->GetProperty()->SetColor(
      0.2 + 0.75 * fraction, 0.45 + 0.25 * fraction, 0.7 - 0.45 * fraction);
    actor->GetProperty()->SetOpacity(i == count - 1 ? 1.0 : 0.3);
    // Adjacent intervals share a surface. With back-face culling, each side of it is drawn once.
    actor->GetProperty()->BackfaceCullingOn();
    renderer->AddActor(actor);
  }

  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetMultiSamples(0);
  window->SetSize(900, 700);
  window->AddRenderer(renderer);
  renderer->GetActiveCamera()->SetPosition(1.0, -1.0, 0.6);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Zoom(1.5);
  window->Render();
  if (intervals->GetReport()->GetNumber("CellsWithOutput") == 0)
  {
    std::cerr << "No value of " << argv[2] << " is in these intervals.\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->SetFileName(argv[3]);
  writer->Write();
  return writer->GetErrorCode() ? EXIT_FAILURE : EXIT_SUCCESS;
}
