// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellWalker_h
#define interlume_CellWalker_h

#include "Cells/FaceExtent.h"

#include "vtkType.h"

namespace interlume
{

/**
 * @class   CellWalker
 * @brief   the concept of a field that streamlines are followed in, and a base that does nothing
 *
 * A walker stands in one cell of the field and knows its own coordinates p there, in which position
 * and velocity are smooth, inside the cell and a little beyond. Each thread has its own (a copy);
 * the field and what is built of it are shared and constant. Kinds of field are classes with these
 * members, no virtual functions; Advection is a template over them:
 *
 * - `const Field& GetField() const`: what is shared, a FlowField: largest speed, bounds.
 * - `bool Locate(const double x[3], double p[3])`: stands in the cell that holds x, p its place
 * there, inside but for rounding; false outside of the field, the walker then stands nowhere. A
 * point on a face is in either cell, always in the same one.
 * - `vtkIdType GetCell() const`: the cell's id.
 * - `bool IsHere() const`: whether streamlines may go on in the cell; false where another process
 * has to follow them there.
 * - `bool IsFinite() const`: whether all vectors of the cell are finite.
 * - `void GetVelocity(const double p[3], double rate[3]) const`: dp/dt for dx/dt = v (the walker
 * knows no direction). Where dx/dp has no inverse, as on a collapsed edge, the coordinates that
 * make no difference stay.
 * - `void GetJacobian(const double p[3], double jacobian[9]) const`: of the above, d rate[i] / d
 * p[j] at [3 i + j].
 * - `void GetPosition(const double p[3], double x[3]) const`.
 * - `void GetWorldVector(const double p[3], const double d[3], double w[3]) const`: the change of x
 * for a change of p by d, to first order; of GetVelocity it gives v.
 * - `bool IsAffine() const`: whether the above is the same throughout the cell; else `double
 * GetLongestWorldVector(const double d[3]) const` is at least its length anywhere in the cell for
 * changes of p by -d to d, d >= 0.
 * - `void GetVelocityGradient(const double p[3], double gradient[9]) const`: dv[i]/dx[j] at [3 i +
 * j], for vorticity.
 * - `int GetNumberOfFaces() const`, at most 6, and `double GetFaceDistance(int face, const double
 * p[3]) const`: above 0 inside, 0 on the face, affine in p; scaled so that the cell's width is
 * about 1.
 * - `bool IsBox() const`: whether the cell is [0,1]^3 and the distances from faces 2 i and 2 i + 1
 * are p_i and 1 - p_i.
 * - `void Prefetch(int face, int round) const`: the cell is likely to be left by that face soon;
 * what Cross will read may be brought near. Called twice with some work between: what round 0
 * brings may tell round 1 what is next. Changes nothing.
 * - `bool Cross(int face, double p[3])`: p, on the face but for rounding, becomes the place in the
 * neighbour, where the walker then stands. What p is off the face is lost: the new p is on it, to
 * the last digit where the face is one of a coordinate (its distance is p_i or 1 - p_i). The place
 * along the face is kept. Returns false where there is no neighbour, or it is not part of the
 * field: the walker and p stay. Where p is on an edge or a corner the neighbour may be one that p
 * is outside of, or that the velocity leaves at once; crossing on leads to the right one. Folded
 * cells may send a streamline to and fro over a face without time passing: who walks limits the
 * crossings at one time.
 * - `bool HasNeighbor(int face) const`: whether Cross would find one. `FaceExtent
 * GetFaceExtent(int face) const`: the face in world units.
 * - `int GetDomainFace(int face) const`: 0 to 5 for a face on the outside of a structured grid, the
 * number of its patch for one of an unstructured grid, else -1; `void GetDomainParameters(int face,
 * const double p[3], double uv[2]) const` of it, in the order of the other two axes, held to 0
 * ... 1.
 * - `double Interpolate(int array, const double p[3]) const`: of a point array added to the field.
 *
 * `HasLanes` (static constexpr bool): whether there is a class LaneWalker that walks in several
 * cells at once (AdvectionLanes).
 *
 * FieldDispatch makes the walker of a dataset.
 */
struct CellWalker
{
  static constexpr bool HasLanes = false;

  static constexpr bool IsHere() { return true; }
  bool IsAffine() const { return true; }
  double GetLongestWorldVector(const double*) const { return 0.0; }
  bool IsBox() const { return false; }
  bool HasNeighbor(int) const { return true; }
  FaceExtent GetFaceExtent(int) const { return {}; }
  void Prefetch(int, int) const {}
};

}

#endif
