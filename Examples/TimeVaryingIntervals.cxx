// SPDX-License-Identifier: BSD-3-Clause
// Extracts where, and for how long, an array of an Exodus file is between two values, over all time
// steps of the file. Writes the tetrahedra with their time extents, and renders them colored by
// time.
//
//   TimeVaryingIntervals mug.ex2 diffused 0.3 0.5 spread.vtu spread.png

#include <vtkAppendFilter.h>
#include <vtkCamera.h>
#include <vtkCompositeDataIterator.h>
#include <vtkDataObject.h>
#include <vtkExodusIIReader.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTemporalColorTransferFunction.h>
#include <vtkTimeVaryingIntervalVolume.h>
#include <vtkTimeWeightedTetrahedraMapper.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <vtkWindowToImageFilter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cstdlib>
#include <iostream>
#include <vector>

namespace
{
/// Merges the blocks of a multiblock dataset into one grid.
vtkSmartPointer<vtkUnstructuredGrid> Append(vtkDataObject* output)
{
  vtkNew<vtkAppendFilter> append;
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(output);
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    append->AddInputData(iterator->GetCurrentDataObject());
  }
  append->Update();
  return append->GetOutput();
}

/// Returns a volume colored by time, with the optical depth \a extinction per unit of length and
/// time.
vtkSmartPointer<vtkVolume> MakeVolume(
  vtkUnstructuredGrid* tetrahedra, const std::vector<double>& times, double extinction)
{
  vtkNew<vtkTemporalColorTransferFunction> colors;
  colors->SetTimes(static_cast<int>(times.size()), times.data());
  vtkNew<vtkPiecewiseFunction> constant;
  constant->AddPoint(times.front(), extinction);
  vtkNew<vtkTimeWeightedTetrahedraMapper> mapper;
  mapper->SetInputData(tetrahedra);
  mapper->SetScalarMode(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  mapper->SelectScalarArray("Time");
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colors);
  volume->GetProperty()->SetScalarOpacity(constant);
  volume->GetProperty()->SetScalarOpacityUnitDistance(1.0);
  return volume;
}

bool Draw(vtkVolume* volume, const char* path)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.065, 0.072, 0.085);
  renderer->AddVolume(volume);
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetMultiSamples(0);
  window->SetSize(900, 700);
  window->AddRenderer(renderer);
  renderer->GetActiveCamera()->SetPosition(0.3, -1.0, 0.45);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Zoom(1.35);
  window->Render();

  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->SetFileName(path);
  writer->Write();
  return writer->GetErrorCode() == 0;
}
}

int main(int argc, char* argv[])
{
  if (argc != 7)
  {
    std::cerr << "usage: TimeVaryingIntervals INPUT.ex2 ARRAY LOWER UPPER OUTPUT.vtu IMAGE.png\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkExodusIIReader> reader;
  reader->SetFileName(argv[1]);
  reader->UpdateInformation();
  reader->SetPointResultArrayStatus(argv[2], 1);
  vtkInformation* information = reader->GetOutputInformation(0);
  const int steps = information->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  const double* times = information->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  const std::vector<double> allTimes(times, times + steps);

  vtkNew<vtkTimeVaryingIntervalVolume> interval;
  interval->SetInputConnection(reader->GetOutputPort());
  interval->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, argv[2]);
  interval->SetNumberOfIntervals(1);
  interval->SetInterval(0, std::atof(argv[3]), std::atof(argv[4]));
  interval->Update();
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = Append(interval->GetOutputDataObject(0));
  if (tetrahedra->GetNumberOfCells() == 0)
  {
    std::cerr << "No value of " << argv[2] << " is in this interval at any time.\n";
    return EXIT_FAILURE;
  }
  const vtkIdType simplices = interval->GetReport()->GetNumber("Simplices");
  std::cout << tetrahedra->GetNumberOfCells() << " tetrahedra of " << simplices
            << " 4-simplices between " << interval->GetReport()->GetNumber("TimeSteps")
            << " steps\n";

  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(tetrahedra);
  writer->SetFileName(argv[5]);
  // With this extinction, a view ray along the diagonal has an optical depth of 80 if the interval
  // contains all values at all times.
  const double extinction = 80.0 / (tetrahedra->GetLength() * (allTimes.back() - allTimes.front()));
  const bool isDrawn = Draw(MakeVolume(tetrahedra, allTimes, extinction), argv[6]);
  return writer->Write() && isDrawn ? EXIT_SUCCESS : EXIT_FAILURE;
}
