#ifndef vtkInflowFunction_h
#define vtkInflowFunction_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkExprTkFunctionParser;

/**
 * @class   vtkInflowFunction
 * @brief   what vtkInflowMapping knows of the mapping of one id
 */
class vtkInflowFunction
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

  friend class vtkInflowEvaluator;
  // The image's values by rows, and how many there are along u and v.
  std::vector<double> Values;
  int Size[2] = { 0, 0 };
};

/**
 * @class   vtkInflowEvaluator
 * @brief   values of a prepared vtkInflowFunction, for one thread
 */
class vtkInflowEvaluator
{
public:
  /// \a function is kept by the caller; null: NaN everywhere.
  explicit vtkInflowEvaluator(const vtkInflowFunction* function);
  ~vtkInflowEvaluator();
  vtkInflowEvaluator(const vtkInflowEvaluator&) = delete;
  void operator=(const vtkInflowEvaluator&) = delete;

  /// The surface whose values are asked for from now on.
  void SetSurface(int id, bool isPeriodicU, bool isPeriodicV);
  /// NaN where the value is not finite. A periodic parameter beyond 0 to 1 is taken around.
  double Evaluate(double u, double v);

private:
  double EvaluateFormula(const double uv[2]);
  double EvaluateRings(const double uv[2]) const;
  double EvaluateImage(const double uv[2]) const;

  const vtkInflowFunction* Function;
  bool IsPeriodic[2] = { false, false };
  vtkSmartPointer<vtkExprTkFunctionParser> Parser;
};

#endif
