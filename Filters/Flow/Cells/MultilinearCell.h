// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MultilinearCell_h
#define interlume_MultilinearCell_h

#include "vtkType.h"

class vtkDataArray;
class vtkDataSet;
class vtkIdList;

namespace interlume
{

/**
 * @class   MultilinearCell
 * @brief   represents a cell and its vectors as trilinear functions on the unit cube
 *
 * VTK's interpolation of tetrahedra, voxels, hexahedra, wedges and pyramids is trilinear in the
 * parametric coordinates p. The values at the eight corners of the cube 0 <= p <= 1 define it;
 * corner i + 2 * j + 4 * k is at p = (i,j,k). A wedge is the subset of the cube with p0 + p1 <= 1,
 * and a tetrahedron the subset with p0 + p1 + p2 <= 1. Their values are extrapolated to the other
 * corners of the cube. In a pyramid, the apex is at all four corners with p2 = 1.
 */
class MultilinearCell
{
public:
  enum Shapes
  {
    BOX,
    WEDGE,
    PYRAMID,
    TETRAHEDRON,
    NONE
  };

  using Values = double[8][3];

  /// Returns the shape of a VTK cell type. Unsupported types have the shape NONE.
  static Shapes GetShape(int cellType);
  /// Returns true if cells of the type have no volume, such as triangles or empty cells.
  static bool IsFlat(int cellType);

  /// Interpolate computes the value at p. Derive computes its derivatives: derivatives[3 * i + j]
  /// is d value[i] / d p[j].
  static void Interpolate(const Values& values, const double p[3], double value[3]);
  static void Derive(const Values& values, const double p[3], double derivatives[9]);

  /// Returns the parametric distance by which p is outside the cell. It is negative inside.
  static double GetExcess(Shapes shape, const double p[3]);

  /// Returns the number of points of a cell. \a corners receives the cube corner of each point, in
  /// VTK's point order.
  static int GetCorners(Shapes shape, const int*& corners);
  /// Returns the number of edges of a cell. \a edges receives the edges as pairs of cube corners.
  static int GetEdges(Shapes shape, const int (*&edges)[2]);

  /// Loads the points and vectors of a cell. \a ids is scratch memory.
  void Load(vtkDataSet* data, vtkDataArray* vectors, vtkIdType cell, vtkIdList* ids);

  Shapes GetShape() const { return this->Shape; }
  vtkIdType GetCell() const { return this->Cell; }
  const Values& GetPositions() const { return this->Positions; }
  const Values& GetVectors() const { return this->Vectors; }
  int GetNumberOfPoints() const { return this->NumberOfPoints; }
  vtkIdType GetPointId(int i) const { return this->PointIds[i]; }

  /// Returns true if all positions and vectors are finite.
  bool IsFinite() const;

  /// Returns the largest speed at the points of the cell.
  double GetLargestSpeed() const;

  /// Computes the interpolation weights of the cell's points at p.
  void GetWeights(const double p[3], double weights[8]) const;

  /// Computes gradient[3 * i + j] = dv[i]/dx[j]. Returns false, with a zero gradient, if the cell
  /// is degenerate.
  bool GetGradient(const double p[3], double gradient[9]) const;

  /**
   * Returns the volume of the cell after multiplying its coordinates by \a scale. Scaling prevents
   * overflow for very large cells and underflow for very small cells.
   */
  double GetVolume(double scale = 1.0) const;

  /// Returns the cube root of the volume, avoiding overflow and underflow.
  double GetLength() const;

  /// Returns the length of the diagonal of the cell's bounds.
  double GetDiagonal() const;

  /// Returns a power of 2 that scales a length to about 1.
  static double GetScale(double length);

private:
  Shapes Shape = NONE;
  vtkIdType Cell = -1;
  int NumberOfPoints = 0;
  vtkIdType PointIds[8] = {};
  Values Positions = {};
  Values Vectors = {};
};

}

#endif
