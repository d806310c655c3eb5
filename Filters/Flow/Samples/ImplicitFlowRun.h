// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ImplicitFlowRun_h
#define interlume_ImplicitFlowRun_h

#include "Advection/AdvectionOptions.h"

#include "vtkFlowReport.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkDataSet;
class vtkUnstructuredGrid;

namespace interlume
{

class TerminationSides;

/**
 * @class   ImplicitFlowRun
 * @brief   one execution of vtkImplicitFlowField: all samples, by threads, and their arrays
 */
class ImplicitFlowRun
{
public:
  ImplicitFlowRun(vtkAlgorithm* owner, const AdvectionOptions& options);

  /// Sets the field, its vectors, and the names of the arrays that have a mean.
  void SetField(vtkDataSet* field, vtkDataArray* vectors, const std::vector<std::string>& means);
  /// Sets error and minimum speed in parts of the field's speed (SpeedScale); 0 stands for those of
  /// the options.
  void SetAutomatic(double error, double speed);
  void SetKeepSteps(bool keep) { this->KeepSteps = keep; }

  /// Sets how often mixed cells are refined.
  void SetRefinementLevels(int levels) { this->RefinementLevels = levels; }

  /**
   * Adds the arrays to \a samples. Returns what is wrong, or nothing, as after an abort. The first
   * part of the progress is building the field.
   */
  std::string Execute(vtkDataSet* samples);

  /// Returns the samples with those of all levels; null without levels, and after an error or an
  /// abort.
  vtkUnstructuredGrid* GetRefined() const { return this->Refined; }

  const vtkFlowReport& GetReport() const { return this->Report; }

private:
  struct Arrays;
  /// Follows all samples, and those of the levels of refinement.
  template <typename Walker>
  void FollowAll(const Walker& walker, vtkDataSet* samples);
  /// Fills the part of the report that describes the field.
  template <typename FieldType>
  void Describe(const FieldType& field);
  /// Follows the samples from \a first on. Returns false when the owner was aborted.
  template <typename Walker>
  bool Follow(
    const Walker& walker, vtkDataSet* samples, vtkIdType first, int level, TerminationSides& sides);
  /// Finds on which side of their surface samples are, after all samples of \a sides were followed.
  template <typename Walker>
  static void FindSides(
    const Walker& walker, vtkDataSet* samples, const TerminationSides& sides, Arrays& arrays);
  /// Finds what samples beside surfaces would have on the other side, after their sides were found.
  template <typename Walker>
  void FindBeyond(const Walker& walker, vtkDataSet* samples) const;
  std::string FindArrays(std::vector<vtkDataArray*>& means) const;
  void AddSurfaces(vtkDataSet* samples, int domainFaces) const;

  vtkAlgorithm* Owner;
  AdvectionOptions Options;
  vtkDataSet* Field = nullptr;
  vtkDataArray* Vectors = nullptr;
  std::vector<std::string> Means;
  double AutomaticError = 0.0;
  double AutomaticSpeed = 0.0;
  bool KeepSteps = false;
  int RefinementLevels = 0;
  vtkSmartPointer<vtkUnstructuredGrid> Refined;
  vtkFlowReport Report;
};

}

#endif
