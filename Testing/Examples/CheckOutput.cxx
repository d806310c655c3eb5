// SPDX-License-Identifier: BSD-3-Clause
// For the tests of the examples: whether a file they wrote holds what it should. A .vtu has
// tetrahedra whose point array lies in a range; a .png is not of one colour.
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

/// Interpolated values are rounded to the array's precision.
bool LiesWithin(vtkUnstructuredGrid* grid, const char* name, double lower, double upper)
{
  vtkDataArray* array = grid->GetPointData()->GetArray(name);
  if (!array)
  {
    std::cerr << "no array " << name << "\n";
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
  bool good = HasTetrahedra(reader->GetOutput());
  for (int i = 2; i + 2 < argc; i += 3)
  {
    good =
      LiesWithin(reader->GetOutput(), argv[i], std::atof(argv[i + 1]), std::atof(argv[i + 2])) &&
      good;
  }
  return good;
}

bool CheckPicture(const char* path)
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
    std::cerr << "the first argument is a file\n";
    return EXIT_FAILURE;
  }
  const std::string path = argv[1];
  const bool picture = path.size() > 4 && path.compare(path.size() - 4, 4, ".png") == 0;
  const bool good = picture ? CheckPicture(argv[1]) : CheckMesh(argc, argv);
  if (!good)
  {
    std::cerr << path << " does not hold what it should\n";
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
