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
 * @brief   the mapping of one id of vtkInflowMapping
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

  /// Prepares the data that evaluators need. Returns an error if the function cannot be used.
  Error Prepare();

private:
  Error CheckFormula() const;
  Error ReadImage();

  friend class InflowEvaluator;
  // The values of the image by rows, and how many there are along u and v.
  std::vector<double> Values;
  int Size[2] = { 0, 0 };
};

/**
 * @class   InflowEvaluator
 * @brief   values of a prepared InflowFunction, for one thread
 */
class InflowEvaluator
{
public:
  /// Makes an evaluator. \a function is kept by the caller; with null, values are NaN everywhere.
  explicit InflowEvaluator(const InflowFunction* function);
  ~InflowEvaluator();
  InflowEvaluator(const InflowEvaluator&) = delete;
  void operator=(const InflowEvaluator&) = delete;

  /// Sets the surface whose values are asked for from now on.
  void SetSurface(int id, bool isPeriodicU, bool isPeriodicV);
  /// Returns the value at (u,v), NaN where it is not finite. A periodic parameter beyond 0 to 1 is
  /// taken around.
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
