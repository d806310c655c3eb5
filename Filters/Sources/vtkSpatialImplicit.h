// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSpatialImplicit_h
#define vtkSpatialImplicit_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkSpatialSolid.h"

class vtkImplicitFunction;

/**
 * @class   vtkSpatialImplicit
 * @brief   where an implicit function f is 0 or below, as a spatial object
 *
 * The distance from the surface is f / |grad f|, which is right to first order, so that an edge has
 * its width for any f with a gradient there. Threads evaluate f at once, which VTK's analytic
 * functions allow and those that search a data set do not.
 *
 * Errors (vtkErrorMacro, density 0) besides those of vtkSpatialObject: no function.
 */
class INTERLUMESOURCES_EXPORT vtkSpatialImplicit : public vtkSpatialSolid
{
public:
  static vtkSpatialImplicit* New();
  vtkTypeMacro(vtkSpatialImplicit, vtkSpatialSolid);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The function f. Default null, which is an error when the object is evaluated.
   */
  void SetFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetFunction() const;
  ///@}

  ///@{
  /**
   * A box outside of which the density is 0: lower and upper x, y, z before the transform. Default
   * without end. Valid: no NaN, the lower not above the upper; other values are an error and change
   * nothing. A close box makes sampling fast.
   */
  void SetLimits(const double limits[6]);
  vtkGetVector6Macro(Limits, double);
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkSpatialImplicit();
  ~vtkSpatialImplicit() override;

  std::string Prepare(double bounds[6]) override;
  double GetProfile(const double x[3]) const override;

private:
  vtkSpatialImplicit(const vtkSpatialImplicit&) = delete;
  void operator=(const vtkSpatialImplicit&) = delete;

  vtkSmartPointer<vtkImplicitFunction> Function;
  double Limits[6];
};

#endif
