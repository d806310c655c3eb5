// SPDX-License-Identifier: BSD-3-Clause
// Uses the installed package to extract an interval of the wavelet and to mesh a sphere, which
// needs the installed TetGen program.
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkRTAnalyticSource.h"
#include "vtkUnstructuredGrid.h"
#ifdef WITH_MESHING
#include "vtkSphereSource.h"
#include "vtkTetrahedralMesher.h"
#endif

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
#ifdef WITH_MESHING
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputConnection(sphere->GetOutputPort());
  mesher->Update();
  const vtkIdType meshed = mesher->GetOutput()->GetNumberOfCells();
  std::cout << meshed << " tetrahedra in the sphere\n";
  if (meshed == 0)
  {
    return EXIT_FAILURE;
  }
#endif
  return tetrahedra > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
