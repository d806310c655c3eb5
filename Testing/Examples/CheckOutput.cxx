// SPDX-License-Identifier: BSD-3-Clause
// Checks the output files of the examples. A .vtu file must have tetrahedra whose point array is
// within a range, and a .png file must have more than one color.
//
//   CheckOutput FILE.vtu ARRAY LOWER UPPER [ARRAY LOWER UPPER]
//   CheckOutput FILE.png

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
bool HasTetrahedra(vtkUnstructuredGrid* grid)
{
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (grid->GetCellType(cell) != VTK_TETRA)
    {
      return false;
    }
  }
  return grid->GetNumberOfCells() > 0;
}

/// Returns true if the range of the array is within the bounds, up to the array's precision.
bool IsWithin(vtkUnstructuredGrid* grid, const char* name, double lower, double upper)
{
  vtkDataArray* array = grid->GetPointData()->GetArray(name);
  if (!array)
  {
    std::cerr << "there is no point array " << name << "\n";
    return false;
  }
  double range[2];
  array->GetRange(range);
  std::cout << name << " from " << range[0] << " to " << range[1] << "\n";
  const double slack = 1e-6 * (upper - lower);
  return range[0] >= lower - slack && range[1] <= upper + slack && range[1] > range[0];
}

bool CheckMesh(int argc, char* argv[])
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(argv[1]);
  reader->Update();
  bool isValid = HasTetrahedra(reader->GetOutput());
  for (int i = 2; i + 2 < argc; i += 3)
  {
    isValid =
      IsWithin(reader->GetOutput(), argv[i], std::atof(argv[i + 1]), std::atof(argv[i + 2])) &&
      isValid;
  }
  return isValid;
}

bool CheckImage(const char* path)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path);
  reader->Update();
  double range[2];
  reader->GetOutput()->GetScalarRange(range);
  return reader->GetOutput()->GetNumberOfPoints() > 1 && range[1] - range[0] > 100.0;
}
}

int main(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::cerr << "usage: CheckOutput FILE [ARRAY LOWER UPPER...]\n";
    return EXIT_FAILURE;
  }
  const std::string path = argv[1];
  const bool isImage = path.size() > 4 && path.compare(path.size() - 4, 4, ".png") == 0;
  const bool isValid = isImage ? CheckImage(argv[1]) : CheckMesh(argc, argv);
  if (!isValid)
  {
    std::cerr << path << " does not have the expected content\n";
  }
  return isValid ? EXIT_SUCCESS : EXIT_FAILURE;
}
