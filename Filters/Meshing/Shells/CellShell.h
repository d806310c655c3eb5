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
 * @brief   boundary triangles of one three-dimensional cell
 *
 * Coincident triangles of a collapsed cell are removed. The remaining triangles form a closed
 * surface: each edge belongs to two of them. They are oriented so that the enclosed volume is
 * positive.
 */
class CellShell
{
public:
  struct Triangle
  {
    std::array<int, 3> Points; ///< indices into PointIds
    int Face;                  ///< face of the cell that contains the triangle
  };

  /// Returns whether a cell type is supported: linear and three-dimensional.
  static bool IsSupported(int type);

  /// Reads a cell or returns an error. A cell that collapses entirely has no triangles and no
  /// error. Each point p becomes merged[p], unless \a merged is empty.
  Error Take(vtkDataSet* input, vtkIdType cell, const FaceTriangulation& triangulation,
    const std::vector<vtkIdType>& merged);

  std::vector<vtkIdType> PointIds; ///< in the order of FaceTriangulation
  std::vector<double> Points;      ///< three per point
  std::vector<Triangle> Triangles;
  double Volume = 0.0;
  /// Number of faces that intersect themselves, have no area or have merged points.
  int NumberOfFoldedFaces = 0;

  const double* GetPoint(int i) const { return &this->Points[3 * i]; }

private:
  Error Orient();
  double MeasureVolume() const;
};

}

#endif
