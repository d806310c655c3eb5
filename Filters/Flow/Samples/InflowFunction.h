#ifndef interlume_InflowFunction_h
#define interlume_InflowFunction_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkExprTkFunctionParser;

namespace interlume
{

/**
 * @class   InflowFunction
 * @brief   what vtkInflowMapping knows of the mapping of one id
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

  /// Makes what evaluators need. What is wrong with the function, or nothing.
  std::string Prepare();

private:
  std::string CheckFormula() const;
  std::string ReadImage();

  friend class InflowEvaluator;
  // The image's values by rows, and how many there are along u and v.
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
  /// \a function is kept by the caller; null: NaN everywhere.
  explicit InflowEvaluator(const InflowFunction* function);
  ~InflowEvaluator();
  InflowEvaluator(const InflowEvaluator&) = delete;
  void operator=(const InflowEvaluator&) = delete;

  /// The surface whose values are asked for from now on.
  void SetSurface(int id, bool isPeriodicU, bool isPeriodicV);
  /// NaN where the value is not finite. A periodic parameter beyond 0 to 1 is taken around.
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
