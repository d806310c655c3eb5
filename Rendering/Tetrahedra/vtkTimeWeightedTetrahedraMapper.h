// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTimeWeightedTetrahedraMapper_h
#define vtkTimeWeightedTetrahedraMapper_h

#include "InterlumeTetrahedraModule.h" // for the export macro
#include "vtkInterlumeReport.h"        // for GetReport()
#include "vtkNew.h"
#include "vtkSmartPointer.h" // for the boundary's looks
#include "vtkUnstructuredGridVolumeMapper.h"

#include <map>    // for the priorities
#include <memory> // for what is kept from picture to picture
#include <string> // for array names

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
 * @brief   draws tetrahedra as a volume, each with its extent in time
 *
 * Along a line of sight the optical depth of one tetrahedron is the integral of
 * tau(f(s)) Dt(s) ds, with the extinction tau, the scalar f and the extent in time Dt all linear
 * between entry and exit (C. Zhang, dissertation, Ohio State 2006, 3.5.4). A tetrahedron is drawn
 * as its silhouette of one or two triangles (P. Shirley, A. Tuchman, "A polygonal approximation to
 * direct scalar volume rendering", 1990, with the thick vertex carried as a number), which is exact
 * in parallel and in perspective.
 *
 * Input port 0: a vtkUnstructuredGrid of VTK_TETRA cells. Input port 1, optional: boundary
 * triangles, see SetBoundaryConnection.
 *
 * Colour comes from the volume's property and the scalars that ScalarMode, ArrayName, ArrayId
 * choose, as in VTK's other mappers:
 * - point scalars of one component: colour and opacity functions of the interpolated scalar, whose
 *   straight pieces are integrated exactly wherever their ends lie within a tetrahedron;
 * - cell scalars (`IntervalId`): one colour and opacity for each tetrahedron;
 * - two components without IndependentComponents: colour of the first, opacity of the second;
 * - four without IndependentComponents: RGB and the opacity function of the fourth; three: RGB and
 *   the opacity function of their mean. Unsigned char colours are 0 to 255, others 0 to 1.
 *
 * With several independent components the vector mode of the colour function chooses one or the
 * magnitude.
 *
 * Extinction is the scalar opacity function divided by the property's ScalarOpacityUnitDistance,
 * per unit of length, as in VTK's mappers for unstructured grids; it may exceed 1.
 *
 * Every pixel of the software path is within 1e-3 of the integral in each channel, in order of
 * visibility, also where faces are seen edge-on and points coincide on the screen. A line of sight
 * passes its pixel's centre by 4e-9 of the pixel, so that a mesh seen from the side and thinner
 * than a millionth of a pixel is off by what changes over that: 5e-4 at 1e-6, 5e-3 at 1e-7.
 *
 * With OpenGL a pixel whose centre is within 1/256 pixel of the edge of a tetrahedron's silhouette
 * can be on its other side, since graphics cards round corners. So what is thinner than that on the
 * screen can be drawn or missed as a whole: a plate seen from the side (every pixel of it, to
 * 0.92), the middle of a fan of 2,000 needles seen along their axis (172 of 9,216 pixels, to 0.37),
 * a pixel at the corner of a squashed mesh (to 0.78). The software path has none of that.
 *
 * Opaque props occlude: a segment that runs into one is cut there, and so is one that runs into the
 * far plane. Each tetrahedron with a vertex before the near plane is clipped, and so is each with a
 * vertex on the far side of a clipping plane (AddClippingPlane; planes of the world, any number):
 * values and colors are those at the cut, and boundary triangles end there. Every kind of camera is
 * drawn as VTK projects it: stereo, view shear, off-axis, with user transforms. Selection
 * (vtkHardwareSelector) finds the first tetrahedron on a line of sight that is not wholly
 * transparent. Translucent polygons other than boundary triangles are behind the volume wherever
 * they are: UseDepthPeelingForVolumes is not supported, is warned of once, and draws the picture
 * that is drawn without it.
 *
 * **Pieces of one volume in several processes** make one picture after GatherPieces: each process
 * draws its piece by SOFTWARE_PATH, what the blend mode sums up along the lines of sight is
 * exchanged in floats, and each pixel is shown by one process, the one with the nearest opaque
 * surface there, else the first. So the picture is that of one process but for rounding, wherever
 * the pieces are, and laying the processes' pictures over each other adds nothing to it. With
 * COMPOSITE_BLEND that holds for pieces whose boxes planes part, one after the other, so that they
 * have an order from everywhere, where all processes take SOFTWARE_PATH by themselves or are told
 * to. Elsewhere each process composites its piece alone, and the pictures, rounded to 8 bits, have
 * to be laid over each other in order: graphics cards are faster at that.
 *
 * Errors (vtkErrorMacro, nothing drawn): cells that are no tetrahedra, missing scalars, an array
 * for Dt or layers that is named and missing, a wrong number of components, a clipping plane
 * without a normal. Tetrahedra with NaN or infinity are left out and counted in GetReport().
 */
class INTERLUMETETRAHEDRA_EXPORT vtkTimeWeightedTetrahedraMapper
  : public vtkUnstructuredGridVolumeMapper
{
public:
  static vtkTimeWeightedTetrahedraMapper* New();
  vtkTypeMacro(vtkTimeWeightedTetrahedraMapper, vtkUnstructuredGridVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How the segments of a line of sight are put together.
   */
  enum BlendModes
  {
    /// Front to back in order of visibility: COMPOSITE_BLEND of the superclass, 0.
    /// The largest scalar's colour and opacity: MAXIMUM_INTENSITY_BLEND of the superclass, 1.
    /// Sum of colour times opacity, without order; saturates.
    ADDITIVE_BLEND = 2,
    /// Each layer on its own (as OPTICAL_DEPTH_BLEND), then the layers by priority, whatever lies
    /// in front.
    PRIORITY_BLEND = 3,
    /// 1 - exp(-sum of optical depth), with the mean of colour weighted by optical depth: needs no
    /// order; exact for one colour.
    OPTICAL_DEPTH_BLEND = 4,
    /// OPTICAL_DEPTH_BLEND with Dt, whose tetrahedra overlap so that no order exists; else
    /// COMPOSITE_BLEND.
    AUTOMATIC_BLEND = 5
  };

  /**
   * How colour and opacity of one segment are found.
   */
  enum IntegrationModes
  {
    /// The mean of colour and of extinction at both ends, as the source has it.
    AVERAGE_COLOR = 0,
    /// The exact integral over linear colour and extinction (K. Moreland, E. Angel, "A fast high
    /// accuracy volume renderer for unstructured data", 2004), from control point to control point.
    LINEAR_SEGMENT = 1
  };

  /**
   * Order of the tetrahedra.
   */
  enum SortModes
  {
    NO_SORT = 0,
    /// Distance of the centroid, from the eye in perspective, along the view in parallel.
    CENTROID_SORT = 1,
    /// Visibility over shared faces (P. Williams, "Visibility-ordering meshed polyhedra", 1992),
    /// with the gaps of a mesh that is not convex closed along lines of sight.
    MPVONC_SORT = 2,
    /// NO_SORT where the blend mode or one colour makes order irrelevant; MPVONC_SORT up to
    /// 1,000,000 tetrahedra without Dt; else CENTROID_SORT.
    AUTOMATIC_SORT = 3
  };

  /**
   * Who draws.
   */
  enum RenderPaths
  {
    /// Silhouettes by shaders and a float framebuffer, OpenGL 3.2 core.
    OPENGL_PATH = 0,
    /// Threads and tiles on the CPU.
    SOFTWARE_PATH = 1,
    /// SOFTWARE_PATH where OpenGL is itself software, else OPENGL_PATH.
    AUTOMATIC_PATH = 2
  };

  /**
   * Which shader makes the silhouettes of tetrahedra with OPENGL_PATH.
   */
  enum SilhouetteShaders
  {
    /// A geometry shader, of one point for each tetrahedron.
    GEOMETRY_SHADER = 0,
    /// A vertex shader, whose four vertices for each tetrahedron pull it from buffers.
    VERTEX_SHADER = 1,
    /// GEOMETRY_SHADER where OpenGL is software, VERTEX_SHADER on a graphics card.
    AUTOMATIC_SHADER = 2
  };

  ///@{
  /**
   * The blend mode. Default AUTOMATIC_BLEND. Valid: COMPOSITE_BLEND (0) to AUTOMATIC_BLEND (5).
   */
  void SetBlendModeToAdditive() { this->SetBlendMode(ADDITIVE_BLEND); }
  void SetBlendModeToPriority() { this->SetBlendMode(PRIORITY_BLEND); }
  void SetBlendModeToOpticalDepth() { this->SetBlendMode(OPTICAL_DEPTH_BLEND); }
  void SetBlendModeToAutomatic() { this->SetBlendMode(AUTOMATIC_BLEND); }
  ///@}

  ///@{
  /**
   * The integration mode. Default LINEAR_SEGMENT. Valid: see IntegrationModes; clamped.
   */
  vtkSetClampMacro(IntegrationMode, int, AVERAGE_COLOR, LINEAR_SEGMENT);
  vtkGetMacro(IntegrationMode, int);
  ///@}

  ///@{
  /**
   * The sort mode. Default AUTOMATIC_SORT. Valid: see SortModes; clamped.
   */
  vtkSetClampMacro(SortMode, int, NO_SORT, AUTOMATIC_SORT);
  vtkGetMacro(SortMode, int);
  ///@}

  ///@{
  /**
   * The render path. Default AUTOMATIC_PATH. Valid: see RenderPaths; clamped.
   */
  vtkSetClampMacro(RenderPath, int, OPENGL_PATH, AUTOMATIC_PATH);
  vtkGetMacro(RenderPath, int);
  ///@}

  ///@{
  /**
   * The shader that makes silhouettes with OPENGL_PATH; pictures are the same but for the rounding
   * of shaders. Default AUTOMATIC_SHADER. Valid: see SilhouetteShaders; clamped.
   */
  vtkSetClampMacro(SilhouetteShader, int, GEOMETRY_SHADER, AUTOMATIC_SHADER);
  vtkGetMacro(SilhouetteShader, int);
  ///@}

  ///@{
  /**
   * The name of the point array with the extent in time, one component, in the unit that the scalar
   * opacity unit distance is given for; values >= 0. Default null: `DeltaT` where the input has it,
   * else 1 everywhere. The empty name: 1 everywhere.
   */
  void SetDeltaTArrayName(const char* name);
  const char* GetDeltaTArrayName() const;
  ///@}

  ///@{
  /**
   * The name of the cell array that tells layers apart, one component, taken as integers. Default
   * `IntervalId`. It is read in PRIORITY_BLEND only.
   */
  void SetLayerArrayName(const char* name);
  const char* GetLayerArrayName() const;
  ///@}

  ///@{
  /**
   * The priority of a layer: the higher is drawn over the lower, equal ones by layer number.
   * Default: the layer's number.
   */
  void SetLayerPriority(int layer, double priority);
  double GetLayerPriority(int layer) const;
  void RemoveAllLayerPriorities();
  /// Returns the priorities that are set, by layer.
  const std::map<int, double>& GetLayerPriorities() const { return this->LayerPriorities; }
  ///@}

  ///@{
  /**
   * The triangles that are drawn where the line of sight passes them, between the volume in front
   * and behind: a vtkPolyData or vtkUnstructuredGrid whose triangles are faces of tetrahedra and
   * whose points are those of port 0, with the same ids (port 1 of vtkIntervalVolume). Point
   * normals and texture coordinates are used where it has them. Only COMPOSITE_BLEND has a place
   * for them; other modes leave them out and report 0 triangles. Default none.
   */
  void SetBoundaryConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetBoundaryData(vtkDataSet* triangles);
  ///@}

  ///@{
  /**
   * The colour, opacity, ambient, diffuse and specular of the boundary triangles. Default: a white
   * vtkProperty of opacity 0.5.
   */
  void SetBoundaryProperty(vtkProperty* property);
  vtkProperty* GetBoundaryProperty() const;
  ///@}

  ///@{
  /**
   * An image over the boundary's texture coordinates; its colour and opacity multiply the
   * property's. Default none.
   */
  void SetBoundaryTexture(vtkTexture* texture);
  vtkTexture* GetBoundaryTexture() const;
  ///@}

  ///@{
  /**
   * Whether pictures get coarser, in pixels and then in tetrahedra, while the time allocated to the
   * volume is less than a full picture took. Still pictures are always full. Default on.
   */
  vtkSetMacro(AutoAdjustLevelOfDetail, bool);
  vtkGetMacro(AutoAdjustLevelOfDetail, bool);
  vtkBooleanMacro(AutoAdjustLevelOfDetail, bool);
  ///@}

  /**
   * Makes the input a piece of a volume whose others are the inputs of this mapper in the other
   * processes of \a controller. All of them must call it together, whenever the input or the blend
   * mode has changed, and must draw every picture that is no selection together, from the same
   * view; GetBounds are then those of all pieces. Returns whether the pieces make one picture: in
   * every blend mode that needs no order, and with COMPOSITE_BLEND where they have one (see above);
   * \a window tells AUTOMATIC_PATH there whether OpenGL is software, and without it counts as a
   * graphics card. With false, null or one process the input is drawn as without it.
   */
  bool GatherPieces(vtkMultiProcessController* controller, vtkRenderWindow* window = nullptr);

  /**
   * Returns whether a dataset has the array for the extent in time.
   */
  bool HasExtentInTime(vtkDataSet* data) const;

  using Superclass::GetBounds;
  /// Returns the bounds of the points that have finite coordinates.
  double* GetBounds() VTK_SIZEHINT(6) override;

  /**
   * Returns the report of the last image:
   * - `Tetrahedra`, `TetrahedraDrawn`: tetrahedra of the input and drawn ones;
   * - `NonFiniteTetrahedra`: tetrahedra skipped because of NaN or infinity at a corner;
   * - `FlatTetrahedra`: tetrahedra skipped because they have no volume;
   * - `UnmatchedTriangles`: boundary triangles skipped because they are no face of a tetrahedron;
   * - `RenderPath`, `PathReason`: the chosen path of RenderPaths, and why;
   * - `SortReason`: why tetrahedra were sorted as they were, or not at all;
   * - `PixelStride`: the level of detail, 1 for a full image;
   * - `Seconds`: seconds of this image.
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

  /// Returns the bounds of this process's piece.
  double* GetOwnBounds();
  /// Returns whether a picture in a window is left to SOFTWARE_PATH.
  bool DrawsInSoftware(vtkRenderWindow* window) const;
  /// Sets the arrays to be read. Returns an error if they or the cells cannot be used.
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
  bool AutoAdjustLevelOfDetail = true;
  vtkNew<vtkInterlumeReport> Report;
  /// The other pieces of the volume; null where the input is drawn alone.
  std::unique_ptr<interlume::PieceExchange> Pieces;
  std::unique_ptr<interlume::PeelingDeferral> Peels;
  std::unique_ptr<interlume::TetrahedraRenderer> Renderer;
  /// The modification time of the input and the mapper when the last error was given.
  vtkMTimeType ErrorTime = 0;
};

#endif
