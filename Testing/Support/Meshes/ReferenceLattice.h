// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceLattice_h
#define ReferenceLattice_h

#include "vtkSmartPointer.h" // for the data sets

#include <array>  // for the dimensions
#include <string> // for names
#include <vector> // for the forms

class vtkDataSet;
class vtkImageData;

namespace reference
{

/// An image of \a cells cells with an origin and three spacings that are not round numbers.
vtkSmartPointer<vtkImageData> MakeImage(const std::array<int, 3>& cells);

struct LatticeForm
{
  std::string Name;
  vtkSmartPointer<vtkDataSet> Data;
};

/// The image, and the same points and cells in the same order as structured grid, as rectilinear
/// grid where the image is not turned, as unstructured hexahedra and as unstructured voxels, with
/// the image's point and cell arrays.
std::vector<LatticeForm> FormsOf(vtkImageData* image);

}

#endif
