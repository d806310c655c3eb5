// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTerminationMesh_h
#define vtkTerminationMesh_h

#include "vtkSmartPointer.h" // for the dataset
#include "vtkTerminationSurface.h"

#include <memory>

class vtkPolyData;

/**
 * @class   vtkTerminationMesh
 * @brief   any surface of triangles with texture coordinates as parameters
 *
 * The surface consists of polygons and strips of a dataset, closed or open; polygons are cut into
 * triangles. (u,v) are the active texture coordinates of the points (two components, meant to be
 * from 0 to 1), interpolated in the triangle that holds the nearest point. Points in the same place
 * are one, so that a seam of the texture with points on both sides is no border.
 *
 * Triangles that share an edge are turned to agree; closed parts outward, open ones to how most of
 * their triangles are. The distance is that from the nearest triangle, its sign by angle-weighted
 * normals (J. A. Baerentzen and H. Aanaes, "Signed distance computation using the angle weighted
 * pseudonormal", IEEE TVCG 11(3), 2005), which are right at edges and vertices too; it is negative
 * inside a closed mesh. The sign jumps where an open mesh ends, halfway between parts that face the
 * same way, and may be wrong at edges of three and more triangles (GetNumberOfBranchingEdges). IsOn
 * is false at such jumps: it asks for a nearest point within 1e-6 of the mesh's diagonal, and for
 * one that is not beyond a border. The normal at an edge or a vertex is the angle-weighted one.
 *
 * A mesh of a field's own faces has triangles where the faces of cells are bilinear: which of both
 * a streamline meets first is left to vtkImplicitFlowField::SetArrivalTolerance, not to Tolerance.
 *
 * Update reports: no dataset, no triangle with an area, no texture coordinates or not two of them,
 * points or texture coordinates that are not finite, points that are not there, and a mesh that has
 * one side only. Triangles lower than Tolerance are left out and counted.
 */
class INTERLUMEFLOW_EXPORT vtkTerminationMesh : public vtkTerminationSurface
{
public:
  static vtkTerminationMesh* New();
  vtkTypeMacro(vtkTerminationMesh, vtkTerminationSurface);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The mesh of the surface. Update reads it, and does not change it. Default null.
   */
  void SetMesh(vtkPolyData* mesh);
  vtkPolyData* GetMesh() const;
  ///@}

  ///@{
  /**
   * Whether u, or v, goes around, so that 0 and 1 are the same place. Triangles then may cross the
   * seam: their coordinates are taken within a half of each other. Default off.
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
   * The tolerance, as a part of the diagonal of the mesh's bounds: points nearer to each other are
   * one, lower triangles are left out, and open borders are wider by it. Default 1e-9. Valid: 1e-15
   * to 0.1, clamped; NaN is ignored.
   */
  void SetTolerance(double tolerance);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * The numbers of triangles and edges that Update found. A mesh is closed when it has neither
   * border nor branching edges.
   */
  vtkIdType GetNumberOfTriangles() const;
  vtkIdType GetNumberOfDegenerateTriangles() const;
  vtkIdType GetNumberOfBorderEdges() const;
  vtkIdType GetNumberOfBranchingEdges() const;
  ///@}

  std::string Update() override;
  double EvaluateDistance(const double x[3]) const override;
  bool IsOn(const double x[3]) const override;
  bool IsBeside(const double x[3]) const override;
  void EvaluateParameters(const double x[3], double uv[2]) const override;
  void EvaluateNormal(const double x[3], double normal[3]) const override;
  bool EvaluatePoint(int part, const double uv[2], double x[3]) const override;
  double EvaluateGap(const double x[3]) const override;
  bool IsPeriodic(int direction, int part = 0) const override;
  void GetBounds(double bounds[6]) const override;

  /// Returns the time of the last change, of the mesh too.
  vtkMTimeType GetMTime() override;

protected:
  vtkTerminationMesh();
  ~vtkTerminationMesh() override;

private:
  vtkTerminationMesh(const vtkTerminationMesh&) = delete;
  void operator=(const vtkTerminationMesh&) = delete;

  /// The data that Update makes; empty after an error.
  struct Contents;
  std::unique_ptr<Contents> Made;
  vtkTimeStamp UpdateTime;

  vtkSmartPointer<vtkPolyData> Mesh;
  bool PeriodicU = false;
  bool PeriodicV = false;
  double Tolerance = 1e-9;
};

#endif
