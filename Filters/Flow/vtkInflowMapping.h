// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkInflowMapping_h
#define vtkInflowMapping_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkDataSetAlgorithm.h"
#include "vtkInflowKind.h"      // for the kinds
#include "vtkInterlumeReport.h" // for GetReport()
#include "vtkNew.h"             // for the report

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
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
 * @brief   map a function on the termination surfaces to every sample of an implicit flow field
 *
 * Computes Inflow(x) = Phi_f(u(x), v(x)). The streamline through x ends on the termination surface
 * with id f, at the parameters (u,v), and Phi_f is the mapping of that id. The level sets of Inflow
 * are stream surfaces, and the region between two values is a stream volume; no advection is
 * needed. A formula may also contain the advection time t(x), for an inflow that changes over time,
 * and other arrays of the samples. An id without its own mapping uses the mapping of ALL. See
 * Documentation/methods/flow-volumes.md.
 *
 * Input: the output of vtkImplicitFlowField. Output: the input with the point array `Inflow`
 * (double) as active scalars. Inflow is NaN where the status is not REACHED_SURFACE, the id has no
 * mapping, or its value is not finite. The field array `InflowPeriodic` (int, 3 components: id, u,
 * v) has one tuple per id in use. Its component u or v is 1 if the mapping is continuous across
 * that seam, otherwise 0. A mapping counts as continuous if, at 33 positions along the seam, the
 * values on both sides differ by at most 1e-6 of the mapping's range. With t or arrays, this holds
 * for their smallest, middle and largest values. The output is identical for any number of threads.
 *
 * Warnings (vtkWarningMacro, not if one of several pieces is requested): Inflow is NaN everywhere.
 *
 * Errors (vtkErrorMacro, empty output): missing arrays of vtkFlowStatus or of a formula; a formula
 * that the parser rejects or whose value is a vector; an image that has no points or scalars, or
 * that is three-dimensional.
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

  enum Ids
  {
    /// Id of the mapping that is used for all ids without their own mapping.
    ALL = -1
  };

  ///@{
  /**
   * Set or get the mapping of an id, or of ALL. A mapping is one of:
   * - a formula of u, v, f (the id as a number), t (AdvectionTime) and one-component point arrays
   *   of the input, by name, in the language of vtkExprTkFunctionParser. Names that are not words,
   *   or that are words of this language, must be in double quotes. Null removes the mapping;
   * - Gaussian rings: the sum of amplitude exp(-((r - radius) / width)^2), where r is the distance
   *   from (centerU, centerV) in parameter space, measured the short way around in periodic
   *   directions. AddRing adds to the rings of the id;
   * - the first component of an image over u and v, which run from 0 at the first to 1 at the last
   *   point of an image axis. It is interpolated bilinearly, repeated in periodic directions, and
   *   clamped in other directions. Colors (3 or 4 components of unsigned char) are converted to
   *   luminance from 0 to 255, 0.30 R + 0.59 G + 0.11 B. u runs along the first image axis with
   *   more than one point. Null removes the mapping.
   *
   * Setting one kind replaces a mapping of another kind. Default: the formula "u" for ALL. Valid
   * ids: ALL, and 0 or above. A ring needs a width above 0 and finite numbers. Invalid arguments
   * are errors and change nothing. The Get functions return the settings of the id itself: NONE,
   * null or 0 if it has none.
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
   * Return the mapping of an id at (u,v) and \a time as the filter evaluates it; NaN if there is no
   * mapping, if it cannot be used, or if it is a formula with arrays. Not thread-safe.
   */
  double Evaluate(int id, double u, double v, bool isPeriodicU = false, bool isPeriodicV = false,
    double time = 0.0);

  /**
   * Return true if the mapping of an id is continuous across the seam of \a direction (0: u, 1: v),
   * by the criterion of InflowPeriodic; false if the direction is not periodic. Not thread-safe.
   */
  bool IsContinued(int id, int direction, bool isPeriodicU, bool isPeriodicV);

  /// Return the modification time, including that of the images.
  vtkMTimeType GetMTime() override;

  /**
   * Return the report of the last execution:
   * - Samples: number of input points,
   * - Ids: number of ids of termination surfaces in use,
   * - ContinuedSeams: number of seams across which the mappings are continuous.
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

  /// Returns the mapping to use for an id, or null if no mapping applies.
  const interlume::InflowFunction* Find(int id) const;
  /// Returns the id's own mapping of \a kind. Creates an empty one if the id has no mapping or one
  /// of another kind. Returns null for an invalid id.
  interlume::InflowFunction* GetOrCreate(int id, int kind);
  /// Prepares the mappings if any of them has changed. Returns an error if one cannot be used.
  interlume::Error Prepare();
  /// Prepares the mappings for the arrays of an input, and finds the values for IsContinued.
  /// Returns an error if a mapping cannot be used.
  interlume::Error UseArrays(const interlume::ImplicitFlowArrays& arrays, vtkDataSet* input);
  /// Sets time and arrays to their smallest, middle or largest values.
  void SetLevel(interlume::InflowEvaluator& evaluator, const interlume::InflowFunction* function,
    std::size_t level) const;
  /// Computes the values of all samples. Returns false if the execution was aborted.
  bool MapSamples(const interlume::ImplicitFlowArrays& arrays, vtkDataSet* input, double* values);
  /// Warns if all values are NaN.
  void WarnIfUndefined(
    const interlume::ImplicitFlowArrays& arrays, vtkIdType number, const double* values);
  /// Adds the field array of the far-side samples' Inflow, if there are far-side samples.
  void MapFarSide(const interlume::ImplicitFlowArrays& arrays, vtkDataSet* output);

  std::map<int, std::shared_ptr<interlume::InflowFunction>> Mappings;
  std::string PreparedError;
  vtkMTimeType PreparedTime = 0;
  // Names of the last input's arrays, and the smallest, middle and largest values of AdvectionTime,
  // if a formula contained t, and of the arrays in formulas.
  std::set<std::string> ArrayNames;
  std::optional<std::array<double, 3>> Times;
  std::map<std::string, std::array<double, 3>> ArrayLevels;
  // Evaluators used by Evaluate.
  std::map<const interlume::InflowFunction*, std::shared_ptr<interlume::InflowEvaluator>>
    Evaluators;
  vtkNew<vtkInterlumeReport> Report;
};

#endif
