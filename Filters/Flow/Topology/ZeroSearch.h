// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ZeroSearch_h
#define interlume_ZeroSearch_h

#include "Cells/MultilinearCell.h"
#include "Numerics/SpeedScale.h"

#include "vtkType.h"

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkDataSet;

namespace interlume
{

/**
 * @class   ZeroSearch
 * @brief   zeros of functions of the interpolated vectors of a dataset, each once
 *
 * In each cell one or several systems of three equations, trilinear in the cell's parameters, are
 * solved. Cells that are blanked, hidden or ghosts are left out, those that are not finite, those
 * with fill values (SpeedScale), and those in which zeros are not isolated. So are zeros at points
 * that a cell of the latter kind has and in which its system is 0: they are part of a line or a
 * surface. A zero that several cells find at one place is that of the cell with the least id.
 */
class ZeroSearch
{
public:
  /// The systems of equations that are solved.
  class Systems
  {
  public:
    virtual ~Systems() = default;
    /// Computes the numbers of a cell's systems: first ... last - 1.
    virtual void GetRange(const MultilinearCell& cell, int& first, int& last) const = 0;
    /// Computes the values of a system at the corners of the cell's cube.
    virtual void Evaluate(
      const MultilinearCell& cell, int system, MultilinearCell::Values& values) const = 0;
  };

  struct Zero
  {
    vtkIdType Cell;
    int System;
    double Position[3];
    /// The interpolated vector at the zero.
    double Velocity[3];
    /// The derivatives dv[i]/dx[j] at [3 i + j]; 0 where the cell is flat.
    double Gradient[9];
    /// The cube root of the cell's volume.
    double CellLength;
    /// Whether the system's Jacobian is singular, or the cell is flat.
    bool IsDegenerate;
    /// The uncertainty of the position, in units of length.
    double Tolerance;
    /// Whether other cells may find the zero too, and the cell's points there by descending weight,
    /// -1 for none.
    bool IsShared;
    vtkIdType Points[8];
    /// The point that the zero is at, or -1.
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
   * Finds the zeros by system and cell, the same for any number of threads. The progress of \a
   * owner goes from 0 to 1. Returns false when its execution was aborted.
   */
  bool Execute(
    vtkAlgorithm* owner, vtkDataSet* data, vtkDataArray* vectors, const Systems& systems);

  const std::vector<Zero>& GetZeros() const { return this->Zeros; }
  const Counts& GetCounts() const { return this->Total; }
  ///@{
  /**
   * Returns a warning if cells with fill values, or with vectors that are not finite, were skipped,
   * otherwise an empty string. \a array is the name of the vectors.
   */
  std::string DescribeFillValues(const char* array) const;
  std::string DescribeNonFinite(const char* array) const;
  ///@}

private:
  class Worker;

  void Merge(const std::vector<unsigned char>& marks);

  std::vector<Zero> Zeros;
  Counts Total;
  FillValues Fill;
  vtkIdType NonFinitePoints = 0;
};

}

#endif
