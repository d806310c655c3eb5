// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_GridSample_h
#define interlume_GridSample_h

#include "Mesh/TetrahedraArrays.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkUnstructuredGrid.h"

namespace interlume
{

/**
 * @class   GridSample
 * @brief   selects every n-th cell of a grid, for a first image before the mesh is built
 *
 * Each cell of the sample has its own points. The cells are distributed evenly over the cell ids,
 * at positions from a hash, so regular numberings cause no patterns.
 */
class GridSample
{
public:
  /// Number of cells of a sample.
  static constexpr vtkIdType SIZE = 100000;

  /// Selects cells of \a grid if the grid or an array has changed.
  void Update(vtkUnstructuredGrid* grid, const TetrahedraArrays& arrays);

  /// Returns the sample, or null if none was selected.
  vtkUnstructuredGrid* GetGrid() const { return this->Grid; }
  /// Returns the arrays of the sample.
  const TetrahedraArrays& GetArrays() const { return this->Arrays; }
  /// Returns the number of cells of the grid per cell of the sample.
  int GetStride() const { return this->Stride; }

private:
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  TetrahedraArrays Arrays;
  int Stride = 1;
  /// The input of the last update.
  vtkUnstructuredGrid* Input = nullptr;
  vtkMTimeType InputTime = 0;
  TetrahedraArrays InputArrays;
};

}

#endif
