// SPDX-License-Identifier: BSD-3-Clause
// Tests the installed libraries: extracts an interval volume of a wavelet.
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkRTAnalyticSource.h"
#include "vtkUnstructuredGrid.h"

#include <iostream>

int main()
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  vtkNew<vtkIntervalVolume> volume;
  volume->SetInputConnection(wavelet->GetOutputPort());
  volume->SetInterval(0, 140.0, 180.0);
  volume->Update();
  const vtkIdType cells = volume->GetOutput()->GetNumberOfCells();
  std::cout << cells << " tetrahedra in C++\n";
  return cells > 0 ? 0 : 1;
}
