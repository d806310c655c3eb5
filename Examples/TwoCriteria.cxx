// SPDX-License-Identifier: BSD-3-Clause
// Extracts the region where one array is in [a, b] and another in [c, d], writes it, and prints its
// volume.
//
//   TwoCriteria disk_out_ref.vtu Temp 380 560 AsH3 0.1 0.14 both.vtu

#include "MakeReader.h"

#include <vtkDataObject.h>
#include <vtkIntervalVolume.h>
#include <vtkNew.h>
#include <vtkTetra.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{
double Volume(vtkUnstructuredGrid* tetrahedra)
{
  double volume = 0.0;
  double p[4][3];
  for (vtkIdType cell = 0; cell < tetrahedra->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    tetrahedra->GetCellPoints(cell, count, ids);
    for (int i = 0; i < 4; ++i)
    {
      tetrahedra->GetPoint(ids[i], p[i]);
    }
    volume += std::abs(vtkTetra::ComputeVolume(p[0], p[1], p[2], p[3]));
  }
  return volume;
}
}

int main(int argc, char* argv[])
{
  if (argc != 9)
  {
    std::cerr << "usage: TwoCriteria INPUT ARRAY LOWER UPPER ARRAY LOWER UPPER OUTPUT.vtu\n";
    return EXIT_FAILURE;
  }
  vtkSmartPointer<vtkAlgorithm> reader = MakeReader(argv[1]);

  vtkNew<vtkIntervalVolume> both;
  both->SetInputConnection(reader->GetOutputPort());
  both->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, argv[2]);
  both->SetNumberOfIntervals(1);
  both->SetInterval(0, std::atof(argv[3]), std::atof(argv[4]));
  both->AddCriterion(argv[5], std::atof(argv[6]), std::atof(argv[7]));
  both->Update();

  vtkUnstructuredGrid* tetrahedra = vtkUnstructuredGrid::SafeDownCast(both->GetOutputDataObject(0));
  if (!tetrahedra || tetrahedra->GetNumberOfCells() == 0)
  {
    std::cerr << "The two ranges have no common region.\n";
    return EXIT_FAILURE;
  }
  std::cout << tetrahedra->GetNumberOfCells() << " tetrahedra, volume " << Volume(tetrahedra)
            << "\n";

  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(tetrahedra);
  writer->SetFileName(argv[8]);
  return writer->Write() ? EXIT_SUCCESS : EXIT_FAILURE;
}
