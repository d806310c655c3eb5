// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraRenderer_h
#define interlume_TetrahedraRenderer_h

#include "Common/Error.h"
#include "Draw/LevelOfDetail.h"
#include "Draw/TetrahedraSubset.h"
#include "Frame/BoundaryShading.h"
#include "Frame/PlaneClip.h"
#include "Frame/TetrahedraFrame.h"
#include "Frame/TetrahedraReport.h"
#include "Mesh/MeshBuilder.h"
#include "Mesh/TetrahedraBuilder.h"
#include "Order/BoundaryFaces.h"
#include "Mesh/GridSample.h"
#include "Order/TetrahedraOrder.h"
#include "Refinement/ImageRefinement.h"
#include "Software/SoftwareRasterizer.h"
#include "View/OpaqueSceneDepth.h"

#include "vtkType.h"

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkDataSet;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkTimeWeightedTetrahedraMapper;
class vtkUnstructuredGrid;
class vtkVolume;
class vtkVolumeProperty;
class vtkWindow;

namespace interlume
{

class PieceExchange;
class RenderProgress;

/**
 * @class   TetrahedraRenderer
 * @brief   draws an image: updates changed data, resolves automatic modes, and runs a render path
 */
class TetrahedraRenderer
{
public:
  TetrahedraRenderer();
  ~TetrahedraRenderer();

  /// The mapper with its settings, and its inputs.
  struct Request
  {
    vtkTimeWeightedTetrahedraMapper* Mapper = nullptr;
    vtkUnstructuredGrid* Grid = nullptr;
    TetrahedraArrays Arrays;
    vtkDataSet* Boundary = nullptr;
    BoundaryFaces::Materials BoundaryMaterials;
    /// Properties and textures of the boundary's materials.
    std::vector<BoundaryShading::Source> BoundarySources;
    /// Communication with the other processes, or null if only this input is drawn. If not null,
    /// Grid may be null.
    const PieceExchange* Pieces = nullptr;
    /// Number of input cells per cell of Grid; above 1 if Grid is a sample, which is drawn in
    /// reduced detail.
    int CellStride = 1;
  };

  /**
   * Draws an image and fills the report. Returns an error if something cannot be drawn.
   */
  Error Render(
    vtkRenderer* renderer, vtkVolume* volume, const Request& request, TetrahedraReport& report);

  /// Returns true if the last image was not final.
  bool IsRefinementPending() const { return this->Refinement.IsPending(); }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// OpenGL resources of a window.
  struct WindowResources;
  struct DrawnState;

  WindowResources& GetResources(vtkWindow* window);
  /// Rebuilds the mesh, or only its values if the mesh is unchanged. Returns an error if the grid
  /// cannot be drawn.
  Error UpdateMesh(const Request& request, TetrahedraReport& report);
  void CountTetrahedra(const Request& request, TetrahedraReport& report) const;
  Error UpdateColors(const Request& request, vtkVolumeProperty* property, double unit);
  void ChooseBlend(const Request& request, TetrahedraReport& report);
  void ChooseRenderPath(
    const Request& request, vtkOpenGLRenderWindow* window, TetrahedraReport& report);
  void ChooseShader(
    const Request& request, vtkOpenGLRenderWindow* window, TetrahedraReport& report);
  void ChooseSort(const Request& request, TetrahedraReport& report);
  /// Begins a pass of a progressive image. Returns the time for this image in seconds.
  double BeginPass(
    vtkRenderer* renderer, vtkVolume* volume, const Request& request, TetrahedraReport& report);
  /// Ends a complete image. Returns \a error.
  Error EndPass(const Error& error, bool isFinal);
  bool IsMeshCurrent(const Request& request) const;
  /// Returns true if no mesh or subset exists that can be drawn in \a seconds.
  bool NeedsSample(const Request& request, vtkVolume* volume, double seconds) const;
  /// Draws a sample of the input.
  Error RenderSample(
    vtkRenderer* renderer, vtkVolume* volume, const Request& request, TetrahedraReport& report);
  void ReleaseSample(vtkOpenGLRenderWindow* window);
  /// Adapts the measured times to the mesh, or clears them if they do not apply to this image.
  void UpdateLevels(vtkRenderer* renderer, TetrahedraReport& report);
  /// Returns the level of detail for an image that may take \a seconds; 0 is full detail.
  int ChooseLevel(
    vtkRenderer* renderer, double seconds, const Request& request, TetrahedraReport& report);
  /// Updates the changed parts of the frame, and sets Shown. If \a subset is not 0, draws a subset
  /// of this size. Returns an error if the frame cannot be drawn.
  Error UpdateFrame(vtkRenderer* renderer, vtkVolume* volume, const Request& request,
    std::uint32_t subset, TetrahedraReport& report);
  void UpdateSubset(std::uint32_t number);
  /// Sorts and clips the tetrahedra. If \a progress is not null, sorting can be aborted. Returns an
  /// error if a clipping plane is invalid.
  Error ArrangeFrame(const Request& request, RenderProgress* progress, TetrahedraReport& report);
  /// Cuts the mesh at the near plane and the clipping planes, and sets the frame's drawing order.
  /// Returns an error if a clipping plane is invalid.
  Error ClipMesh(const Request& request, const std::vector<std::uint32_t>* order);
  /// Returns false if the image was aborted.
  bool DrawFrame(vtkRenderer* renderer, vtkVolume* volume, WindowResources& resources,
    RenderProgress& progress, TetrahedraReport& report);
  bool HasSingleColor() const;
  /// Returns false if sorting was aborted.
  bool UpdateOrder(const Request& request, RenderProgress* progress, TetrahedraReport& report);
  Error DrawWithOpenGL(
    vtkRenderer* renderer, vtkVolume* volume, WindowResources& resources, TetrahedraReport& report);
  /// Returns false if the image was aborted.
  bool DrawInSoftware(vtkRenderer* renderer, WindowResources& resources, RenderProgress& progress,
    TetrahedraReport& report);
  /// Draws the image of this process's partition.
  Error RenderMesh(vtkRenderer* renderer, vtkVolume* volume, const Request& request,
    vtkOpenGLRenderWindow& window, TetrahedraReport& report);
  /// Draws the image of all partitions, together with the other processes.
  Error RenderPieces(vtkRenderer* renderer, vtkVolume* volume, const Request& request,
    vtkOpenGLRenderWindow& window, TetrahedraReport& report);
  /// Returns the ranks of the processes from front to back; empty if the blend mode needs no order.
  static std::vector<int> FindPieceOrder(
    vtkRenderer* renderer, vtkVolume* volume, const PieceExchange& pieces);
  /// Updates the changed parts of this process's partition. Returns an error if it cannot be drawn.
  Error UpdatePiece(
    vtkRenderer* renderer, vtkVolume* volume, const Request& request, TetrahedraReport& report);
  /// Draws a pass of the renderer's selector. Returns an error if the grid cannot be drawn.
  Error Select(vtkRenderer* renderer, vtkVolume* volume, const Request& request,
    vtkOpenGLRenderWindow& window, TetrahedraReport& report);
  void ReadDepth(vtkRenderer* renderer);
  /// Sets the frame's opaque depth from the depth that was read.
  void SetOpaqueDepth();
  /// Returns true if the far plane cuts the mesh.
  bool IsCutByFarPlane() const;
  void UpdateBoundary(vtkRenderer* renderer, const Request& request, TetrahedraReport& report);
  std::string GetFeatures() const;
  vtkIdType GetMemoryBytes() const;

  /// The mesh or a subset of it, and the state to draw it.
  struct Detail
  {
    TetrahedraMesh Mesh;
    TetrahedraFields Fields;
    TetrahedraOrder Order;
    PlaneClip Clip;
    TetrahedraFrame Frame;
  };

  /// The data that the mesh was built from.
  struct MeshKey
  {
    vtkUnstructuredGrid* Grid = nullptr;
    vtkMTimeType Time = 0;
    TetrahedraArrays Arrays;
  };
  MeshKey MeshState;
  vtkVolumeProperty* Property = nullptr;
  vtkMTimeType PropertyTime = 0;
  double ColorUnit = 0.0;
  /// If true, there is a single color and order does not matter.
  bool HasOneColor = false;

  /// The data that the boundary was built from.
  vtkDataSet* Boundary = nullptr;
  vtkMTimeType BoundaryTime = 0;
  BoundaryFaces::Materials BoundaryMaterials;
  BoundaryFaces::Counts BoundaryCounts;
  BoundaryShading Shading;

  Detail Full;
  Detail Reduced;
  /// The one to draw.
  Detail* Shown = &this->Full;
  PiecewiseLinearTransferFunction Pieces;
  interlume::MeshBuilder MeshBuilder;
  OpaqueSceneDepth Depth;
  SoftwareRasterizer Rasterizer;
  interlume::LevelOfDetail LevelOfDetail;
  /// Render path and viewport size, and version of the mesh, for which LevelOfDetail has times.
  std::array<int, 3> LevelConditions{};
  int LevelMesh = 0;
  TetrahedraSubset Subset;
  /// Simplified transfer functions, and the version of the colors that they were built from.
  PiecewiseLinearTransferFunction SubsetPieces;
  int SubsetColors = 0;
  ImageRefinement Refinement;
  /// Sample of the input, and the renderer that draws it; null without a sample.
  GridSample Sample;
  std::unique_ptr<TetrahedraRenderer> SampleRenderer;
  std::map<vtkWindow*, std::unique_ptr<WindowResources>> Windows;
};

}

#endif
