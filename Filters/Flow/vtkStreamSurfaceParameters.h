// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkStreamSurfaceParameters_h
#define vtkStreamSurfaceParameters_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkInterlumeReport.h"  // for GetReport()
#include "vtkNew.h"              // for the report
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for what is asked

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
 * @brief   texture coordinates of stream surfaces: length along the inflow contour, and time
 *
 * A stream surface is made of the streamlines through a contour of the mapping, Phi_f(u,v) = c, on
 * a termination surface (C. Zhang, dissertation, Ohio State 2006, section 4.5.2). s is the arc
 * length along that contour, in world units, at the place of the contour that is nearest in
 * parameters to a point's TerminationUV; t is AdvectionTime. So lines of constant s are streamlines
 * and lines of constant t are timelines.
 *
 * **Contours** are followed on a grid of Resolution x Resolution squares in the parameters of each
 * termination surface in use: closed and open ones, several of a value, across the seams that the
 * mapping goes on over. Their points are exact within rounding, chords are measured between them
 * with vtkTerminationSurface::EvaluatePoint, so the length has an error of order
 * (size of a square)^2. Where EvaluatePoint has no answer a contour ends. s grows with higher
 * values of the mapping on the left in the plane of (u,v), from 0 at the contour's start.
 *
 * Input: triangles as port 1 of vtkFlowVolume, with the arrays of vtkFlowStatus and the cell array
 * `Inflow` with the value of each triangle. Output: vtkPolyData with the points of the input, with
 * their ids and arrays, and the triangles in the input's order. Triangles across the start of a
 * closed contour, where s jumps back to 0, have copies of points after those of the input, with s
 * beyond the contour's length, so that no triangle runs back through the whole length; so have
 * triangles whose corners are nearest to different contours, which take the contour of most.
 * Point arrays `StreamTexture` (double, 2 components s and t, the active texture coordinates),
 * `ContourId` (int; -1, and s = 0, without a contour, as where one is smaller than a square),
 * `vtkOriginalPointIds` (vtkIdType: the input's point). Field arrays, by ContourId: `ContourLength`
 * (double, world units, unscaled), `ContourClosed` (int).
 *
 * The output is the same for any number of threads. AdvectionTime is left as the active scalars.
 *
 * Warnings (vtkWarningMacro): an input without cells, but for pieces.
 *
 * Errors (vtkErrorMacro, empty output): no mapping; arrays that are missing; a TerminationId in use
 * without a surface; a surface that vtkTerminationSurface::Update finds wrong; cells that are not
 * triangles.
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
   * The mapping whose level sets the surfaces are. It is asked for values, not executed. Default
   * none.
   */
  void SetMapping(vtkInflowMapping* mapping);
  vtkInflowMapping* GetMapping() const;
  ///@}

  ///@{
  /**
   * The termination surfaces, with the TerminationId of their first part; -1 takes that from the
   * surface. Automatic ones are vtkImplicitFlowField::GetUsedSurfaceId. Where several have an id,
   * the first counts. Default none. Null adds nothing.
   */
  void AddTerminationSurface(vtkTerminationSurface* surface, int id = -1);
  void RemoveAllTerminationSurfaces();
  int GetNumberOfTerminationSurfaces() const { return static_cast<int>(this->Surfaces.size()); }
  vtkTerminationSurface* GetTerminationSurface(int i) const;
  ///@}

  ///@{
  /**
   * Places in world units where contours start: a closed one at its place nearest to any of them,
   * an open one at its end on the side of that place, running back where that is its last. Without
   * any place, a contour starts where following it begins. Default none.
   */
  void AddStartPoint(double x, double y, double z);
  void RemoveAllStartPoints();
  int GetNumberOfStartPoints() const { return static_cast<int>(this->StartPoints.size()); }
  ///@}

  ///@{
  /**
   * Factors of s and t in StreamTexture, such as one over the length and the time of a texture.
   * Default 1, 1.
   */
  vtkSetMacro(LengthScale, double);
  vtkGetMacro(LengthScale, double);
  vtkSetMacro(TimeScale, double);
  vtkGetMacro(TimeScale, double);
  ///@}

  ///@{
  /**
   * The number of squares along u and v. Default 256. Valid: 4 to 8192.
   */
  vtkSetClampMacro(Resolution, int, 4, 8192);
  vtkGetMacro(Resolution, int);
  ///@}

  /// Returns the time of the last change, of the mapping and the surfaces too.
  vtkMTimeType GetMTime() override;

  /**
   * Returns what the last execution did:
   * - Contours: contours of the inflow on the termination surfaces,
   * - ClosedContours: closed ones among them,
   * - AddedPoints: points that were added where parameters jump.
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

  /// Returns the surface that an id is a part of, and the part; null without a surface.
  vtkTerminationSurface* FindSurface(int id, int& part) const;
  /// Follows the contours of all levels in use. Returns an error if a surface is missing or cannot
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
