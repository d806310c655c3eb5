// SPDX-License-Identifier: BSD-3-Clause
#ifndef TrilinearFlow_h
#define TrilinearFlow_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <array>

/**
 * Streamlines of the trilinearly interpolated vectors of an image, with an accuracy of about 1e-12.
 * Uses Boost's Runge-Kutta-Fehlberg 7(8) with steps of at most a twentieth of a cell. Steps end at
 * cell faces, so the field is smooth within each step.
 */
class TrilinearFlow
{
public:
  explicit TrilinearFlow(vtkImageData* image);

  /// Returns the interpolated velocity, or 0 outside the image.
  void GetVelocity(const double x[3], double v[3]) const;
  /// Moves \a x along its streamline for a positive or negative time, but not out of the image.
  void Follow(double x[3], double time) const;

private:
  using Vector = std::array<double, 3>;
  struct Cell;

  /// Convert between world coordinates and continuous point indices.
  Vector ToIndices(const double x[3]) const;
  void ToWorld(const Vector& p, double x[3]) const;
  /// Load() sets the velocities of \a cell from its indices; Locate() first sets the indices to
  /// those of the cell that contains \a p. Both return false if the image has no such cell.
  bool Load(Cell& cell) const;
  bool Locate(const Vector& p, Cell& cell) const;

  vtkSmartPointer<vtkImageData> Image;
};

#endif
