// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTerminationMesh_h
#define vtkTerminationMesh_h

#include "vtkSmartPointer.h" // for the dataset
#include "vtkTerminationSurface.h"

#include <memory>

class vtkPolyData;

/**
 * @class   vtkTerminationMesh
 * @brief   triangle mesh with texture coordinates as a termination surface
 *
 * The surface consists of the polygons and strips of a dataset, triangulated; it may be open or
 * closed. (u,v) are the active texture coordinates of the points (two components, usually from 0 to
 * 1), interpolated in the triangle that contains the nearest point. Points at the same position are
 * merged, so a texture seam with duplicated points is not a boundary.
 *
 * Triangles are oriented consistently: outward in a closed component, and like the majority of the
 * triangles in an open component. The distance is measured from the nearest triangle. Its sign
 * comes from angle-weighted pseudonormals (J. A. Baerentzen and H. Aanaes, "Signed distance
 * computation using the angle weighted pseudonormal", IEEE TVCG 11(3), 2005), which are correct at
 * edges and vertices too. The distance is negative inside a closed mesh. EvaluateNormal returns the
 * pseudonormal at an edge or a vertex.
 *
 * The sign jumps past the boundary of an open mesh, and halfway between components that face the
 * same way. It may be wrong at edges shared by three or more triangles (GetNumberOfBranchingEdges).
 * IsOn returns false at such jumps: the distance to the nearest point of the mesh must be at most
 * 1e-6 of the mesh diagonal, and the position must not be past a boundary edge.
 *
 * If the mesh is a triangulation of cell faces of the field, it deviates from the bilinear faces of
 * the cells. vtkImplicitFlowField::SetArrivalTolerance, not Tolerance, allows for this deviation.
 *
 * Update reports a missing mesh, a mesh whose triangles all have zero area, texture coordinates
 * that are missing or do not have two components, points or texture coordinates that are not
 * finite, invalid point ids, and a mesh that is not orientable. Triangles with a height below
 * Tolerance are skipped; GetNumberOfDegenerateTriangles returns their number.
 */
class INTERLUMEFLOW_EXPORT vtkTerminationMesh : public vtkTerminationSurface
{
public:
  static vtkTerminationMesh* New();
  vtkTypeMacro(vtkTerminationMesh, vtkTerminationSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Mesh of the surface. Update reads it without changing it. Default: null.
   */
  void SetMesh(vtkPolyData* mesh);
  vtkPolyData* GetMesh() const;
  ///@}

  ///@{
  /**
   * If true, u (or v) is periodic: 0 and 1 are the same position. Triangles may then cross the
   * seam: the texture coordinates of a triangle are shifted by whole periods to within half a
   * period of its first corner. Default: off.
   */
  vtkSetMacro(PeriodicU, bool);
  vtkGetMacro(PeriodicU, bool);
  vtkBooleanMacro(PeriodicU, bool);
  vtkSetMacro(PeriodicV, bool);
  vtkGetMacro(PeriodicV, bool);
  vtkBooleanMacro(PeriodicV, bool);
  ///@}

  ///@{
  /**
   * Tolerance as a fraction of the diagonal of the mesh's bounds. Points within this distance are
   * merged, triangles of smaller height are skipped, and open boundaries are extended by this
   * distance. Default: 1e-9. Valid: 1e-15 to 0.1; clamped. NaN is ignored.
   */
  void SetTolerance(double tolerance);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Numbers of triangles and edges that Update found. A mesh is closed if it has neither boundary
   * edges nor branching edges, which are shared by three or more triangles.
   */
  vtkIdType GetNumberOfTriangles() const;
  vtkIdType GetNumberOfDegenerateTriangles() const;
  vtkIdType GetNumberOfBorderEdges() const;
  vtkIdType GetNumberOfBranchingEdges() const;
  ///@}

  std::string Update() override;
  double EvaluateDistance(const double x[3]) const override;
  bool IsOn(const double x[3]) const override;
  bool ProjectsOntoSurface(const double x[3]) const override;
  void EvaluateParameters(const double x[3], double uv[2]) const override;
  void EvaluateNormal(const double x[3], double normal[3]) const override;
  bool EvaluatePoint(int part, const double uv[2], double x[3]) const override;
  double EvaluateGap(const double x[3]) const override;
  bool IsPeriodic(int direction, int part = 0) const override;
  void GetBounds(double bounds[6]) const override;

  /// Return the modification time, including that of the mesh.
  vtkMTimeType GetMTime() override;

protected:
  vtkTerminationMesh();
  ~vtkTerminationMesh() override;

private:
  vtkTerminationMesh(const vtkTerminationMesh&) = delete;
  void operator=(const vtkTerminationMesh&) = delete;

  /// Results of Update; empty after an error.
  struct Contents;
  std::unique_ptr<Contents> Prepared;
  vtkTimeStamp UpdateTime;

  vtkSmartPointer<vtkPolyData> Mesh;
  bool PeriodicU = false;
  bool PeriodicV = false;
  double Tolerance = 1e-9;
};

#endif
