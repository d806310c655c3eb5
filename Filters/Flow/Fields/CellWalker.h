// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellWalker_h
#define interlume_CellWalker_h

#include "Cells/FaceExtent.h"

#include "vtkType.h"

namespace interlume
{

/**
 * @class   CellWalker
 * @brief   base class of walkers, which evaluate a field along streamlines
 *
 * A walker is in one cell of the field and stores local coordinates p. Position and velocity are
 * smooth functions of p inside the cell and slightly outside. Each thread has its own copy of the
 * walker; all copies share a constant field. Each type of field has a walker class with the
 * following members, some of which have defaults in this class. They are not virtual; Advection is
 * a template over the walker class.
 *
 * - `const Field& GetField() const`: the shared FlowField, with maximum speed and bounds.
 * - `bool Locate(const double x[3], double p[3])`: enters the cell that contains x and computes p,
 *   which is inside up to rounding error. Returns false if x is outside the field; the walker is
 *   then in no cell. A point on a face is always located in the same one of the two adjacent cells.
 * - `bool LocateNearby(const double x[3], double p[3])`: like Locate(), but faster if x is close to
 *   p in the current cell, which must exist. On a face, the cell depends on the current cell.
 * - `vtkIdType GetCell() const`: cell id.
 * - `bool IsHere() const`: false if another process must trace streamlines in the cell.
 * - `bool IsFinite() const`: whether all vectors of the cell are finite.
 * - `void GetVelocity(const double p[3], double rate[3]) const`: dp/dt for dx/dt = v. The direction
 *   of integration is not applied. If dx/dp is singular, for example on a collapsed edge,
 *   coordinates that have no effect on x do not change.
 * - `void GetJacobian(const double p[3], double jacobian[9]) const`: derivative of GetVelocity, d
 *   rate[i] / d p[j] at [3 * i + j].
 * - `void GetPosition(const double p[3], double x[3]) const`.
 * - `void GetWorldVector(const double p[3], const double d[3], double w[3]) const`: first-order
 *   change of x if p changes by d. For d from GetVelocity it returns v.
 * - `bool IsAffine() const`: whether GetWorldVector is independent of p. Otherwise, `double
 *   GetMaximumWorldLength(const double d[3]) const` returns an upper bound on the length of this
 *   vector in the cell if each p[i] changes by at most d[i].
 * - `void GetVelocityGradient(const double p[3], double gradient[9]) const`: dv[i]/dx[j] at [3 * i
 *   + j], for vorticity.
 * - `int GetNumberOfFaces() const`, at most 6, and `double GetFaceDistance(int face, const double
 *   p[3]) const`: positive inside, 0 on the face, affine in p, scaled to a cell width of about 1.
 * - `bool IsBox() const`: whether the cell is [0,1]^3 and the distances to faces 2 * i and 2 * i +
 *   1 are p_i and 1 - p_i.
 * - `void Prefetch(int face, int round) const`: prefetches the data that Cross() reads for a face
 *   that the streamline is likely to cross soon. It is called for round 0 and, after some other
 *   work, for round 1, because the data of round 0 may contain the addresses for round 1.
 * - `bool Cross(int face, double p[3])`: enters the neighbor. p, which is on the face up to
 *   rounding error, becomes the local position in the neighbor. The new p is on the face (without
 *   rounding error if IsBox()), and the position along the face is preserved. Returns false and
 *   changes nothing if there is no neighbor or the neighbor is not part of the field. If p is on an
 *   edge or a corner, p may be outside the neighbor, or the velocity may point out of the neighbor;
 *   further crossings lead to the right cell. Folded cells can cause endless crossings without
 *   progress in time. Therefore callers limit the number of crossings at a given time.
 * - `bool HasNeighbor(int face) const`: whether Cross() would succeed. `FaceExtent
 *   GetFaceExtent(int face) const`: extent of a face in world units.
 * - `int GetDomainFace(int face) const`: 0 to 5 for an outer face of a structured grid, the patch
 *   index for a boundary face of an unstructured grid, otherwise -1. `void GetDomainParameters(int
 *   face, const double p[3], double uv[2]) const`: parameters of p on the domain face, in [0,1], in
 *   the order of the two axes along the face.
 * - `double Interpolate(int array, const double p[3]) const`: value of a point array added to the
 *   field.
 *
 * `HasSimdWalker` (static constexpr bool) is true if the class has a template SimdWalker, which
 * walks in several cells at once with SIMD instructions (SimdAdvection).
 *
 * FieldDispatch creates the walker of a dataset.
 */
struct CellWalker
{
  static constexpr bool HasSimdWalker = false;

  static constexpr bool IsHere() { return true; }
  bool IsAffine() const { return true; }
  double GetMaximumWorldLength(const double*) const { return 0.0; }
  bool IsBox() const { return false; }
  bool HasNeighbor(int) const { return true; }
  FaceExtent GetFaceExtent(int) const { return {}; }
  void Prefetch(int, int) const {}
};

}

#endif
