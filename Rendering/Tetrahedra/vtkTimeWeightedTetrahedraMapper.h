// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTimeWeightedTetrahedraMapper_h
#define vtkTimeWeightedTetrahedraMapper_h

#include "InterlumeTetrahedraModule.h" // for the export macro
#include "vtkInterlumeReport.h"        // for GetReport()
#include "vtkNew.h"
#include "vtkSmartPointer.h" // for the boundary's property and texture
#include "vtkUnstructuredGridVolumeMapper.h"

#include <map>    // for the priorities
#include <memory> // for the private classes
#include <string> // for array names
#include <vector> // for lists of ids

class vtkMultiProcessController;
class vtkPolyData;
class vtkProperty;
class vtkRenderWindow;
class vtkTexture;
class vtkUnstructuredGrid;

namespace interlume
{
class Error;
class PeelingDeferral;
class PieceExchange;
class TetrahedraRenderer;
struct TetrahedraArrays;
}

/**
 * @class   vtkTimeWeightedTetrahedraMapper
 * @brief   render tetrahedra as a volume, weighted by their extent in time
 *
 * Draws the projection of each tetrahedron (projected tetrahedra; P. Shirley, A. Tuchman 1990), on
 * the GPU or on the CPU. Along a view ray, extinction, color and the extent in time Dt are linear
 * within each tetrahedron. The optical depth is the integral of extinction times Dt (C. Zhang,
 * dissertation, Ohio State 2006, 3.5.4), and color and opacity follow from it by exact integration.
 * See Documentation/methods/projected-tetrahedra.md for the method, sorting and accuracy, and
 * Documentation/measurements.md for render times.
 *
 * **Input**: port 0 is a vtkUnstructuredGrid of VTK_TETRA cells. Port 1 is optional and takes
 * boundary triangles (see SetBoundaryConnection). ScalarMode, ArrayName and ArrayId select the
 * scalars, as in other volume mappers. The scalars have one of these forms:
 * - one component at points: color and opacity functions of the interpolated scalar;
 * - one component at cells, such as `IntervalId`: one color and opacity for each tetrahedron;
 * - several independent components: the component or magnitude that the vector mode of the color
 *   function selects;
 * - two dependent components: color by the first, opacity by the second;
 * - three or four dependent components: color as RGB (unsigned char 0 to 255, other types 0 to 1),
 *   opacity by the fourth component or, if there are three, by their mean.
 *
 * Extinction per unit length is the value of the scalar opacity function divided by
 * ScalarOpacityUnitDistance. It may exceed 1, as in VTK's mappers for unstructured grids.
 *
 * **Accuracy**: SOFTWARE_PATH computes every pixel in visibility order, even if tetrahedra are seen
 * edge-on or points coincide on the screen. With OPENGL_PATH, the GPU rounds vertices to a fraction
 * of a pixel, so tetrahedra or whole meshes that are thinner than this fraction on the screen may
 * be drawn too wide or missed.
 *
 * **Other props**: opaque props hide the parts of the volume behind them. Translucent polygons are
 * always drawn behind the volume, except the boundary triangles of port 1.
 * UseDepthPeelingForVolumes is ignored with a warning.
 *
 * **Selection**: vtkHardwareSelector returns the tetrahedron seen at each pixel. Up to this
 * tetrahedron, the opacity along the view ray grows to half of the pixel's opacity, so one half of
 * what the pixel shows is in front and the other half behind. A pixel without opacity shows none.
 * If points are selected, the closest corner of this tetrahedron is returned at pixels up to 3
 * pixels from it. Selection always uses the whole mesh and the CPU. With several processes, each
 * process finds the tetrahedra seen in its partition.
 *
 * **Cameras and clipping**: all projections of vtkCamera are supported, including stereo, view
 * shear, off-axis projection and user transforms. Tetrahedra are cut exactly at the near plane, at
 * the far plane and at any number of clipping planes (AddClippingPlane).
 *
 * **Parallel rendering**: after GatherPieces, each process draws its partition with SOFTWARE_PATH,
 * and the processes exchange floating-point sums. Each pixel is shown by one process: the process
 * with the closest opaque surface, or the first process if there is no surface. The result is the
 * same as with a single process, up to rounding error, and does not change if the processes' images
 * are then composited. COMPOSITE_BLEND also requires input without Dt, SOFTWARE_PATH in all
 * processes, and bounding boxes that axis-aligned planes can separate. Otherwise each process draws
 * only its partition, and a compositor must blend the 8-bit images in visibility order.
 *
 * **Errors** (vtkErrorMacro, nothing is drawn): cells other than tetrahedra, missing scalars, a
 * missing array for Dt that was set by name, a missing array of layers in PRIORITY_BLEND, a wrong
 * number of components or tuples, an invalid clipping plane, a singular camera or volume matrix.
 * Tetrahedra with NaN or infinity are skipped and counted in GetReport().
 *
 * @sa vtkIntervalVolume vtkTimeVaryingIntervalVolume vtkTemporalColorTransferFunction
 */
class INTERLUMETETRAHEDRA_EXPORT vtkTimeWeightedTetrahedraMapper
  : public vtkUnstructuredGridVolumeMapper
{
public:
  static vtkTimeWeightedTetrahedraMapper* New();
  vtkTypeMacro(vtkTimeWeightedTetrahedraMapper, vtkUnstructuredGridVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Blend modes, which combine the segments of a view ray.
   */
  enum BlendModes
  {
    // COMPOSITE_BLEND = 0 of the superclass: front to back in visibility order.
    // MAXIMUM_INTENSITY_BLEND = 1 of the superclass: color and opacity of the largest scalar.

    /// Sum of color times opacity, clamped to 1. Does not depend on the order of tetrahedra.
    ADDITIVE_BLEND = 2,
    /// OPTICAL_DEPTH_BLEND within each layer. Layers are composited by priority, independent of
    /// depth.
    PRIORITY_BLEND = 3,
    /// Opacity 1 - exp(-sum of optical depths), and the mean color weighted by optical depth. Does
    /// not depend on the order of tetrahedra. Exact if there is a single color.
    OPTICAL_DEPTH_BLEND = 4,
    /// OPTICAL_DEPTH_BLEND if the input has Dt, because tetrahedra with an extent in time overlap
    /// and have no visibility order. Otherwise COMPOSITE_BLEND.
    AUTOMATIC_BLEND = 5
  };

  /**
   * Integration modes for the color and opacity of one segment.
   */
  enum IntegrationModes
  {
    /// Mean of the colors and extinctions at both ends of the segment, as in the original algorithm
    /// of P. Shirley and A. Tuchman.
    AVERAGE_COLOR = 0,
    /// Exact integral, with color and extinction that are linear between the control points of the
    /// transfer functions (K. Moreland, E. Angel, "A fast high accuracy volume renderer for
    /// unstructured data", 2004).
    LINEAR_SEGMENT = 1
  };

  /**
   * Sort modes, which determine the order in which tetrahedra are drawn.
   */
  enum SortModes
  {
    NO_SORT = 0,
    /// By distance from the centroid to the camera, or by depth in parallel projection.
    /// Approximate.
    CENTROID_SORT = 1,
    /// Visibility order across shared faces (P. Williams, "Visibility-ordering meshed polyhedra",
    /// 1992) and across the gaps of nonconvex meshes.
    MPVONC_SORT = 2,
    /// NO_SORT if the image does not depend on the order, because of the blend mode or because
    /// there is a single color. Otherwise MPVONC_SORT for up to 1,000,000 tetrahedra without Dt,
    /// and CENTROID_SORT for all other inputs.
    AUTOMATIC_SORT = 3
  };

  /**
   * Render paths, which draw images on the GPU or on the CPU.
   */
  enum RenderPaths
  {
    /// Shaders and a floating-point framebuffer, with OpenGL 3.2 core.
    OPENGL_PATH = 0,
    /// Multithreaded rendering in tiles on the CPU.
    SOFTWARE_PATH = 1,
    /// SOFTWARE_PATH if OpenGL is a software implementation, otherwise OPENGL_PATH.
    AUTOMATIC_PATH = 2
  };

  /**
   * Shaders that compute the silhouettes of tetrahedra with OPENGL_PATH.
   */
  enum SilhouetteShaders
  {
    /// A geometry shader, with one point for each tetrahedron.
    GEOMETRY_SHADER = 0,
    /// A vertex shader that reads tetrahedra from buffers, with four vertices for each tetrahedron.
    VERTEX_SHADER = 1,
    /// GEOMETRY_SHADER if OpenGL is a software implementation, VERTEX_SHADER on a GPU.
    AUTOMATIC_SHADER = 2
  };

  ///@{
  /**
   * Set the blend mode. Default AUTOMATIC_BLEND. Valid: COMPOSITE_BLEND (0) to AUTOMATIC_BLEND (5).
   */
  void SetBlendModeToAdditive() { this->SetBlendMode(ADDITIVE_BLEND); }
  void SetBlendModeToPriority() { this->SetBlendMode(PRIORITY_BLEND); }
  void SetBlendModeToOpticalDepth() { this->SetBlendMode(OPTICAL_DEPTH_BLEND); }
  void SetBlendModeToAutomatic() { this->SetBlendMode(AUTOMATIC_BLEND); }
  ///@}

  ///@{
  /**
   * Set/Get the integration mode. Default LINEAR_SEGMENT. Valid: see IntegrationModes; clamped.
   */
  vtkSetClampMacro(IntegrationMode, int, AVERAGE_COLOR, LINEAR_SEGMENT);
  vtkGetMacro(IntegrationMode, int);
  ///@}

  ///@{
  /**
   * Set/Get the sort mode. Default AUTOMATIC_SORT. Valid: see SortModes; clamped.
   */
  vtkSetClampMacro(SortMode, int, NO_SORT, AUTOMATIC_SORT);
  vtkGetMacro(SortMode, int);
  ///@}

  ///@{
  /**
   * Set/Get the render path. Default AUTOMATIC_PATH. Valid: see RenderPaths; clamped.
   */
  vtkSetClampMacro(RenderPath, int, OPENGL_PATH, AUTOMATIC_PATH);
  vtkGetMacro(RenderPath, int);
  ///@}

  ///@{
  /**
   * Set/Get the shader for OPENGL_PATH. Both shaders draw the same image up to rounding error.
   * Default AUTOMATIC_SHADER. Valid: see SilhouetteShaders; clamped.
   */
  vtkSetClampMacro(SilhouetteShader, int, GEOMETRY_SHADER, AUTOMATIC_SHADER);
  vtkGetMacro(SilhouetteShader, int);
  ///@}

  ///@{
  /**
   * Set/Get the name of the point array with the extent in time: one component, values >= 0, in the
   * same time unit as the extinction. Default null: use `DeltaT` if the input has this array,
   * otherwise an extent of 1 everywhere. If the name is empty, the extent is 1 everywhere. Setting
   * the name of a missing array is an error.
   */
  void SetDeltaTArrayName(const char* name);
  const char* GetDeltaTArrayName() const;
  ///@}

  ///@{
  /**
   * Set/Get the name of the cell array with the layers: one component, truncated to integers.
   * Default `IntervalId`. Used in PRIORITY_BLEND only.
   */
  void SetLayerArrayName(const char* name);
  const char* GetLayerArrayName() const;
  ///@}

  ///@{
  /**
   * Set/Get the priority of a layer. Layers with higher priority are drawn over layers with lower
   * priority. Layers with equal priorities are ordered by number. Default: the layer's number.
   */
  void SetLayerPriority(int layer, double priority);
  double GetLayerPriority(int layer) const;
  void RemoveAllLayerPriorities();
  /// Get the priorities that were set, by layer.
  const std::map<int, double>& GetLayerPriorities() const { return this->LayerPriorities; }
  ///@}

  ///@{
  /**
   * Set the boundary triangles, which are composited between the tetrahedra on both sides. The
   * input is a vtkPolyData or vtkUnstructuredGrid, such as port 1 of vtkIntervalVolume. Its
   * triangles must be faces of tetrahedra, and its points must have the ids or exact coordinates of
   * points of port 0. Point normals and texture coordinates are used if present. Triangles are
   * drawn in COMPOSITE_BLEND only. Default none.
   */
  void SetBoundaryConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetBoundaryData(vtkDataSet* triangles);
  ///@}

  ///@{
  /**
   * Set/Get the property of the boundary triangles: color, opacity, and ambient, diffuse and
   * specular coefficients. Default: a white vtkProperty with opacity 0.5. Null is ignored.
   */
  void SetBoundaryProperty(vtkProperty* property);
  vtkProperty* GetBoundaryProperty() const;
  ///@}

  ///@{
  /**
   * Set/Get the texture of the boundary triangles. Its color and opacity multiply those of the
   * property. It is interpolated. If it uses mipmaps, details smaller than a pixel fade to their
   * mean, weighted by opacity. Ignored if the boundary has no texture coordinates. Default none.
   */
  void SetBoundaryTexture(vtkTexture* texture);
  vtkTexture* GetBoundaryTexture() const;
  ///@}

  ///@{
  /**
   * Set/Get the name of a cell array of integers of the boundary triangles, such as `BoundarySide`,
   * and the property and the texture of all triangles with a value of this array. Values without a
   * property or texture use those of all triangles; null removes them. At most 255 values can have
   * some. Default: an empty name, none.
   */
  void SetBoundaryIdArrayName(const char* name);
  const char* GetBoundaryIdArrayName() const { return this->BoundaryIdArrayName.c_str(); }
  void SetBoundaryProperty(int id, vtkProperty* property);
  vtkProperty* GetBoundaryProperty(int id) const;
  void SetBoundaryTexture(int id, vtkTexture* texture);
  vtkTexture* GetBoundaryTexture(int id) const;
  void RemoveAllBoundaryIds();
  /// Return the values that have a property or a texture, in ascending order.
  std::vector<int> GetBoundaryIds() const;
  ///@}

  ///@{
  /**
   * Set/Get the ids that hardware selection returns, if port 0 was derived from other data. This is
   * a dataset with the same numbers of points and cells as port 0, and the arrays
   * SelectionCellIds(), SelectionBlockIds() and SelectionPointIds() of type vtkIdType. If the
   * numbers differ, nothing can be selected. Default null: the ids of port 0.
   */
  void SetSelectionIds(vtkDataSet* ids);
  vtkDataSet* GetSelectionIds() const;
  /// Return the names of the cell arrays with cell ids and composite indices, and of the point
  /// array with point ids.
  static const char* SelectionCellIds() { return "SelectionCellIds"; }
  static const char* SelectionBlockIds() { return "SelectionBlockIds"; }
  static const char* SelectionPointIds() { return "SelectionPointIds"; }
  ///@}

  ///@{
  /**
   * If on, render with fewer pixels and a subset of the tetrahedra if full detail would take longer
   * than the render time allocated to the volume (DesiredUpdateRate of the window or its
   * interactor). Tetrahedra of a subset are enlarged so that mean opacity and brightness remain
   * nearly unchanged. A subset contains all smaller ones and does not depend on the view, so it
   * does not flicker. It is computed in the first such image after a change of the data or the
   * transfer functions. Images that have enough time, and hardware selection, always have full
   * detail, as have images of several processes (see GatherPieces). Default on.
   */
  vtkSetMacro(AutoAdjustLevelOfDetail, bool);
  vtkGetMacro(AutoAdjustLevelOfDetail, bool);
  vtkBooleanMacro(AutoAdjustLevelOfDetail, bool);
  ///@}

  ///@{
  /**
   * If on, an image that takes more than 0.2 s is refined by consecutive renderings: the first one
   * draws a subset of the tetrahedra within about 0.2 s, and the last one the same image as with
   * this setting off. Render the window again while GetRefinementPending() returns true. A change
   * of the scene restarts with the first image. Images of several processes (see GatherPieces) are
   * not refined. Default off: each rendering draws the final image.
   */
  void SetProgressiveRendering(bool isProgressive)
  {
    // The final image is the same, so the mapper is not modified.
    this->ProgressiveRendering = isProgressive;
  }
  vtkGetMacro(ProgressiveRendering, bool);
  vtkBooleanMacro(ProgressiveRendering, bool);
  ///@}

  /**
   * Return true if ProgressiveRendering is on and the last image was not final, or was aborted.
   */
  bool GetRefinementPending() const;

  /**
   * Render the input as one partition of a volume that is distributed over the processes of \a
   * controller. All processes must call this together whenever the input or the blend mode has
   * changed. They must then render every image together, with the same camera; a selection may be
   * rendered by one process alone. GetBounds then returns the bounds of all partitions.
   *
   * Returns true if all partitions are combined in one image (see the class comment).
   * AUTOMATIC_PATH tests whether the OpenGL of \a window is software; if there is no window, it
   * assumes a GPU. If this returns false, or if \a controller is null or has one process, only the
   * input is drawn.
   */
  bool GatherPieces(vtkMultiProcessController* controller, vtkRenderWindow* window = nullptr);

  /**
   * Return true if a dataset has the array for the extent in time.
   */
  bool HasExtentInTime(vtkDataSet* data) const;

  using Superclass::GetBounds;
  /// Get the bounds of all points with finite coordinates. If GatherPieces returned true, these are
  /// points of all partitions.
  double* GetBounds() VTK_SIZEHINT(6) override;

  /**
   * Get the report of the last image:
   * - `Tetrahedra`, `TetrahedraDrawn`: number of tetrahedra in the input, and number of tetrahedra
   *   drawn;
   * - `NonFiniteTetrahedra`: number of tetrahedra skipped because of NaN or infinity at a point;
   * - `FlatTetrahedra`: number of tetrahedra skipped because they have no volume;
   * - `UnmatchedTriangles`: number of boundary triangles skipped because they are not faces of
   *   tetrahedra;
   * - `RenderPath`, `PathReason`: the path (see RenderPaths), and the reason for it;
   * - `SortReason`: the reason for the sort mode;
   * - `PixelStride`: number of viewport pixels per computed pixel in x and in y; 1 in full detail;
   * - `TetrahedronStride`: number of tetrahedra per tetrahedron of the subset; 1 in full detail;
   * - `Seconds`: time to render this image, in seconds.
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

  vtkMTimeType GetMTime() override;
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkTimeWeightedTetrahedraMapper();
  ~vtkTimeWeightedTetrahedraMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkTimeWeightedTetrahedraMapper(const vtkTimeWeightedTetrahedraMapper&) = delete;
  void operator=(const vtkTimeWeightedTetrahedraMapper&) = delete;

  /// Returns the bounds of this process's partition.
  double* GetOwnBounds();
  /// Returns true if images in a window are drawn with SOFTWARE_PATH.
  bool DrawsInSoftware(vtkRenderWindow* window) const;
  /// Finds the input arrays. Returns an error if they or the cells cannot be used.
  interlume::Error FindArrays(vtkUnstructuredGrid* grid, interlume::TetrahedraArrays& arrays);

  int IntegrationMode = LINEAR_SEGMENT;
  int SortMode = AUTOMATIC_SORT;
  int RenderPath = AUTOMATIC_PATH;
  int SilhouetteShader = AUTOMATIC_SHADER;
  bool HasDeltaTArrayName = false;
  std::string DeltaTArrayName;
  std::string LayerArrayName = "IntervalId";
  std::map<int, double> LayerPriorities;
  vtkSmartPointer<vtkProperty> BoundaryProperty;
  vtkSmartPointer<vtkTexture> BoundaryTexture;
  std::string BoundaryIdArrayName;
  std::map<int, vtkSmartPointer<vtkProperty>> BoundaryProperties;
  std::map<int, vtkSmartPointer<vtkTexture>> BoundaryTextures;
  vtkSmartPointer<vtkDataSet> SelectionIds;
  bool AutoAdjustLevelOfDetail = true;
  bool ProgressiveRendering = false;
  vtkNew<vtkInterlumeReport> Report;
  /// Communication with the other processes; null if only this input is drawn.
  std::unique_ptr<interlume::PieceExchange> Pieces;
  std::unique_ptr<interlume::PeelingDeferral> Peels;
  std::unique_ptr<interlume::TetrahedraRenderer> Renderer;
  /// The latest modification time of inputs and mapper at the last image.
  vtkMTimeType MessageTime = 0;
};

#endif
