// SPDX-License-Identifier: BSD-3-Clause
// Checks the output files of the examples. A .vtu file must have tetrahedra whose point array is
// within a range, and a .png file must have more than one color. With a second .png file of the
// same shape and any size, both must agree in the mean colors of a grid of blocks.
//
//   CheckOutput FILE.vtu ARRAY LOWER UPPER [ARRAY LOWER UPPER]
//   CheckOutput FILE.png [EXPECTED.png]

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkImageShrink3D.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cmath>
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

/// Returns true if the array's values are not constant and are within the bounds, up to rounding
/// errors.
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

/// Number of blocks along the width and the height of an image.
constexpr int COLUMNS = 30;
constexpr int ROWS = 20;

/// Maximum difference between mean colors of corresponding blocks, with colors in [0, 255].
constexpr double MAXIMUM_DIFFERENCE = 12.0;

/// Returns the mean colors of the blocks, or null if the image size is not a multiple of the number
/// of blocks.
vtkSmartPointer<vtkImageData> MeanOfBlocks(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  if (size[0] % COLUMNS != 0 || size[1] % ROWS != 0)
  {
    return nullptr;
  }
  vtkNew<vtkImageShrink3D> mean;
  mean->SetInputData(image);
  mean->SetShrinkFactors(size[0] / COLUMNS, size[1] / ROWS, 1);
  mean->MeanOn();
  mean->Update();
  return mean->GetOutput();
}

bool Agrees(vtkImageData* image, const char* path)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path);
  reader->Update();
  const vtkSmartPointer<vtkImageData> actual = MeanOfBlocks(image);
  const vtkSmartPointer<vtkImageData> expected = MeanOfBlocks(reader->GetOutput());
  const int components = image->GetNumberOfScalarComponents();
  if (!actual || !expected || expected->GetNumberOfScalarComponents() != components)
  {
    std::cerr << path << " has another size or other components\n";
    return false;
  }
  double largest = 0.0;
  for (int i = 0; i < COLUMNS * ROWS * components; ++i)
  {
    const int at[3] = { i / components % COLUMNS, i / components / COLUMNS, i % components };
    largest = std::max(largest,
      std::abs(actual->GetScalarComponentAsDouble(at[0], at[1], 0, at[2]) -
        expected->GetScalarComponentAsDouble(at[0], at[1], 0, at[2])));
  }
  std::cout << "blocks differ from " << path << " by up to " << largest << " of 255\n";
  return largest <= MAXIMUM_DIFFERENCE;
}

bool CheckImage(const char* path, const char* expected)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path);
  reader->Update();
  double range[2];
  reader->GetOutput()->GetScalarRange(range);
  return reader->GetOutput()->GetNumberOfPoints() > 1 && range[1] - range[0] > 100.0 &&
    (!expected || Agrees(reader->GetOutput(), expected));
}
}

int main(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::cerr << "usage: CheckOutput FILE [EXPECTED.png | ARRAY LOWER UPPER...]\n";
    return EXIT_FAILURE;
  }
  const std::string path = argv[1];
  const bool isImage = path.size() > 4 && path.compare(path.size() - 4, 4, ".png") == 0;
  const bool isValid = isImage ? CheckImage(argv[1], argv[2]) : CheckMesh(argc, argv);
  if (!isValid)
  {
    std::cerr << path << " does not have the expected content\n";
  }
  return isValid ? EXIT_SUCCESS : EXIT_FAILURE;
}
