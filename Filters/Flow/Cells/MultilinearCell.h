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
 * @brief   a cell and its vectors as trilinear functions on the unit cube
 *
 * The interpolation of VTK's tetrahedra, voxels, hexahedra, wedges and pyramids is trilinear in the
 * cell's parameters p: each is given by values at the eight corners of the cube 0 <= p <= 1, corner
 * i + 2 j + 4 k at p = (i,j,k). Wedges and tetrahedra are the part of the cube with p0 + p1 <= 1 or
 * p0 + p1 + p2 <= 1, with values extrapolated to the other corners; of a pyramid the four corners
 * of p2 = 1 are the apex.
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

  /// Returns the shape of a type of cell, NONE for other types.
  static Shapes GetShape(int cellType);
  /// Returns whether cells of the type have no volume, as triangles, or are no cells.
  static bool IsFlat(int cellType);

  /// Compute the values at p, and their derivatives, d value[i] / d p[j] at [3 i + j].
  static void Interpolate(const Values& values, const double p[3], double value[3]);
  static void Derive(const Values& values, const double p[3], double derivatives[9]);

  /// Returns by how much p is outside of the cell, in parameters; below 0 inside.
  static double GetExcess(Shapes shape, const double p[3]);

  /// Gives the corners of the cube that are points of a cell, in VTK's order; returns their number.
  static int GetCorners(Shapes shape, const int*& corners);
  /// Gives the edges of the cell as pairs of corners of the cube; returns their number.
  static int GetEdges(Shapes shape, const int (*&edges)[2]);

  /// Loads a cell; \a ids is room to work in.
  void Load(vtkDataSet* data, vtkDataArray* vectors, vtkIdType cell, vtkIdList* ids);

  Shapes GetShape() const { return this->Shape; }
  vtkIdType GetCell() const { return this->Cell; }
  const Values& GetPositions() const { return this->Positions; }
  const Values& GetVectors() const { return this->Vectors; }
  int GetNumberOfPoints() const { return this->NumberOfPoints; }
  vtkIdType GetPointId(int i) const { return this->PointIds[i]; }

  /// Returns whether positions and vectors are finite.
  bool IsFinite() const;

  /// Returns the largest speed at a point of the cell.
  double GetLargestSpeed() const;

  /// Computes the weights of the points at p.
  void GetWeights(const double p[3], double weights[8]) const;

  /// Computes dv[i]/dx[j] at [3 i + j]. Returns false, and gives 0, where the cell is flat.
  bool GetGradient(const double p[3], double gradient[9]) const;

  /**
   * Returns the volume of the cell enlarged by \a scale, by which the volumes of very large and
   * very small cells are numbers.
   */
  double GetVolume(double scale = 1.0) const;

  /// Returns the cube root of the volume, of cells of any size.
  double GetLength() const;

  /// Returns the length of the diagonal of the cell's bounds.
  double GetDiagonal() const;

  /// Returns a power of 2 by which a length becomes about 1.
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
