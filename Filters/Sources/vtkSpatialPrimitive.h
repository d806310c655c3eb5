// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSpatialPrimitive_h
#define vtkSpatialPrimitive_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkSpatialSolid.h"

/**
 * @class   vtkSpatialPrimitive
 * @brief   sphere, box, cylinder, torus, half-space or fuzzy sphere
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
 *
 * The distance from the edge is Euclidean. The transform gives a shape another direction; one that
 * scales makes an ellipsoid of a sphere.
 *
 * Errors (vtkErrorMacro, density 0) besides those of vtkSpatialObject: InnerRadius not below Radius
 * for a fuzzy sphere.
 *
 * @sa vtkSpatialSolid
 */
class INTERLUMESOURCES_EXPORT vtkSpatialPrimitive : public vtkSpatialSolid
{
public:
  static vtkSpatialPrimitive* New();
  vtkTypeMacro(vtkSpatialPrimitive, vtkSpatialSolid);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Shapes
  {
    SPHERE = 0,
    BOX = 1,
    CYLINDER = 2,
    TORUS = 3,
    HALF_SPACE = 4,
    FUZZY_SPHERE = 5,
    NUMBER_OF_SHAPES = 6
  };

  /// Returns the shape's name in small letters; null for a number that is not a shape.
  static const char* GetShapeName(int shape);

  ///@{
  /**
   * The shape of the object. Default SPHERE. Valid: see Shapes; clamped.
   */
  vtkSetClampMacro(Shape, int, SPHERE, FUZZY_SPHERE);
  vtkGetMacro(Shape, int);
  void SetShapeToSphere() { this->SetShape(SPHERE); }
  void SetShapeToBox() { this->SetShape(BOX); }
  void SetShapeToCylinder() { this->SetShape(CYLINDER); }
  void SetShapeToTorus() { this->SetShape(TORUS); }
  void SetShapeToHalfSpace() { this->SetShape(HALF_SPACE); }
  void SetShapeToFuzzySphere() { this->SetShape(FUZZY_SPHERE); }
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
  void SetInnerRadius(double radius);
  vtkGetMacro(InnerRadius, double);
  void SetTubeRadius(double radius) { this->SetSize(this->TubeRadius, radius, "tube's radius"); }
  vtkGetMacro(TubeRadius, double);
  void SetHeight(double height) { this->SetSize(this->Height, height, "height"); }
  vtkGetMacro(Height, double);
  void SetLengths(double x, double y, double z);
  vtkGetVector3Macro(Lengths, double);
  ///@}

protected:
  vtkSpatialPrimitive() = default;
  ~vtkSpatialPrimitive() override = default;

  std::string Prepare(double bounds[6]) override;
  double GetProfile(const double x[3]) const override;

private:
  vtkSpatialPrimitive(const vtkSpatialPrimitive&) = delete;
  void operator=(const vtkSpatialPrimitive&) = delete;

  void SetSize(double& member, double size, const char* name);

  int Shape = SPHERE;
  double Center[3] = { 0.0, 0.0, 0.0 };
  double Radius = 0.5;
  double InnerRadius = 0.25;
  double TubeRadius = 0.1;
  double Height = 1.0;
  double Lengths[3] = { 1.0, 1.0, 1.0 };
};

#endif
