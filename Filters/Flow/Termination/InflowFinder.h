// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_InflowFinder_h
#define interlume_InflowFinder_h

class vtkDataArray;
class vtkDataSet;

namespace interlume
{

/**
 * @class   InflowFinder
 * @brief   finds the plane across an axis through which the flow enters a field
 *
 * A cell's flow through planes across an axis is its mean velocity along the axis times its volume
 * over its length there. Summed over the cells that a plane crosses, for the flow along the axis
 * and for that against it, the axis and the sense with the most flow through one of 32 slabs are
 * taken, and of their slabs the first along the flow with four tenths of that: where the flow
 * enters, and no less than a sizeable part of it. Blanked cells and those that are not finite do
 * not count. In a large field only 262,144 evenly spread cells are looked at.
 */
class InflowFinder
{
public:
  /// Finds the plane. Returns false where there is no flow. With \a isReversed the flow is that of
  /// the vectors' opposites.
  bool Find(vtkDataSet* field, vtkDataArray* vectors, bool isReversed);

  /// Returns the axis, as 0, 1 or 2.
  int GetAxis() const { return this->Axis; }
  /// Returns where the plane is along the axis.
  double GetPosition() const { return this->Position; }
  /**
   * Return the middle and half the width of the cells that the flow goes through there, along the
   * two axes after GetAxis().
   */
  const double* GetMiddle() const { return this->Middle; }
  const double* GetHalfWidth() const { return this->HalfWidth; }

private:
  int Axis = 0;
  double Position = 0.0;
  double Middle[2] = { 0.0, 0.0 };
  double HalfWidth[2] = { 0.0, 0.0 };
};

}

#endif
