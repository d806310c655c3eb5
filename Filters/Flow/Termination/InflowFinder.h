// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_InflowFinder_h
#define interlume_InflowFinder_h

class vtkDataArray;
class vtkDataSet;

namespace interlume
{

/**
 * @class   InflowFinder
 * @brief   finds the axis-aligned plane where the flow enters a field
 *
 * The flow of a cell along an axis is its mean velocity along the axis times its volume, divided by
 * its extent along the axis. Flows along and against each axis are summed over slabs. The axis and
 * direction with the largest flow through a slab are chosen. The plane is at the center of the
 * first slab, in flow direction, with at least MinimumFraction of that flow or, if that slab is not
 * at the boundary of the field, of the slab with the largest flow. Blanked and non-finite
 * cells are ignored. In a large field, only an evenly distributed subset of the cells is used.
 */
class InflowFinder
{
public:
  /// Finds the plane. Returns false if there is no flow. If \a isReversed is true, the vectors are
  /// negated.
  bool Find(vtkDataSet* field, vtkDataArray* vectors, bool isReversed);

  /// Returns the axis: 0, 1 or 2.
  int GetAxis() const { return this->Axis; }
  /// Returns the position of the plane along the axis.
  double GetPosition() const { return this->Position; }
  /**
   * Return the center and the half-widths of the inflow region: the bounding rectangle of the cells
   * with flow through the plane. The two elements are for the axes after GetAxis() in cyclic order.
   */
  const double* GetCenter() const { return this->Center; }
  const double* GetHalfWidth() const { return this->HalfWidth; }

private:
  int Axis = 0;
  double Position = 0.0;
  double Center[2] = { 0.0, 0.0 };
  double HalfWidth[2] = { 0.0, 0.0 };
};

}

#endif
