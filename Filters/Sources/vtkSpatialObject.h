// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSpatialObject_h
#define vtkSpatialObject_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for the transform

#include <string> // for error messages

class vtkLinearTransform;

/**
 * @class   vtkSpatialObject
 * @brief   base class of constructive volume geometry: a density and a color at every point
 *
 * In constructive volume geometry (M. Chen and J. V. Tucker, Computer Graphics Forum 19(4), 2000),
 * a spatial object is a tuple of scalar fields. Here they are the density, which represents
 * opacity, and red, green and blue, all from 0 to 1. The leaves are vtkSpatialPrimitive and
 * vtkSpatialImage; vtkSpatialOperation and vtkSpatialTurbulence combine or modify other objects. An
 * object can be an operand of several others.
 *
 * An object is defined in local coordinates, which Transform maps to the coordinates of its parent.
 * Outside its bounds the density is 0. The color is black where the density is 0.
 *
 * Errors (vtkErrorMacro, density 0): the transform is not finite, not affine or not invertible;
 * errors of subclasses.
 *
 * @sa vtkConstructiveVolume vtkConstructiveModelSource
 */
class INTERLUMESOURCES_EXPORT vtkSpatialObject : public vtkObject
{
public:
  vtkAbstractTypeMacro(vtkSpatialObject, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Density and color at a point.
  struct Sample
  {
    double Density = 0.0;
    double Color[3] = { 0.0, 0.0, 0.0 };
  };

  /// Maximum number of points per call of EvaluateSpan.
  static constexpr int SpanLength = 32;

  ///@{
  /**
   * Set/Get the transform from local coordinates to the parent's coordinates. Use
   * vtkMatrixToLinearTransform for a vtkMatrix4x4. Default null, the identity. Valid: finite,
   * affine and invertible.
   */
  void SetTransform(vtkLinearTransform* transform);
  vtkLinearTransform* GetTransform() const;
  ///@}

  /**
   * Computes the density and color at \a x. This calls Update, so threads that share an object must
   * use EvaluateSpan instead.
   */
  void Evaluate(const double x[3], Sample& sample);

  /**
   * Computes the bounds of the object in the parent's coordinates. They may be infinite. If the
   * object is empty, lower bounds exceed upper bounds. Reports an error and returns false if the
   * object cannot be evaluated.
   */
  bool GetBounds(double bounds[6]);

  /**
   * Prepares the object and its operands for EvaluateSpan. Returns an error message, or an empty
   * string on success.
   */
  std::string Update();

  /**
   * Computes the samples at up to SpanLength points. This is efficient if the points are close
   * together. Returns false if the density is 0 at all of them; \a samples may then be left
   * unchanged. Call Update first. Several threads may call this concurrently.
   */
  bool EvaluateSpan(const double (*points)[3], int number, Sample* samples) const;

  /// Returns whether \a object is this object or one of its operands, at any depth.
  virtual bool Contains(const vtkSpatialObject* object) const { return object == this; }

  vtkMTimeType GetMTime() override;

protected:
  vtkSpatialObject();
  ~vtkSpatialObject() override;

  /// Prepares a subclass for EvaluateLocally, and computes its bounds in local coordinates.
  /// Returns an error message, or an empty string on success.
  virtual std::string Prepare(double bounds[6]) = 0;

  /// Evaluates a subclass as in EvaluateSpan, at points in local coordinates.
  virtual bool EvaluateLocally(const double (*points)[3], int number, Sample* samples) const = 0;

private:
  vtkSpatialObject(const vtkSpatialObject&) = delete;
  void operator=(const vtkSpatialObject&) = delete;

  /// Computes the transform's matrix and its inverse. Returns false if it is not invertible.
  bool PrepareTransform(double matrix[12]);
  /// Computes the bounds in the parent's coordinates from the bounds in local coordinates.
  void PrepareBounds(const double local[6], const double matrix[12]);
  /// Returns whether all points lie outside the bounds, on the same side of the box.
  bool Misses(const double (*points)[3], int number) const;

  vtkSmartPointer<vtkLinearTransform> Transform;
  vtkTimeStamp UpdateTime;
  /// Rows of the affine map from the parent's coordinates to local coordinates.
  double Inverse[12];
  double Bounds[6];
  /// Bounds, slightly enlarged so that rounding errors exclude no point.
  double CullingBounds[6];
};

#endif
