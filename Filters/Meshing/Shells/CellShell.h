// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellShell_h
#define interlume_CellShell_h

#include "Common/Error.h"

#include "vtkType.h"

#include <array>
#include <vector>

class vtkDataSet;
class vtkGenericCell;

namespace interlume
{

class FaceTriangulation;

/**
 * @class   CellShell
 * @brief   the triangles around one cell of three dimensions
 *
 * Two equal triangles of a collapsed cell cancel. The others are closed, each edge belongs to two
 * of them, and they are oriented so that the volume within is positive.
 */
class CellShell
{
public:
  struct Triangle
  {
    std::array<int, 3> Points; ///< indices into PointIds
    int Face;                  ///< the face of the cell it is a part of
  };

  /// Returns whether cells of a type are taken: linear and of three dimensions.
  static bool IsSupported(int type);

  /// Takes a cell, or returns an error. A cell that collapses entirely has no triangles and no
  /// error.
  Error Take(vtkDataSet* input, vtkIdType cell, const FaceTriangulation& triangulation);

  std::vector<vtkIdType> PointIds; ///< ascending in the grid's order of points
  std::vector<double> Points;      ///< three a point
  std::vector<Triangle> Triangles;
  double Volume = 0.0;

  const double* GetPoint(int i) const { return &this->Points[3 * i]; }

private:
  Error Orient();
  double MeasureVolume() const;
};

}

#endif
