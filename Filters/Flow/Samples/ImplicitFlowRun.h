// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ImplicitFlowRun_h
#define interlume_ImplicitFlowRun_h

#include "Advection/AdvectionOptions.h"
#include "Common/Error.h"
#include "Streams/FlowReport.h"

#include "vtkFlowStatus.h"
#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkDataSet;
class vtkUnstructuredGrid;

namespace interlume
{

class FlowCheckpoint;
class MeshLinks;
class DistributedField;
class SampleIntegration;
class Streamlines;
struct StageContext;

/**
 * @class   ImplicitFlowRun
 * @brief   executes vtkImplicitFlowField: advects all samples in parallel and fills their arrays
 */
class ImplicitFlowRun
{
public:
  /// If MaximumError, MinimumSpeed, MaximumTime or MaximumNumberOfSteps is 0 in the options, an
  /// automatic value replaces it.
  ImplicitFlowRun(
    vtkAlgorithm* owner, const AdvectionOptions& options, vtkDataSet* field, vtkDataArray* vectors);

  /// Sets the distributed field. The field and the vectors then belong to the partition of this
  /// process, and every process must execute.
  void SetDistributedField(DistributedField* ranks);

  /// Sets whether the input has hidden cells or points. Streamlines end there, and samples near the
  /// boundary of the reached region get far-side values.
  void SetHasHidden(bool hasHidden) { this->HasObstacles = hasHidden; }

  /// Refines no cells, but locates the boundary of the reached region even without hidden cells.
  void LocateBoundary()
  {
    this->Options.RefinementLevels = 0;
    this->LocatesBoundary = true;
  }

  /// Sets the checkpoint for finished streamlines; null for none.
  void SetCheckpoint(FlowCheckpoint* checkpoint) { this->Checkpoint = checkpoint; }

  /**
   * Advects the samples and adds their arrays. Returns an error if the field or an array of
   * MeanArrays cannot be used; an abort is not an error. Progress includes building the field.
   */
  Error Execute(vtkDataSet* samples);

  /// Returns the samples of all refinement levels; null if there are no levels, or after an error
  /// or an abort.
  vtkUnstructuredGrid* GetRefinedSamples() const { return this->Refined; }

  const FlowReport& GetReport() const { return this->Report; }
  /// Returns the number of samples for each vtkFlowStatus, without samples that refinement added.
  const std::array<vtkIdType, vtkFlowStatus::NUMBER_OF_VALUES>& GetInitialStatuses() const
  {
    return this->InitialStatuses;
  }

  /// Returns true if the execution was aborted in this or any other process.
  bool WasAborted() const { return this->Aborted; }

  /// Returns the mesh topology of an unstructured grid, which the caller caches for the next
  /// execution; null for other grids.
  const std::shared_ptr<const MeshLinks>& GetMesh() const { return this->Mesh; }

private:
  /// Replaces automatic values in the options. The automatic error and minimum speed are fractions
  /// of \a speed (SpeedScale).
  void ReplaceAutomaticValues(double speed);
  ///@{
  /// Build the field and advect all samples. ExecuteLocal requires that this process holds the
  /// complete field; ExecuteDistributed is for a distributed field.
  Error ExecuteLocal(const std::vector<vtkDataArray*>& means, vtkDataSet* samples);
  Error ExecuteDistributed(const std::vector<vtkDataArray*>& means, vtkDataSet* samples);
  ///@}
  /// Runs all stages, with the checkpoint if there is one.
  void RunStagesWithCheckpoint(Streamlines& streamlines, vtkDataSet* samples, int domainFaces);
  /// Runs the stages of StageContext in order.
  void RunStages(Streamlines& streamlines, vtkDataSet* samples, int domainFaces);
  /// Refines the samples by all levels. Returns false if the execution was aborted.
  bool Refine(StageContext& context, SampleIntegration& integration,
    vtkSmartPointer<vtkUnstructuredGrid>& grid);
  /// Adds the arrays LocalSpeed and LocalVorticity to the samples.
  static void AddLocalAttributes(Streamlines& streamlines, vtkDataSet* samples);
  /// Sets the values of the report that describe the field.
  template <typename FieldType>
  void Describe(const FieldType& field);
  /// Returns the length of the diagonal of the field's bounds.
  double GetFieldLength() const;
  Error FindArrays(std::vector<vtkDataArray*>& means) const;
  void AddSurfacesArray(vtkDataSet* samples, int domainFaces) const;

  vtkAlgorithm* Owner;
  AdvectionOptions Options;
  // The field, or DistributedField::GetFullGrid() if the field is distributed.
  vtkDataSet* Field;
  // The data of the field in this process.
  vtkDataSet* Data;
  vtkDataArray* Vectors;
  DistributedField* Ranks = nullptr;
  FlowCheckpoint* Checkpoint = nullptr;
  vtkSmartPointer<vtkUnstructuredGrid> Refined;
  FlowReport Report;
  bool Aborted = false;
  /// True if streamlines end inside the field, at hidden cells or at vectors that are not finite.
  bool HasObstacles = false;
  bool LocatesBoundary = false;
  std::array<vtkIdType, vtkFlowStatus::NUMBER_OF_VALUES> InitialStatuses{};
  std::shared_ptr<const MeshLinks> Mesh;
};

}

#endif
