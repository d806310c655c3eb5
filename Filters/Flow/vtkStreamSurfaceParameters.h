// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkStreamSurfaceParameters_h
#define vtkStreamSurfaceParameters_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkInterlumeReport.h"  // for GetReport()
#include "vtkNew.h"              // for the report
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the mapping and the surfaces

#include <array>
#include <vector>

class vtkDataArray;
class vtkInflowMapping;
class vtkTerminationSurface;

namespace interlume
{
class Error;
class StreamSurfaceTriangles;
}

/**
 * @class   vtkStreamSurfaceParameters
 * @brief   compute texture coordinates of stream surfaces: length along the inflow contour, and
 * time
 *
 * A stream surface consists of the streamlines through a contour on a termination surface, where
 * the mapping Phi_f(u,v) of a vtkInflowMapping has a constant value. The coordinate s of a point is
 * the arc length along that contour, in world units, at the contour position nearest to the point's
 * TerminationUV. The coordinate t is AdvectionTime. Lines of constant s are streamlines, and lines
 * of constant t are timelines.
 * Documentation/methods/flow-volumes.md explains the contours and their accuracy.
 *
 * Contours are traced on a grid of Resolution x Resolution squares in the parameters of each
 * termination surface in use. They may be open or closed, there may be several per value, and they
 * continue across seams where the mapping is continuous. A contour ends where
 * vtkTerminationSurface::EvaluatePoint returns false. s increases from 0 at the start of the
 * contour, with higher values of the mapping on the left in the (u,v) plane, unless a start point
 * reverses the contour.
 *
 * Input: triangles as on port 1 of vtkFlowVolume, with the arrays of vtkFlowStatus and the cell
 * array `Inflow` with the value of each triangle.
 *
 * Output: vtkPolyData with the points of the input, their ids and arrays, and the triangles in the
 * order of the input. Copies of points are appended for two kinds of triangles: those across the
 * start of a closed contour, where s continues past the contour's length, and those whose corners
 * are nearest to different contours. The latter use the contour of the majority of the corners.
 * Point arrays:
 * - `StreamTexture` (double, 2 components: s and t), the active texture coordinates,
 * - `ContourId` (int); -1, with s = 0, if the contour was not found because it is smaller than a
 *   grid square,
 * - `vtkOriginalPointIds` (vtkIdType): the point of the input.
 *
 * Field arrays by ContourId: `ContourLength` (double, world units, unscaled), `ContourClosed`
 * (int). AdvectionTime becomes the active scalars. The output is identical for any number of
 * threads.
 *
 * Warnings (vtkWarningMacro, not if one of several pieces is requested): an input without cells.
 *
 * Errors (vtkErrorMacro, empty output): no mapping; missing arrays; a TerminationId in use without
 * a surface; a surface rejected by vtkTerminationSurface::Update; cells that are not triangles.
 *
 * @sa vtkFlowVolume vtkInflowMapping vtkTerminationSurface
 */
class INTERLUMEFLOW_EXPORT vtkStreamSurfaceParameters : public vtkPolyDataAlgorithm
{
public:
  static vtkStreamSurfaceParameters* New();
  vtkTypeMacro(vtkStreamSurfaceParameters, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Mapping whose level sets are the stream surfaces. The filter evaluates it, but does not execute
   * it. Default: none.
   */
  void SetMapping(vtkInflowMapping* mapping);
  vtkInflowMapping* GetMapping() const;
  ///@}

  ///@{
  /**
   * Termination surfaces, with the TerminationId of their first part; -1 uses the id of the
   * surface. For automatic ids, pass vtkImplicitFlowField::GetUsedSurfaceId. If several surfaces
   * have the same id, the first one counts. Default: none. A null surface is ignored.
   */
  void AddTerminationSurface(vtkTerminationSurface* surface, int id = -1);
  void RemoveAllTerminationSurfaces();
  int GetNumberOfTerminationSurfaces() const { return static_cast<int>(this->Surfaces.size()); }
  vtkTerminationSurface* GetTerminationSurface(int i) const;
  ///@}

  ///@{
  /**
   * Points in world units near which contours start. A closed contour starts at its position that
   * is nearest to any start point. An open contour starts at the end that is closer, along the
   * contour, to this position; it is reversed if this is its last point. If there are no start
   * points, the start is arbitrary. Default: none.
   */
  void AddStartPoint(double x, double y, double z);
  void RemoveAllStartPoints();
  int GetNumberOfStartPoints() const { return static_cast<int>(this->StartPoints.size()); }
  ///@}

  ///@{
  /**
   * Factors by which s and t are multiplied in StreamTexture, such as the reciprocals of a
   * texture's length and duration. Default: 1, 1.
   */
  vtkSetMacro(LengthScale, double);
  vtkGetMacro(LengthScale, double);
  vtkSetMacro(TimeScale, double);
  vtkGetMacro(TimeScale, double);
  ///@}

  ///@{
  /**
   * Number of grid squares along each of u and v. Default: 256. Valid: 4 to 8192; clamped.
   */
  vtkSetClampMacro(Resolution, int, 4, 8192);
  vtkGetMacro(Resolution, int);
  ///@}

  /// Return the modification time, including that of the mapping and the surfaces.
  vtkMTimeType GetMTime() override;

  /**
   * Return the report of the last execution:
   * - Contours: contours on the termination surfaces,
   * - ClosedContours: closed contours among them,
   * - AddedPoints: copies of points added where s jumps.
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

protected:
  vtkStreamSurfaceParameters();
  ~vtkStreamSurfaceParameters() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkStreamSurfaceParameters(const vtkStreamSurfaceParameters&) = delete;
  void operator=(const vtkStreamSurfaceParameters&) = delete;

  struct Surface
  {
    vtkSmartPointer<vtkTerminationSurface> Shape;
    int Id;
  };

  /// Returns the surface to which an id belongs, and sets \a part to the index of the part with
  /// this id. Returns null if no surface has the id.
  vtkTerminationSurface* FindSurface(int id, int& part) const;
  /// Traces the contours of all levels in use. Returns an error if a surface is missing or cannot
  /// be used.
  interlume::Error FindContours(interlume::StreamSurfaceTriangles& work) const;
  void FillTexture(const std::vector<double>& lengths, const std::vector<vtkIdType>& sources,
    vtkDataArray* times, vtkPolyData* output) const;

  vtkSmartPointer<vtkInflowMapping> Mapping;
  std::vector<Surface> Surfaces;
  std::vector<std::array<double, 3>> StartPoints;
  double LengthScale = 1.0;
  double TimeScale = 1.0;
  int Resolution = 256;
  vtkNew<vtkInterlumeReport> Report;
};

#endif
