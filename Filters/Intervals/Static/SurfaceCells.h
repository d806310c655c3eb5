// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SurfaceCells_h
#define interlume_SurfaceCells_h

#include "Pass/ExtractionIndex.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataSet;
class vtkUnstructuredGrid;

namespace interlume
{

/**
 * @class   SurfaceCells
 * @brief   converts the two-dimensional cells of a dataset to cells with isotables
 *
 * A convex quadrilateral becomes a VTK_PIXEL, and a strip becomes triangles. Concave quadrilaterals
 * and other polygons are triangulated by vtkPolygon. Higher-order cells are replaced by the
 * polygons of their corners. All cells keep their orientation.
 *
 * If VTK cannot triangulate a polygon, for example because it intersects itself, it is split into a
 * fan and counted as folded. The signed areas of the fan still add up to the area of the polygon.
 */
class SurfaceCells
{
public:
  /// The dimensions of the cells of a dataset.
  struct Dimensions
  {
    /// If true, there are cells that are not lower-dimensional.
    bool HasSolids = false;
    bool HasSurfaces = false;
  };

  static Dimensions FindDimensions(vtkDataSet* input);

  /// Returns whether \a input is not an unstructured grid that consists of triangles.
  static bool IsNeeded(vtkDataSet* input);

  /// Fills \a surface with the two-dimensional cells of \a input. They have the points and the
  /// point arrays of the input, and inherit the ghost flags of its cells.
  static void Convert(vtkDataSet* input, ExtractionIndex::LinearGrid& surface);

  using Grids = std::vector<vtkSmartPointer<vtkUnstructuredGrid>>;

  /// Appends the cells of grids to \a output, with their points. Keeps the field data of \a output.
  /// Grids without points may lack arrays.
  static void Append(const Grids& parts, vtkUnstructuredGrid* output);

  /// Appends \a parts to \a output, and their boundaries to \a boundary. Each boundary has the
  /// points of its part. Grids that are appended must have the same arrays.
  static void Append(const Grids& parts, const Grids& boundaries, vtkUnstructuredGrid* output,
    vtkUnstructuredGrid* boundary);
};

}

#endif
