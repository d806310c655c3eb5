// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceLattice_h
#define ReferenceLattice_h

#include "vtkSmartPointer.h" // for the data sets

#include <array>  // for the dimensions
#include <string> // for names
#include <vector> // for DataSetVariant

class vtkDataSet;
class vtkImageData;

namespace reference
{

/// Returns an image with \a cells cells along each axis. Its origin and spacing have no exact
/// binary representation.
vtkSmartPointer<vtkImageData> MakeImage(const std::array<int, 3>& cells);

struct DataSetVariant
{
  std::string Name;
  vtkSmartPointer<vtkDataSet> Data;
};

/// Returns the image and its conversions to a structured grid, a rectilinear grid (if the image is
/// not rotated), unstructured hexahedra and unstructured voxels. All have the same points, cells
/// and arrays in the same order.
std::vector<DataSetVariant> FormsOf(vtkImageData* image);

}

#endif
