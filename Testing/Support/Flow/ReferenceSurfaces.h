// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceSurfaces_h
#define ReferenceSurfaces_h

#include "Support/AnalyticFlows/ReferenceFlow.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTerminationSurface.h"

#include <functional>

namespace reference
{

/**
 * @class   FormulaSurface
 * @brief   termination surface whose distance, parameters and extent are functions set by a test
 */
class FormulaSurface : public vtkTerminationSurface
{
public:
  static FormulaSurface* New();
  vtkTypeMacro(FormulaSurface, vtkTerminationSurface);

  /// Returns the plane dot(normal, x) = offset, where \a normal is a unit vector. u and v are x[j]
  /// and x[k].
  static vtkSmartPointer<FormulaSurface> Plane(const Position& normal, double offset, int j, int k);
  /// Returns a sphere, where u is the azimuth in turns and v is the polar angle in half turns.
  static vtkSmartPointer<FormulaSurface> Sphere(const Position& center, double radius);

  double EvaluateDistance(const double x[3]) const override { return this->Distance(x); }
  bool IsOn(const double x[3]) const override { return !this->Extent || this->Extent(x); }
  int EvaluatePart(const double x[3]) const override { return this->Part ? this->Part(x) : 0; }
  void EvaluateParameters(const double x[3], double uv[2]) const override
  {
    this->Parameters(x, uv);
  }
  void EvaluateNormal(const double x[3], double normal[3]) const override;
  bool EvaluatePoint(int part, const double uv[2], double x[3]) const override;
  void GetBounds(double bounds[6]) const override;

  std::function<double(const double x[3])> Distance;
  std::function<void(const double x[3], double uv[2])> Parameters;
  /// Returns whether a point is within the extent of the surface. If empty, the surface is
  /// unbounded.
  std::function<bool(const double x[3])> Extent;
  /// Returns the part of the surface nearest to x. If empty, the surface has one part.
  std::function<int(const double x[3])> Part;

protected:
  FormulaSurface() = default;
  ~FormulaSurface() override = default;

private:
  FormulaSurface(const FormulaSurface&) = delete;
  void operator=(const FormulaSurface&) = delete;
};

}

#endif
