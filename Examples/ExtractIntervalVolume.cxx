// SPDX-License-Identifier: BSD-3-Clause
// Extracts the region where a point array is between two values, and writes it as tetrahedra.
//
//   ExtractIntervalVolume bluntfin.vts Density 1.2 5 dense.vtu

#include "MakeReader.h"

#include <vtkDataObject.h>
#include <vtkIntervalVolume.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 6)
  {
    std::cerr << "usage: ExtractIntervalVolume INPUT ARRAY LOWER UPPER OUTPUT.vtu\n";
    return EXIT_FAILURE;
  }
  vtkSmartPointer<vtkAlgorithm> reader = MakeReader(argv[1]);

  vtkNew<vtkIntervalVolume> interval;
  interval->SetInputConnection(reader->GetOutputPort());
  interval->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, argv[2]);
  interval->SetNumberOfIntervals(1);
  interval->SetInterval(0, std::atof(argv[3]), std::atof(argv[4]));
  interval->Update();

  vtkUnstructuredGrid* tetrahedra =
    vtkUnstructuredGrid::SafeDownCast(interval->GetOutputDataObject(0));
  if (!tetrahedra || tetrahedra->GetNumberOfCells() == 0)
  {
    std::cerr << "No value of " << argv[2] << " is in this interval.\n";
    return EXIT_FAILURE;
  }
  const vtkIdType cells = interval->GetReport()->GetNumber("Cells");
  const vtkIdType cut = interval->GetReport()->GetNumber("CellsWithOutput");
  std::cout << tetrahedra->GetNumberOfCells() << " tetrahedra from " << cut << " of " << cells
            << " cells\n";

  // Write the data inline: with the libexpat of Debian 12, ParaView 5.11 cannot read appended data.
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetDataModeToBinary();
  writer->SetInputData(tetrahedra);
  writer->SetFileName(argv[5]);
  return writer->Write() ? EXIT_SUCCESS : EXIT_FAILURE;
}
