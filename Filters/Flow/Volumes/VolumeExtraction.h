#ifndef interlume_VolumeExtraction_h
#define interlume_VolumeExtraction_h

#include "Volumes/InterpolableCells.h"
#include "Volumes/SurfaceCuts.h"
#include "Volumes/SurfaceTriangles.h"

#include "vtkFlowVolumeReport.h"
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

/**
 * @class   VolumeExtraction
 * @brief   the extractions of a vtkFlowVolume, and what they leave between its executions
 *
 * The field is cut by Inflow first, what is left by time. Whatever has not changed since the last
 * execution is not done again: the kinds of the cells depend on the input and the largest jump of
 * time, the first extraction on the levels of Inflow too.
 */
class VolumeExtraction
{
public:
  struct Request
  {
    vtkDataSet* Input = nullptr;
    ImplicitFlowArrays* Arrays = nullptr;
    /// Null: no extraction by it. One of the two is there.
    const SurfaceLevels* Inflow = nullptr;
    const SurfaceLevels* Time = nullptr;
    bool GenerateStreamSurfaces = false;
    bool GenerateTimeSurfaces = false;
    int Precision = 0;
    double MaximumTimeJump = VTK_DOUBLE_MAX;
    vtkAlgorithm* Owner = nullptr;
  };

  VolumeExtraction();
  ~VolumeExtraction();

  /// False when the owner was aborted.
  bool Execute(const Request& request, vtkFlowVolumeReport& report);

  ///@{
  /**
   * Of the last execution: the tetrahedra, with the items of the levels they belong to (null
   * without an extraction by them), and the triangles of surfaces.
   */
  vtkUnstructuredGrid* GetMesh() const { return this->Mesh; }
  vtkIntArray* GetInflowItems() const { return this->InflowItems; }
  vtkIntArray* GetTimeItems() const { return this->TimeItems; }
  const SurfaceTriangles& GetStreamTriangles() const { return this->StreamTriangles; }
  const SurfaceTriangles& GetTimeTriangles() const { return this->TimeTriangles; }
  ///@}

  /// Cell array of the tetrahedra between the two, not of the input's.
  static const char* ItemArray() { return "InflowItem"; }

private:
  /// The outputs of one extraction, unwrapped and with cells that are cut.
  struct Result
  {
    vtkNew<vtkIntervalVolume> Filter;
    vtkSmartPointer<vtkUnstructuredGrid> Mesh;
    vtkSmartPointer<vtkUnstructuredGrid> Boundary;
    /// Of cells that are cut, by the points of Mesh.
    SurfaceTriangles CutTriangles;
    vtkMTimeType UpdateTime = 0;
    vtkIdType PointsOnSeams = 0;
  };

  bool Prepare(const Request& request, vtkFlowVolumeReport& report);
  /// One extraction; the progress of the owner goes from \a start to \a end. \a isFirst: it is
  /// that of the input's cells, with parameters to unwrap and cells to cut.
  bool Run(const Request& request, Result& result, vtkDataSet* input, const SurfaceLevels& levels,
    bool isFirst, double start, double end, int& passes);

  /// The surfaces of one extraction; \a isFinal: they are not cut by another.
  static void TakeTriangles(
    Result& result, const SurfaceLevels& levels, bool isFinal, SurfaceTriangles& triangles);

  // The input without cells that are left out.
  vtkSmartPointer<vtkDataSet> Prepared;
  const vtkDataSet* PreparedInput = nullptr;
  vtkMTimeType PreparedTime = 0;
  double PreparedTimeJump = VTK_DOUBLE_MAX;
  InterpolableCells Cells;
  interlume::SurfaceCuts Cuts;
  vtkIdType NumberOfCutCells = 0;
  Result ByInflow;
  Result ByTime;
  // What the second extraction starts from: the first one's tetrahedra, without its origins.
  vtkSmartPointer<vtkUnstructuredGrid> Between;

  vtkSmartPointer<vtkUnstructuredGrid> Mesh;
  vtkSmartPointer<vtkIntArray> InflowItems;
  vtkSmartPointer<vtkIntArray> TimeItems;
  SurfaceTriangles StreamTriangles;
  SurfaceTriangles TimeTriangles;
};

}

#endif
