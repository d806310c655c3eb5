// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ZeroSearch_h
#define interlume_ZeroSearch_h

#include "Cells/MultilinearCell.h"
#include "Numerics/SpeedScale.h"

#include "vtkType.h"

#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkDataSet;

namespace interlume
{

/**
 * @class   ZeroSearch
 * @brief   finds the zeros of functions of a dataset's interpolated vectors, without duplicates
 *
 * Solves one or several systems of three equations in each cell. The equations are trilinear in the
 * parametric coordinates of the cell. These cells are skipped: blanked, hidden and ghost cells,
 * cells with non-finite vectors or with fill values (SpeedScale), and cells with zeros that are not
 * isolated. A zero at a point of a cell with non-isolated zeros is skipped too if that cell's
 * system is 0 at the point, because such a zero belongs to a line or a surface of zeros. If several
 * cells find the same zero, the cell with the smallest id keeps it.
 */
class ZeroSearch
{
public:
  /// Systems of equations to solve.
  class Systems
  {
  public:
    virtual ~Systems() = default;
    /// Computes the range of system indices for a cell: \a first to \a last - 1.
    virtual void GetRange(const MultilinearCell& cell, int& first, int& last) const = 0;
    /// Computes the values of a system at the corners of the cell's parameter cube.
    virtual void Evaluate(
      const MultilinearCell& cell, int system, MultilinearCell::Values& values) const = 0;
  };

  struct Zero
  {
    vtkIdType Cell;
    int System;
    double Position[3];
    /// Interpolated vector at the zero.
    double Velocity[3];
    /// Derivatives dv[i]/dx[j] at [3 * i + j]; 0 if the cell is degenerate.
    double Gradient[9];
    /// Cube root of the cell's volume.
    double CellLength;
    /// True if the Jacobian of the system is singular or the cell is degenerate.
    bool IsDegenerate;
    /// Uncertainty of the position, in world units.
    double Tolerance;
    /// True if other cells may find the same zero. Points lists the cell's points with the largest
    /// interpolation weights at the zero, in descending order, followed by -1.
    bool IsShared;
    vtkIdType Points[8];
    /// Id of the point at the position of the zero, or -1.
    vtkIdType AtPoint;
  };

  struct Counts
  {
    vtkIdType ZeroCells = 0;
    vtkIdType DegenerateCells = 0;
    vtkIdType NonFiniteCells = 0;
    vtkIdType FillValueCells = 0;
  };

  /**
   * Finds the zeros, sorted by system and cell; the result does not depend on the number of
   * threads. The progress of \a owner advances from 0 to 1, and it warns about skipped cells.
   * Returns false if the execution was aborted.
   */
  bool Execute(
    vtkAlgorithm* owner, vtkDataSet* data, vtkDataArray* vectors, const Systems& systems);

  const std::vector<Zero>& GetZeros() const { return this->Zeros; }
  const Counts& GetCounts() const { return this->Total; }

private:
  class Worker;

  void Merge(const std::vector<unsigned char>& marks);
  void Warn(vtkAlgorithm* owner, const char* array) const;

  std::vector<Zero> Zeros;
  Counts Total;
  FillValues Fill;
  vtkIdType NonFinitePoints = 0;
};

}

#endif
