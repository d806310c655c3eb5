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
 * @brief   a density and a colour at every point of space: a node of constructive volume geometry
 *
 * M. Chen and J. V. Tucker, "Constructive volume geometry", Computer Graphics Forum 19(4), 2000: a
 * spatial object is a tuple of scalar fields. Here they are the density, 0 to 1, which stands for
 * opacity, and red, green, blue, 0 to 1. Leaves are vtkSpatialPrimitive and
 * vtkSpatialImage; vtkSpatialOperation and vtkSpatialTurbulence make objects of objects. An object
 * may be an operand of several others.
 *
 * Positions are in units of length of the parent. An object is made in coordinates of its own and
 * placed by its transform. Outside its bounds the density is 0. Where the density is 0 there is no
 * colour, and black is returned.
 *
 * Errors (vtkErrorMacro, density 0): a transform that is not finite or has no inverse; what the
 * derived classes name.
 *
 * @sa vtkConstructiveVolume vtkConstructiveModelSource
 */
class INTERLUMESOURCES_EXPORT vtkSpatialObject : public vtkObject
{
public:
  vtkAbstractTypeMacro(vtkSpatialObject, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The density and the colour at a point.
  struct Sample
  {
    double Density = 0.0;
    double Color[3] = { 0.0, 0.0, 0.0 };
  };

  /// The largest number of points at which an object is evaluated at once.
  static constexpr int SpanLength = 32;

  ///@{
  /**
   * The transform from the object's own coordinates to those of its parent. Null, the default, is
   * the identity. vtkMatrixToLinearTransform makes one of a vtkMatrix4x4. Valid: finite,
   * invertible, affine.
   */
  void SetTransform(vtkLinearTransform* transform);
  vtkLinearTransform* GetTransform() const;
  ///@}

  /**
   * Computes the sample at \a x. The object is made ready before, so threads that share an object
   * call EvaluateSpan instead.
   */
  void Evaluate(const double x[3], Sample& sample);

  /**
   * Computes the box that the object is in, in the parent's coordinates: lower and upper x, y, z;
   * infinite for objects without an end, the lower above the upper for nothing. Returns false, with
   * an error, when the object cannot be evaluated.
   */
  bool GetBounds(double bounds[6]);

  /**
   * Makes the object and all it consists of ready for EvaluateSpan. Returns an error
   * message, or an empty string on success.
   */
  std::string Update();

  /**
   * Computes the samples at up to SpanLength points, fast when they are close to each other.
   * Returns false when the density is 0 at all of them, and then \a samples may be left as they
   * are. Update is called before; after it threads may call this at once.
   */
  bool EvaluateSpan(const double (*points)[3], int number, Sample* samples) const;

  /// Returns whether \a object is this one or a part of it.
  virtual bool Contains(const vtkSpatialObject* object) const { return object == this; }

  vtkMTimeType GetMTime() override;

protected:
  vtkSpatialObject();
  ~vtkSpatialObject() override;

  /// Does what Update does for a derived class, and computes its bounds in its own coordinates.
  /// Returns an error message, or an empty string on success.
  virtual std::string Prepare(double bounds[6]) = 0;

  /// Does what EvaluateSpan does for a derived class, at points of its own coordinates.
  virtual bool EvaluateLocally(const double (*points)[3], int number, Sample* samples) const = 0;

private:
  vtkSpatialObject(const vtkSpatialObject&) = delete;
  void operator=(const vtkSpatialObject&) = delete;

  /// Takes over the transform's inverse. Returns false when it has none.
  bool PrepareTransform(double matrix[12]);
  /// Computes the bounds in the parent's coordinates from the box in the object's own.
  void PrepareBounds(const double local[6], const double matrix[12]);
  bool Misses(const double (*points)[3], int number) const;

  vtkSmartPointer<vtkLinearTransform> Transform;
  vtkTimeStamp UpdateTime;
  /// The rows of the affine map to the object's own coordinates.
  double Inverse[12];
  double Bounds[6];
  /// The bounds, made a little larger, so that no rounding cuts anything off.
  double CullingBounds[6];
};

#endif
