// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkInflowMapping_h
#define vtkInflowMapping_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkDataSetAlgorithm.h"
#include "vtkInflowKind.h"      // for the kinds
#include "vtkInterlumeReport.h" // for GetReport()
#include "vtkNew.h"             // for the report

#include <map>
#include <memory>
#include <string>

class vtkImageData;

namespace interlume
{
class Error;
class ImplicitFlowArrays;
class InflowEvaluator;
class InflowFunction;
}

/**
 * @class   vtkInflowMapping
 * @brief   a scalar on the termination surfaces, carried to every sample of an implicit flow field
 *
 * Computes Inflow(x) = Phi_f(u(x), v(x)), (f,u,v) where the streamline of x ends (C. Zhang,
 * dissertation, Ohio State 2006, section 4.5): a family of stream surfaces as its level sets, and
 * stream volumes between two of its values, without advection. Each id has a mapping of its own, or
 * the one for all others.
 *
 * Input: what vtkImplicitFlowField gives. Output: the same with the point array `Inflow` (double),
 * NaN where the status is not REACHED_SURFACE, the id has no mapping, or the formula is not finite.
 * The field array `InflowPeriodic` (int, 3 components) tells of each id in use whether its mapping
 * is the same on both sides of the seams of u and v: id, u, v (values at 33 places of the seam
 * agree to 1e-6 of the mapping's range). Inflow is left as the active scalars.
 *
 * Warnings (vtkWarningMacro): Inflow is NaN everywhere, with how many samples reached a surface;
 * not for pieces, of which others may have values.
 *
 * Errors (vtkErrorMacro, empty output): no arrays of vtkFlowStatus; a formula that cannot be read
 * (with the parser's message) or gives a vector, an image without points or scalars or of three
 * dimensions. The output is the same for any number of threads.
 *
 * @sa vtkImplicitFlowField vtkFlowVolume
 */
class INTERLUMEFLOW_EXPORT vtkInflowMapping : public vtkDataSetAlgorithm
{
public:
  static vtkInflowMapping* New();
  vtkTypeMacro(vtkInflowMapping, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Kinds
  {
    NONE = vtkInflowKind::NONE,
    FORMULA = vtkInflowKind::FORMULA,
    RINGS = vtkInflowKind::RINGS,
    IMAGE = vtkInflowKind::IMAGE
  };

  enum
  {
    /// The id of the mapping for all ids that have none of their own.
    ALL = -1
  };

  ///@{
  /**
   * The mapping of an id, or of ALL, as one of:
   * - a formula of u, v and f (the id as a number) in the language of
   * vtkExprTkFunctionParser; null removes the mapping;
   * - Gaussian rings: sum of amplitude exp(-((r - radius) / width)^2), r the distance from
   * (centerU, centerV) in parameters, the short way around in periodic directions; AddRing adds to
   * the rings that the id has;
   * - the first component of an image over u and v, 0 to 1 from its first to its last point,
   * interpolated bilinearly, beyond it clamped, periodic directions around; colours (3 and 4
   * components of unsigned char) as their luminance 0 to 255, 0.30 R + 0.59 G + 0.11 B. Null
   * removes the mapping. u goes along the first axis of the image that has more than one point.
   *
   * Default: for ALL the formula "u". Valid ids: ALL, 0 and above; width above 0, all numbers of a
   * ring finite; others are an error and change nothing. What an id had before of another kind is
   * dropped. The Get functions return what was set for the id itself: NONE, null or 0 where nothing
   * was.
   */
  void SetFormula(int id, const char* formula);
  void AddRing(
    int id, double centerU, double centerV, double radius, double width, double amplitude = 1.0);
  void SetImage(int id, vtkImageData* image);
  void RemoveMapping(int id);
  void RemoveAllMappings();
  int GetKind(int id) const;
  const char* GetFormula(int id) const;
  int GetNumberOfRings(int id) const;
  vtkImageData* GetImage(int id) const;
  ///@}

  /**
   * Returns Phi of an id at (u,v), as the filter evaluates it, with periodic directions as given;
   * NaN without a mapping, or where it is wrong. Not thread-safe.
   */
  double Evaluate(int id, double u, double v, bool isPeriodicU = false, bool isPeriodicV = false);

  /**
   * Whether the mapping of an id goes on over the seam of \a direction, 0 for u and 1 for v: false
   * where that is not periodic, else as InflowPeriodic tells. Not thread-safe.
   */
  bool IsContinued(int id, int direction, bool isPeriodicU, bool isPeriodicV);

  /// Returns the time of the last change, of the images too.
  vtkMTimeType GetMTime() override;

  /**
   * Returns what the last execution did:
   * - Samples: points of the input,
   * - Ids: ids of termination surfaces in use,
   * - ContinuedSeams: seams of u and v that the mappings continue over.
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkInflowMapping();
  ~vtkInflowMapping() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInflowMapping(const vtkInflowMapping&) = delete;
  void operator=(const vtkInflowMapping&) = delete;

  /// Returns the mapping that counts for an id; null without one.
  const interlume::InflowFunction* Find(int id) const;
  /// Returns the mapping of an id itself, of \a kind, empty where it was of another kind; null for
  /// a wrong id.
  interlume::InflowFunction* Take(int id, int kind);
  /// Reads what has changed. Returns an error if a mapping cannot be used.
  interlume::Error Prepare();
  /// Adds the field array of Inflow for samples beside surfaces, where there are such samples.
  void MapBeyond(const interlume::ImplicitFlowArrays& arrays, vtkDataSet* output);

  std::map<int, std::shared_ptr<interlume::InflowFunction>> Mappings;
  std::string PreparedError;
  vtkMTimeType PreparedTime = 0;
  // The evaluators that Evaluate uses.
  std::map<const interlume::InflowFunction*, std::shared_ptr<interlume::InflowEvaluator>>
    Evaluators;
  vtkNew<vtkInterlumeReport> Report;
};

#endif
