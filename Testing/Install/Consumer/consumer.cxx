// Extracts an interval volume with the installed package: a shell of the wavelet has tetrahedra.
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkRTAnalyticSource.h"
#include "vtkUnstructuredGrid.h"

#include <cstdlib>
#include <iostream>

int main()
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  vtkNew<vtkIntervalVolume> interval;
  interval->SetInputConnection(wavelet->GetOutputPort());
  interval->SetNumberOfIntervals(1);
  interval->SetInterval(0, 140.0, 180.0);
  interval->Update();
  const vtkIdType tetrahedra = interval->GetOutput()->GetNumberOfCells();
  std::cout << tetrahedra << " tetrahedra\n";
  return tetrahedra > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
