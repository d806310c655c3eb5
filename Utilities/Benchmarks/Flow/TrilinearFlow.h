// SPDX-License-Identifier: BSD-3-Clause
#ifndef TrilinearFlow_h
#define TrilinearFlow_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <array>

/**
 * The streamlines of the vectors of an image, interpolated trilinearly, good to some 1e-12: Boost's
 * method of Runge, Kutta and Fehlberg, order 7(8), in steps of a twentieth of a cell that end at
 * the faces of cells, so that no step meets a kink of the field.
 */
class TrilinearFlow
{
public:
  explicit TrilinearFlow(vtkImageData* image);

  /// 0 outside of the image.
  void GetVelocity(const double x[3], double v[3]) const;
  /// Moves \a x by so much time, backward for a negative one, but not out of the image.
  void Follow(double x[3], double time) const;

private:
  using Vector = std::array<double, 3>;
  struct Cell;

  /// In cells from the first point; and back.
  Vector ToLattice(const double x[3]) const;
  void ToWorld(const Vector& p, double x[3]) const;
  /// False where the image has no such cell.
  bool Load(Cell& cell) const;
  bool Locate(const Vector& p, Cell& cell) const;

  vtkSmartPointer<vtkImageData> Image;
};

#endif
