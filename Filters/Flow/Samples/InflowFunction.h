// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_InflowFunction_h
#define interlume_InflowFunction_h

#include "Common/Error.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkExprTkFunctionParser;

namespace interlume
{

/**
 * @class   InflowFunction
 * @brief   function of u and v that vtkInflowMapping uses for one surface id
 */
class InflowFunction
{
public:
  struct Ring
  {
    double Center[2];
    double Radius;
    double Width;
    double Amplitude;
  };

  /// One of vtkInflowKind::Values.
  int Kind = 0;
  std::string Formula;
  std::vector<Ring> Rings;
  vtkSmartPointer<vtkImageData> Image;

  /// Prepares the data for the evaluators. Returns an error if the function cannot be used.
  Error Prepare();

private:
  Error CheckFormula() const;
  Error ReadImage();

  friend class InflowEvaluator;
  // Values of the image, with u varying fastest.
  std::vector<double> Values;
  // Number of values along u and v.
  int Size[2] = { 0, 0 };
};

/**
 * @class   InflowEvaluator
 * @brief   evaluates a prepared InflowFunction in one thread
 */
class InflowEvaluator
{
public:
  /// \a function must outlive the evaluator. If it is null, all values are NaN.
  explicit InflowEvaluator(const InflowFunction* function);
  ~InflowEvaluator();
  InflowEvaluator(const InflowEvaluator&) = delete;
  void operator=(const InflowEvaluator&) = delete;

  /// Sets the surface for subsequent calls of Evaluate.
  void SetSurface(int id, bool isPeriodicU, bool isPeriodicV);
  /// Returns the value at (u,v), or NaN if it is not finite. Periodic parameters outside [0, 1] are
  /// wrapped.
  double Evaluate(double u, double v);

private:
  double EvaluateFormula(const double uv[2]);
  double EvaluateRings(const double uv[2]) const;
  double EvaluateImage(const double uv[2]) const;

  const InflowFunction* Function;
  bool IsPeriodic[2] = { false, false };
  vtkSmartPointer<vtkExprTkFunctionParser> Parser;
};

}

#endif
