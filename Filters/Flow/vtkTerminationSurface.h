// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTerminationSurface_h
#define vtkTerminationSurface_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkObject.h"

#include <string> // for errors

class vtkDataArray;
class vtkDataSet;

/**
 * @class   vtkTerminationSurface
 * @brief   where the advection of a sample ends: signed distance, parameters and normal
 *
 * Streamlines are followed until they reach this surface (C. Zhang, dissertation, Ohio State 2006,
 * section 4.4). It is the zero set of a signed distance, or the part of that set for which IsOn is
 * true where the surface ends somewhere (a rectangle of a plane, an open mesh). A streamline
 * reaches it where the distance along it changes sign, from either side.
 *
 * A surface has one or more parts; part p of a surface with id i is known as i + p in the array
 * TerminationId. Each part has parameters (u,v) of its own, from 0 to 1. Where parameters go
 * around, u = 0 and u = 1 are the same place and the direction is periodic; nothing else may jump
 * within a part.
 *
 * The Evaluate functions may be called by several threads at once after Update, until a setter is
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
   * The id of the surface's first part; -1 stands for one that is free, given by the filter in the
   * order of its surfaces. Surfaces of the same id are parts of one surface, lying in the same
   * parameters. Default -1. Valid: -1 to 1000000000, clamped.
   */
  vtkSetClampMacro(Id, int, -1, 1000000000);
  vtkGetMacro(Id, int);
  ///@}

  /// The part of the size by which borders are wider, so that no streamline slips through between
  /// two surfaces that touch.
  static constexpr double BorderTolerance = 1e-9;

  /// Returns how many ids the surface takes. Default 1.
  virtual int GetNumberOfParts() const { return 1; }

  /**
   * Takes the place or the size that the surface leaves open from the field that streamlines are
   * followed in. vtkImplicitFlowField calls it before Update. \a vectors are the vectors at the
   * points of \a field, \a isBackward says whether streamlines go against them. Returns an
   * error message, or an empty string on success. Default: nothing is open.
   */
  virtual std::string PlaceIn(vtkDataSet* field, vtkDataArray* vectors, bool isBackward);

  /// Returns whether PlaceIn reads vectors. Where it does not, and processes hold the field in
  /// parts, its field is the whole without arrays, and \a vectors are those of a part. Default
  /// false.
  virtual bool IsPlacedByVectors() const { return false; }

  /**
   * Prepares the data that the Evaluate functions need. Returns an error message ("the radius is
   * not above 0"), or an empty string on success.
   */
  virtual std::string Update() { return {}; }

  /**
   * Returns the signed distance in world units, positive where the normal points to. Between two
   * points it never changes by more than their distance, but for jumps of sign beyond the end of an
   * open mesh.
   */
  virtual double EvaluateDistance(const double x[3]) const = 0;

  /// Returns whether a point at distance 0 is on the surface. Default true.
  virtual bool IsOn(const double x[3]) const;

  /// Returns whether \a x, anywhere, is straight above or below the surface and not beyond its rim.
  /// Default: IsOn of the point as far from \a x as the distance says, along the normal.
  virtual bool IsBeside(const double x[3]) const;

  /// Returns the part that is nearest to \a x. Default 0.
  virtual int EvaluatePart(const double x[3]) const;

  /// Computes the parameters of the point of the surface nearest to \a x, 0 to 1; in a periodic
  /// direction below 1.
  virtual void EvaluateParameters(const double x[3], double uv[2]) const = 0;

  /// Computes the unit normal at the point of the surface nearest to \a x.
  virtual void EvaluateNormal(const double x[3], double normal[3]) const = 0;

  /**
   * Computes the point of a part with these parameters. Returns false where there is none, as in
   * the gaps between the triangles of a mesh's texture.
   */
  virtual bool EvaluatePoint(int part, const double uv[2], double x[3]) const = 0;

  /// Returns whether \a direction of a part, 0 for u and 1 for v, is periodic with period 1.
  /// Default false.
  virtual bool IsPeriodic(int direction, int part = 0) const;

  /**
   * Returns how far the nearest point of the surface is, its rim counted, less what rounding of the
   * surface's own numbers may be. Default: the distance from the point that EvaluateParameters
   * finds.
   */
  virtual double EvaluateGap(const double x[3]) const;

  /// Returns the lower and upper bounds of x, y, z; empty (lower above upper) for a surface without
  /// bounds.
  virtual void GetBounds(double bounds[6]) const = 0;

protected:
  vtkTerminationSurface() = default;
  ~vtkTerminationSurface() override = default;

  /// Brings the parameters that EvaluatePoint is asked for into 0 ... 1: periodic directions go
  /// around, others are clamped to 0 ... 1 when they are beyond by BorderTolerance at most. Returns
  /// false for others and without the part.
  bool TakeParameters(int part, const double uv[2], double taken[2]) const;

private:
  vtkTerminationSurface(const vtkTerminationSurface&) = delete;
  void operator=(const vtkTerminationSurface&) = delete;

  int Id = -1;
};

#endif
