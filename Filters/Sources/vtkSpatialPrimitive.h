// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSpatialPrimitive_h
#define vtkSpatialPrimitive_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkSpatialLeaf.h"

class vtkImplicitFunction;

/**
 * @class   vtkSpatialPrimitive
 * @brief   sphere, box, cylinder, torus, half-space, fuzzy sphere or implicit function, with a
 * sharp or a soft edge
 *
 * With p = x - Center, the shapes are
 * - SPHERE: |p| <= Radius;
 * - BOX: |p_i| <= Lengths_i / 2;
 * - CYLINDER: sqrt(p_x^2 + p_y^2) <= Radius, |p_z| <= Height / 2;
 * - TORUS: the points within TubeRadius of the circle of Radius around the z axis, in p_z = 0;
 * - HALF_SPACE: p_z <= 0;
 * - FUZZY_SPHERE: no edge, but the density 1 for r = |p| <= r1, 0 for r >= r0 and
 *   (r0^2 - r^2) / (r0^2 - r1^2) between, r0 = Radius, r1 = InnerRadius (C. Zhang, dissertation,
 *   Ohio State 2006, equation 2.7).
 * - IMPLICIT_FUNCTION: f(x) <= 0 for the implicit function f, within Limits. The distance from the
 *   edge is f / |grad f|, which is right to first order, so that an edge has its width for any f
 *   with a gradient there. Threads evaluate f at once, which VTK's analytic functions allow and
 *   those that search a data set do not.
 *
 * With s the distance from the edge, negative inside, and w = EdgeWidth, the density is 1 for
 * s <= -w/2, 0 for s >= w/2, and between them e^2 (3 - 2 e), e = 1/2 - s/w, times Density: 1/2 on
 * the edge, with a continuous derivative. With w = 0 it is 1 for s <= 0, else 0. The distance from
 * the edge of a shape is Euclidean. The transform gives a shape another direction; one that
 * scales makes an ellipsoid of a sphere.
 *
 * Errors (vtkErrorMacro, density 0) besides those of vtkSpatialObject: InnerRadius not below Radius
 * for a fuzzy sphere; no function for an implicit function.
 */
class INTERLUMESOURCES_EXPORT vtkSpatialPrimitive : public vtkSpatialLeaf
{
public:
  static vtkSpatialPrimitive* New();
  vtkTypeMacro(vtkSpatialPrimitive, vtkSpatialLeaf);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Shapes
  {
    SPHERE = 0,
    BOX = 1,
    CYLINDER = 2,
    TORUS = 3,
    HALF_SPACE = 4,
    FUZZY_SPHERE = 5,
    IMPLICIT_FUNCTION = 6,
    NUMBER_OF_SHAPES = 7
  };

  /// Returns the shape's name in small letters; null for a number that is not a shape.
  static const char* GetShapeName(int shape);

  ///@{
  /**
   * The shape of the object. Default SPHERE. Valid: see Shapes; clamped.
   */
  vtkSetClampMacro(Shape, int, SPHERE, IMPLICIT_FUNCTION);
  vtkGetMacro(Shape, int);
  void SetShapeToSphere() { this->SetShape(SPHERE); }
  void SetShapeToBox() { this->SetShape(BOX); }
  void SetShapeToCylinder() { this->SetShape(CYLINDER); }
  void SetShapeToTorus() { this->SetShape(TORUS); }
  void SetShapeToHalfSpace() { this->SetShape(HALF_SPACE); }
  void SetShapeToFuzzySphere() { this->SetShape(FUZZY_SPHERE); }
  void SetShapeToImplicitFunction() { this->SetShape(IMPLICIT_FUNCTION); }
  ///@}

  ///@{
  /**
   * The distance over which the density falls, in units of length before the transform. Default 0.
   * Valid: finite, 0 or more; other values are an error and change nothing.
   */
  void SetEdgeWidth(double width) { this->SetSize(this->EdgeWidth, width, "edge width", true); }
  double GetEdgeWidth() const { return this->EdgeWidth; }
  ///@}

  ///@{
  /**
   * The centre of the shape, for a half-space a point of its plane. Default (0, 0, 0). Valid:
   * finite; other values are an error and change nothing.
   */
  void SetCenter(double x, double y, double z);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /**
   * The sizes of the shape, in units of length. Default 0.5 for Radius, 0.25 for InnerRadius, 0.1
   * for TubeRadius, 1 for the others. Valid: finite, above 0, InnerRadius 0 or more; other values
   * are an error and change nothing.
   */
  void SetRadius(double radius) { this->SetSize(this->Radius, radius, "radius"); }
  vtkGetMacro(Radius, double);
  void SetInnerRadius(double radius)
  {
    this->SetSize(this->InnerRadius, radius, "inner radius", true);
  }
  vtkGetMacro(InnerRadius, double);
  void SetTubeRadius(double radius) { this->SetSize(this->TubeRadius, radius, "tube's radius"); }
  vtkGetMacro(TubeRadius, double);
  void SetHeight(double height) { this->SetSize(this->Height, height, "height"); }
  vtkGetMacro(Height, double);
  void SetLengths(double x, double y, double z);
  vtkGetVector3Macro(Lengths, double);
  ///@}

  ///@{
  /**
   * The function f of IMPLICIT_FUNCTION. Default null.
   */
  void SetFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetFunction() const;
  ///@}

  ///@{
  /**
   * A box outside of which the density of IMPLICIT_FUNCTION is 0: lower and upper x, y, z before
   * the transform. Default without end. Valid: no NaN, the lower not above the upper; other values
   * are an error and change nothing. A close box makes sampling fast.
   */
  void SetLimits(const double limits[6]);
  vtkGetVector6Macro(Limits, double);
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkSpatialPrimitive();
  ~vtkSpatialPrimitive() override;

  std::string Prepare(double bounds[6]) override;
  bool EvaluateLocally(const double (*points)[3], int number, Sample* samples) const override;

private:
  vtkSpatialPrimitive(const vtkSpatialPrimitive&) = delete;
  void operator=(const vtkSpatialPrimitive&) = delete;

  void SetSize(double& member, double size, const char* name, bool canBeZero = false);
  /// Returns the density, before it is multiplied, at a point of the object's own coordinates.
  double GetProfile(const double x[3]) const;
  double GetProfileOfFunction(const double x[3]) const;
  /// Returns the density for a distance from the edge, before it is multiplied.
  double GetEdgeProfile(double distance) const;

  vtkSmartPointer<vtkImplicitFunction> Function;
  double Limits[6];
  double EdgeWidth = 0.0;

  int Shape = SPHERE;
  double Center[3] = { 0.0, 0.0, 0.0 };
  double Radius = 0.5;
  double InnerRadius = 0.25;
  double TubeRadius = 0.1;
  double Height = 1.0;
  double Lengths[3] = { 1.0, 1.0, 1.0 };
};

#endif
