// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ImplicitFlowRun_h
#define interlume_ImplicitFlowRun_h

#include "Advection/AdvectionOptions.h"
#include "Common/Error.h"
#include "Streams/FlowReport.h"

#include "vtkSmartPointer.h"

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
class RankField;
class Streamlines;

/**
 * @class   ImplicitFlowRun
 * @brief   one execution of vtkImplicitFlowField: all samples, by threads, and their arrays
 */
class ImplicitFlowRun
{
public:
  /// The options' error, speed, time and number of steps are automatic where they are 0.
  ImplicitFlowRun(
    vtkAlgorithm* owner, const AdvectionOptions& options, vtkDataSet* field, vtkDataArray* vectors);

  /// Sets the processes' parts of the field, of which this one has the vectors' and no more. Every
  /// process is to execute.
  void SetRanks(RankField* ranks);

  /// Sets whether the input has hidden cells or points. Streamlines end there, and cells of samples
  /// beside the boundary of what reaches a surface get what they are cut by.
  void SetHidden(bool hasHidden) { this->HasObstacles = hasHidden; }

  /// Sets where finished streamlines are kept, and taken from; null: nowhere.
  void SetCheckpoint(FlowCheckpoint* checkpoint) { this->Checkpoint = checkpoint; }

  /**
   * Adds the arrays to \a samples. Returns an error if the field or the arrays of means cannot be
   * used; an abort is no error. The first part of the progress is building the field.
   */
  Error Execute(vtkDataSet* samples);

  /// Returns the samples with those of all levels; null without levels, and after an error or an
  /// abort.
  vtkUnstructuredGrid* GetRefined() const { return this->Refined; }

  const FlowReport& GetReport() const { return this->Report; }

  /// Returns whether the execution was aborted, in this or any process.
  bool WasAborted() const { return this->Aborted; }

  /// Returns what was found of the mesh of an unstructured grid, to be kept until the next
  /// execution; null for others.
  const std::shared_ptr<const MeshLinks>& GetMesh() const { return this->Mesh; }

private:
  /// Replaces what is automatic in the options; error and speed are parts of the field's speed
  /// (SpeedScale).
  void ReplaceAutomatic(double speed);
  ///@{
  /// Builds the field and follows all samples: where the process has all of the field, and where
  /// processes have parts.
  Error ExecuteAlone(const std::vector<vtkDataArray*>& means, vtkDataSet* samples);
  Error ExecuteInRanks(const std::vector<vtkDataArray*>& means, vtkDataSet* samples);
  ///@}
  /// Follows all samples, and those of the levels of refinement, with the checkpoint if there is
  /// one.
  void FollowAll(Streamlines& streamlines, vtkDataSet* samples, int domainFaces);
  /// Runs the stages of StageContext in their order.
  void RunStages(Streamlines& streamlines, vtkDataSet* samples, int domainFaces);
  vtkSmartPointer<vtkUnstructuredGrid> Refine(vtkUnstructuredGrid* grid);
  /// Fills the part of the report that describes the field.
  template <typename FieldType>
  void Describe(const FieldType& field);
  /// Returns the diagonal of the field's bounds.
  double GetFieldLength() const;
  Error FindArrays(std::vector<vtkDataArray*>& means) const;
  void AddSurfaces(vtkDataSet* samples, int domainFaces) const;

  vtkAlgorithm* Owner;
  AdvectionOptions Options;
  // The whole field, perhaps without arrays, and the data that the process has of it.
  vtkDataSet* Field;
  vtkDataSet* Data;
  vtkDataArray* Vectors;
  RankField* Ranks = nullptr;
  FlowCheckpoint* Checkpoint = nullptr;
  vtkSmartPointer<vtkUnstructuredGrid> Refined;
  FlowReport Report;
  bool Aborted = false;
  /// Whether streamlines end within the field at hidden cells, or at vectors that are not finite.
  bool HasObstacles = false;
  std::shared_ptr<const MeshLinks> Mesh;
};

}

#endif
