// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_InflowFunction_h
#define interlume_InflowFunction_h

#include "Common/Error.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <set>
#include <string>
#include <vector>

class vtkExprTkFunctionParser;

namespace interlume
{

/**
 * @class   InflowFunction
 * @brief   function that vtkInflowMapping uses for one surface id
 *
 * A formula is a function of u, v, the id f, the advection time t and one-component arrays of the
 * samples. Rings and images are functions of u and v.
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

  /// Prepares the data for the evaluators. \a arrays are the names of the arrays that formulas can
  /// use. Returns an error if the function cannot be used.
  Error Prepare(const std::set<std::string>& arrays);

  /// Returns true unless the last call of Prepare returned an error.
  bool IsUsable() const { return this->CanBeUsed; }
  /// Returns true if the formula contains t.
  bool HasTime() const { return this->ContainsTime; }
  /// Returns the names of the arrays in the formula.
  const std::vector<std::string>& GetArrays() const { return this->Arrays; }

private:
  /// Replaces the names of arrays in the formula, which may be quoted, by names for the parser.
  Error ReplaceArrays(const std::set<std::string>& arrays);
  void UseArray(const std::string& name);
  /// Replaces names for the parser in a message by the names of arrays.
  std::string RestoreNames(std::string text) const;
  Error CheckFormula() const;
  Error ReadImage();

  friend class InflowEvaluator;
  // The formula for the parser, and the arrays that its variables stand for.
  std::string Expression;
  bool ContainsTime = false;
  bool CanBeUsed = true;
  std::vector<std::string> Arrays;
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
  /// Sets the advection time, and the value of array \a i of the function, for subsequent calls of
  /// Evaluate. Both are NaN before.
  void SetTime(double time);
  void SetArrayValue(std::size_t i, double value);
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
