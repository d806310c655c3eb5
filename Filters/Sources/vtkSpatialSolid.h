// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSpatialSolid_h
#define vtkSpatialSolid_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkSpatialLeaf.h"

/**
 * @class   vtkSpatialSolid
 * @brief   the inside of a surface, with a sharp or a soft edge
 *
 * With s the distance from the surface, negative inside, and w the edge's width, the density is 1
 * for s <= -w/2, 0 for s >= w/2, and between them e^2 (3 - 2 e), e = 1/2 - s/w, times Density: 1/2
 * on the surface, with a continuous derivative. With w = 0 it is 1 for s <= 0, else 0.
 *
 * @sa vtkSpatialPrimitive vtkSpatialImplicit
 */
class INTERLUMESOURCES_EXPORT vtkSpatialSolid : public vtkSpatialLeaf
{
public:
  vtkAbstractTypeMacro(vtkSpatialSolid, vtkSpatialLeaf);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The distance over which the density falls, in units of length before the transform. Default 0.
   * Valid: finite, 0 or more; other values are an error and change nothing.
   */
  void SetEdgeWidth(double width);
  double GetEdgeWidth() const { return this->EdgeWidth; }
  ///@}

protected:
  vtkSpatialSolid() = default;
  ~vtkSpatialSolid() override = default;

  bool EvaluateLocally(const double (*points)[3], int number, Sample* samples) const override;

  /// Returns the density, before it is multiplied, at a point of the object's own coordinates.
  virtual double GetProfile(const double x[3]) const = 0;

  /// Returns the density for a distance from the surface, before it is multiplied.
  double GetEdgeProfile(double distance) const;

private:
  vtkSpatialSolid(const vtkSpatialSolid&) = delete;
  void operator=(const vtkSpatialSolid&) = delete;

  double EdgeWidth = 0.0;
};

#endif
