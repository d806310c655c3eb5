// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSpatialPrimitive_h
#define vtkSpatialPrimitive_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkSpatialLeaf.h"

class vtkImplicitFunction;

/**
 * @class   vtkSpatialPrimitive
 * @brief   a sphere, box, cylinder, torus, half-space, fuzzy sphere or implicit function, with a
 * sharp or soft edge
 *
 * With p = x - Center, the shapes are
 * - SPHERE: |p| <= Radius;
 * - BOX: |p_i| <= Lengths_i / 2;
 * - CYLINDER: sqrt(p_x^2 + p_y^2) <= Radius, |p_z| <= Height / 2;
 * - TORUS: all points within TubeRadius of the circle with radius Radius around the z axis, in the
 *   plane p_z = 0;
 * - HALF_SPACE: p_z <= 0;
 * - FUZZY_SPHERE: density 1 for r = |p| <= r1, 0 for r >= r0, and (r0^2 - r^2) / (r0^2 - r1^2) in
 *   between, with r0 = Radius and r1 = InnerRadius (C. Zhang, dissertation, Ohio State 2006,
 *   equation 2.7). EdgeWidth is ignored;
 * - IMPLICIT_FUNCTION: f(x) <= 0 for the implicit function f, inside the box Limits. The distance
 *   from the edge is approximated by f / |grad f|. Several threads evaluate f concurrently. VTK's
 *   analytic functions allow this; functions that search a dataset do not.
 *
 * Let s be the signed distance from the edge, negative inside, and w = EdgeWidth. The density is
 * Density times 1 for s <= -w/2, 0 for s >= w/2, and e^2 (3 - 2 e) in between, with e = 1/2 - s/w.
 * It is 1/2 on the edge and has a continuous derivative. If w = 0, it is 1 for s <= 0, otherwise 0.
 * Distances are Euclidean distances before the transform. Use the transform to rotate a shape, or
 * to scale a sphere to an ellipsoid.
 *
 * Errors (vtkErrorMacro, density 0), in addition to those of vtkSpatialObject: InnerRadius is not
 * less than Radius for FUZZY_SPHERE; IMPLICIT_FUNCTION has no function.
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

  /// Returns the lowercase name of a shape, or null if there is no such shape.
  static const char* GetShapeName(int shape);

  ///@{
  /**
   * Set/Get the shape. Default SPHERE. Valid: see Shapes; clamped.
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
   * Set/Get the distance over which the density falls to 0, in units of length before the
   * transform. Default 0. Valid: finite, 0 or more; other values are an error and are ignored.
   */
  void SetEdgeWidth(double width) { this->SetSize(this->EdgeWidth, width, "edge width", true); }
  double GetEdgeWidth() const { return this->EdgeWidth; }
  ///@}

  ///@{
  /**
   * Set/Get the center of the shape, or a point on the plane of HALF_SPACE. Default (0, 0, 0).
   * Valid: finite; other values are an error and are ignored.
   */
  void SetCenter(double x, double y, double z);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /**
   * Set/Get the sizes of the shape, in units of length. Default 0.5 for Radius, 0.25 for
   * InnerRadius, 0.1 for TubeRadius, 1 for Height and Lengths. Valid: finite and above 0, for
   * InnerRadius 0 or more; other values are an error and are ignored.
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
   * Set/Get the function of IMPLICIT_FUNCTION. Default null.
   */
  void SetFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetFunction() const;
  ///@}

  ///@{
  /**
   * Set/Get a box outside which the density of IMPLICIT_FUNCTION is 0: lower and upper x, y, z
   * before the transform. A tight box speeds up sampling. Default infinite. Valid: not NaN, the
   * lower limit at most the upper limit; other values are an error and are ignored.
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
  /// Returns the density at a point in local coordinates, before it is multiplied by Density.
  double GetProfile(const double x[3]) const;
  double GetProfileOfFunction(const double x[3]) const;
  /// Returns the density at a distance from the edge, before it is multiplied by Density.
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
