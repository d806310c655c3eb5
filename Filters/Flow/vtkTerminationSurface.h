// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTerminationSurface_h
#define vtkTerminationSurface_h

#include "vtkDeprecation.h"      // for VTK_DEPRECATION
#include "InterlumeFlowModule.h" // for the export macro
#include "vtkObject.h"

#include <string> // for errors

class vtkDataArray;
class vtkDataSet;

/**
 * @class   vtkTerminationSurface
 * @brief   abstract surface on which streamlines of vtkImplicitFlowField end
 *
 * A termination surface is the zero set of a signed distance. If it has a boundary, such as that of
 * a rectangle or an open mesh, it is the part of the zero set where IsOn returns true. A
 * streamline reaches it where the distance changes sign along the streamline, from either side.
 * Subclasses compute the distance, the parameters (u,v) and the normal.
 *
 * A surface has one or more parts. Part p of a surface with id i appears as i + p in the array
 * TerminationId. Each part has its own parameters (u,v) from 0 to 1. In a periodic direction, 0 and
 * 1 are the same position. Everywhere else, parameters must be continuous.
 *
 * After Update, several threads may call the Evaluate functions concurrently, until a setter is
 * called.
 *
 * @sa vtkTerminationInflow vtkTerminationPlane vtkTerminationSphere vtkTerminationCylinder
 * vtkTerminationBox vtkTerminationTube vtkTerminationMesh vtkImplicitFlowField
 */
class INTERLUMEFLOW_EXPORT vtkTerminationSurface : public vtkObject
{
public:
  vtkAbstractTypeMacro(vtkTerminationSurface, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Id of the first part of the surface. For -1, vtkImplicitFlowField assigns a free id; its
   * surfaces get such ids in the order in which they were added. Surfaces with the same id are
   * treated as one surface with common parameters. Default: -1. Valid: -1 to 1000000000; clamped.
   */
  vtkSetClampMacro(Id, int, -1, 1000000000);
  vtkGetMacro(Id, int);
  ///@}

  /// Fraction of the surface's size by which its boundaries are widened, so that no streamline
  /// passes between two surfaces that touch.
  static constexpr double BorderTolerance = 1e-9;

  /// Return the number of ids that the surface uses. Default: 1.
  virtual int GetNumberOfParts() const { return 1; }

  /**
   * Compute an automatic position or size from the field. vtkImplicitFlowField calls this function
   * before Update. \a vectors are the vectors at the points of \a field, and \a isBackward is true
   * if streamlines run against the vectors. Return an error message, or an empty string on success.
   * Default: do nothing.
   */
  virtual std::string InitializeFromField(
    vtkDataSet* field, vtkDataArray* vectors, bool isBackward);
  VTK_DEPRECATION("Call or override InitializeFromField.")
  std::string PlaceIn(vtkDataSet* field, vtkDataArray* vectors, bool isBackward)
  {
    return this->InitializeFromField(field, vectors, isBackward);
  }

  /// Return true if InitializeFromField reads vectors. If it returns false and the field is
  /// distributed, InitializeFromField gets the whole field without arrays, and \a vectors belong to
  /// the partition of this process only. Default: false.
  virtual bool IsPlacedByVectors() const { return false; }

  /**
   * Prepare the data for the Evaluate functions. Return an error message, such as "the radius is
   * not above 0", or an empty string on success.
   */
  virtual std::string Update() { return {}; }

  /**
   * Return the signed distance in world units, positive on the side of the normal. Between two
   * points it never changes by more than their distance, except for sign jumps past the boundary of
   * an open mesh.
   */
  virtual double EvaluateDistance(const double x[3]) const = 0;

  /// Return true if a point at distance 0 is on the surface. Default: true.
  virtual bool IsOn(const double x[3]) const;

  /// Return true if the projection of \a x along the normal is on the surface, not past its
  /// boundary. Default: IsOn of the projection.
  virtual bool ProjectsOntoSurface(const double x[3]) const;
  VTK_DEPRECATION("Call or override ProjectsOntoSurface.")
  bool IsBeside(const double x[3]) const { return this->ProjectsOntoSurface(x); }

  /// Return the part nearest to \a x. Default: 0.
  virtual int EvaluatePart(const double x[3]) const;

  /// Compute the parameters of the surface point nearest to \a x. They are in [0, 1], or in [0, 1)
  /// in a periodic direction.
  virtual void EvaluateParameters(const double x[3], double uv[2]) const = 0;

  /// Compute the unit normal at the surface point nearest to \a x.
  virtual void EvaluateNormal(const double x[3], double normal[3]) const = 0;

  /**
   * Compute the point of a part with these parameters. Return false if no such point exists, as in
   * gaps between a mesh's triangles in texture space.
   */
  virtual bool EvaluatePoint(int part, const double uv[2], double x[3]) const = 0;

  /// Return true if \a direction (0: u, 1: v) of a part is periodic with period 1. Default: false.
  virtual bool IsPeriodic(int direction, int part = 0) const;

  /**
   * Return the distance from \a x to the nearest surface point, including points on the boundary,
   * minus the rounding error of the surface's own data. Default: the distance to the point with the
   * parameters from EvaluateParameters, or the absolute value of EvaluateDistance if no such point
   * exists.
   */
  virtual double EvaluateGap(const double x[3]) const;

  /// Return the lower and upper bounds of x, y, z; empty bounds (lower above upper) for an
  /// unbounded surface.
  virtual void GetBounds(double bounds[6]) const = 0;

protected:
  vtkTerminationSurface() = default;
  ~vtkTerminationSurface() override = default;

  /// Maps the parameters of EvaluatePoint into [0, 1]: wraps periodic parameters, and clamps others
  /// that exceed the range by at most BorderTolerance. Returns false if a parameter exceeds the
  /// range by more or is not finite, or if the part is invalid.
  bool NormalizeParameters(int part, const double uv[2], double taken[2]) const;

private:
  vtkTerminationSurface(const vtkTerminationSurface&) = delete;
  void operator=(const vtkTerminationSurface&) = delete;

  int Id = -1;
};

#endif
