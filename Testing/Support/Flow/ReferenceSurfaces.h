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
 * @brief   a termination surface of which a test gives distance, parameters and extent by formula
 */
class FormulaSurface : public vtkTerminationSurface
{
public:
  static FormulaSurface* New();
  vtkTypeMacro(FormulaSurface, vtkTerminationSurface);

  /// dot(normal, x) = offset, the normal of length 1; u and v are x[j] and x[k].
  static vtkSmartPointer<FormulaSurface> Plane(const Place& normal, double offset, int j, int k);
  /// u and v are the azimuth and the polar angle, in parts of a turn and of half a turn.
  static vtkSmartPointer<FormulaSurface> Sphere(const Place& center, double radius);

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
  /// None: everywhere.
  std::function<bool(const double x[3])> Extent;
  /// None: one part.
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
