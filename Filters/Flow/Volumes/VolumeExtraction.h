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
 * @brief   the extractions of a vtkFlowVolume, and their results, kept between its executions
 *
 * The field is cut by Inflow first, and the result is cut by time. Nothing that has not changed
 * since the last execution is done again: the kinds of the cells depend on the input and the
 * largest jump of time, the first extraction on the levels of Inflow too.
 */
class VolumeExtraction
{
public:
  /// The settings, and what they are applied to.
  struct Request : vtkFlowVolumeSettings
  {
    explicit Request(const vtkFlowVolumeSettings& settings)
      : vtkFlowVolumeSettings(settings)
    {
    }

    vtkDataSet* Input = nullptr;
    ImplicitFlowArrays* Arrays = nullptr;
    /// The levels of Inflow and of time. Null stands for no extraction by that function; one of the
    /// two is not null.
    const SurfaceLevels* Inflow = nullptr;
    const SurfaceLevels* Time = nullptr;
    vtkAlgorithm* Owner = nullptr;
  };

  VolumeExtraction();
  ~VolumeExtraction();

  /// False when the owner was aborted.
  bool Execute(const Request& request, FlowVolumeReport& report);

  ///@{
  /**
   * The results of the last execution: the tetrahedra, with the items of the levels they belong to
   * (null without an extraction by them), and the triangles of surfaces.
   */
  vtkUnstructuredGrid* GetMesh() const { return this->Mesh; }
  vtkIntArray* GetInflowItems() const { return this->InflowItems; }
  vtkIntArray* GetTimeItems() const { return this->TimeItems; }
  const SurfaceTriangles& GetStreamTriangles() const { return this->StreamTriangles; }
  const SurfaceTriangles& GetTimeTriangles() const { return this->TimeTriangles; }
  ///@}

  /// The name of the cell array of the tetrahedra between the two extractions, which is not of the
  /// input.
  static const char* ItemArray() { return "InflowItem"; }

private:
  /// The outputs of one extraction, unwrapped and with cells that are cut.
  struct Result
  {
    vtkNew<vtkIntervalVolume> Filter;
    vtkSmartPointer<vtkUnstructuredGrid> Mesh;
    vtkSmartPointer<vtkUnstructuredGrid> Boundary;
    /// The triangles of cells that are cut, by the points of Mesh.
    SurfaceTriangles CutTriangles;
    vtkMTimeType UpdateTime = 0;
    vtkIdType PointsOnSeams = 0;
  };

  bool Prepare(const Request& request, FlowVolumeReport& report);
  /// One extraction; the progress of the owner goes from \a start to \a end. \a isFirst: it is
  /// that of the input's cells, with parameters to unwrap and cells to cut.
  bool Run(const Request& request, Result& result, vtkDataSet* input, const SurfaceLevels& levels,
    bool isFirst, double start, double end, int& passes);

  /// Takes the surfaces of one extraction; \a isFinal tells that no other extraction cuts them.
  static void TakeTriangles(
    Result& result, const SurfaceLevels& levels, bool isFinal, SurfaceTriangles& triangles);

  // The input without cells that are left out.
  vtkSmartPointer<vtkDataSet> Prepared;
  const vtkDataSet* PreparedInput = nullptr;
  vtkMTimeType PreparedTime = 0;
  double PreparedTimeJump = 0.0;
  InterpolableCells Cells;
  interlume::SurfaceCuts Cuts;
  vtkIdType NumberOfCutCells = 0;
  Result ByInflow;
  Result ByTime;
  // The tetrahedra that the second extraction starts from: those of the first one, without its
  // origins.
  vtkSmartPointer<vtkUnstructuredGrid> Between;

  vtkSmartPointer<vtkUnstructuredGrid> Mesh;
  vtkSmartPointer<vtkIntArray> InflowItems;
  vtkSmartPointer<vtkIntArray> TimeItems;
  SurfaceTriangles StreamTriangles;
  SurfaceTriangles TimeTriangles;
};

}

#endif
