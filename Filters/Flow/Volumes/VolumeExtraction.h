// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_VolumeExtraction_h
#define interlume_VolumeExtraction_h

#include "Volumes/InterpolableCells.h"
#include "Volumes/SurfaceCuts.h"
#include "Volumes/SurfaceTriangles.h"

#include "vtkFlowVolumeSettings.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

class vtkDataSet;
class vtkIntArray;
class vtkIntervalVolume;
class vtkUnstructuredGrid;

namespace interlume
{

class ImplicitFlowArrays;
class SurfaceLevels;
struct FlowVolumeReport;

/**
 * @class   VolumeExtraction
 * @brief   the extractions of vtkFlowVolume and their cached results
 *
 * The first extraction, by Inflow, reads the field. The second one, by time, reads the result of
 * the first. Results of the last execution are reused if nothing they depend on has changed. The
 * kinds of the cells depend on the input and MaximumTimeJump; the first extraction depends on the
 * kinds and the levels of Inflow.
 */
class VolumeExtraction
{
public:
  /// The settings, and the data to which they apply.
  struct Request : vtkFlowVolumeSettings
  {
    explicit Request(const vtkFlowVolumeSettings& settings)
      : vtkFlowVolumeSettings(settings)
    {
    }

    vtkDataSet* Input = nullptr;
    ImplicitFlowArrays* Arrays = nullptr;
    /// Levels of Inflow and of time. Null disables the extraction by that function; at least one is
    /// not null.
    const SurfaceLevels* Inflow = nullptr;
    const SurfaceLevels* Time = nullptr;
    vtkAlgorithm* Owner = nullptr;
  };

  VolumeExtraction();
  ~VolumeExtraction();

  /// Executes the extractions. Returns false if the owner was aborted.
  bool Execute(const Request& request, FlowVolumeReport& report);

  ///@{
  /**
   * Return the results of the last execution: the tetrahedra, the SurfaceLevels item of each
   * tetrahedron (null if the extraction is disabled), and the triangles of the surfaces.
   */
  vtkUnstructuredGrid* GetMesh() const { return this->Mesh; }
  vtkIntArray* GetInflowItems() const { return this->InflowItems; }
  vtkIntArray* GetTimeItems() const { return this->TimeItems; }
  const SurfaceTriangles& GetStreamTriangles() const { return this->StreamTriangles; }
  const SurfaceTriangles& GetTimeTriangles() const { return this->TimeTriangles; }
  ///@}

  /// Name of the temporary cell array that passes the items of the first extraction to the second
  /// one.
  static const char* ItemArray() { return "vtkFlowVolumeItem"; }

private:
  /// Outputs of one extraction, with unwrapped parameters and cut cells.
  struct Result
  {
    vtkNew<vtkIntervalVolume> Filter;
    vtkSmartPointer<vtkUnstructuredGrid> Mesh;
    vtkSmartPointer<vtkUnstructuredGrid> Boundary;
    /// Triangles of cut cells, with point ids of Mesh.
    SurfaceTriangles CutTriangles;
    vtkMTimeType UpdateTime = 0;
    vtkIdType PointsOnSeams = 0;
  };

  bool Prepare(const Request& request, FlowVolumeReport& report);
  /// Runs one extraction. The progress of the owner advances from \a start to \a end. \a isFirst is
  /// true for the extraction from the input's cells, which also unwraps parameters and cuts cells.
  bool Run(const Request& request, Result& result, vtkDataSet* input, const SurfaceLevels& levels,
    bool isFirst, double start, double end, int& passes);

  /// Collects the surface triangles of one extraction. \a isFinal is true if no other extraction
  /// follows.
  static void CollectTriangles(
    Result& result, const SurfaceLevels& levels, bool isFinal, SurfaceTriangles& triangles);

  // The input with excluded cells hidden.
  vtkSmartPointer<vtkDataSet> Prepared;
  const vtkDataSet* PreparedInput = nullptr;
  vtkMTimeType PreparedTime = 0;
  double PreparedTimeJump = 0.0;
  InterpolableCells Cells;
  interlume::SurfaceCuts Cuts;
  vtkIdType NumberOfCutCells = 0;
  Result ByInflow;
  Result ByTime;
  // Input of the second extraction: the tetrahedra of the first extraction, without origin arrays.
  vtkSmartPointer<vtkUnstructuredGrid> Between;

  vtkSmartPointer<vtkUnstructuredGrid> Mesh;
  vtkSmartPointer<vtkIntArray> InflowItems;
  vtkSmartPointer<vtkIntArray> TimeItems;
  SurfaceTriangles StreamTriangles;
  SurfaceTriangles TimeTriangles;
};

}

#endif
