// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkIntervalVolumeRepresentation_h
#define vtkIntervalVolumeRepresentation_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkNew.h"                         // for the collection
#include "vtkSmartPointer.h"                // for the mapper
#include "vtkUnstructuredGridVolumeRepresentation.h"
#include "vtkWeakPointer.h" // for the renderer

#include <memory> // for members
#include <string> // for warnings

class vtkColorTransferFunction;
class vtkConstantScalars;
class vtkDataArray;
class vtkDataSet;
class vtkPiecewiseFunction;
class vtkRenderer;
class vtkSelectionIds;
class vtkTimeWeightedTetrahedraMapper;
class vtkTrivialProducer;
class vtkVolumeFunctions;

/**
 * @class   vtkIntervalVolumeRepresentation
 * @brief   render unstructured grids in ParaView with vtkTimeWeightedTetrahedraMapper
 *
 * Input: a vtkUnstructuredGrid or a composite dataset of them. Cells other than tetrahedra are
 * split into tetrahedra. Color and opacity are set as for ParaView's Volume: a point or cell array,
 * its color and opacity functions, and the opacity unit distance. If there is no color array, or
 * the data lack it, the solid color and a constant opacity are used (see vtkVolumeFunctions).
 *
 * Optional input port 1: boundary triangles, such as the second output of Interval Volume, drawn
 * between the tetrahedra (see vtkTimeWeightedTetrahedraMapper::SetBoundaryConnection). Blocks are
 * merged. Triangles whose tetrahedra ParaView has moved to another process are not drawn.
 *
 * **Interaction.** Without a server, the mapper draws a subset of the tetrahedra in the time that
 * the view allocates (see vtkTimeWeightedTetrahedraMapper::SetAutoAdjustLevelOfDetail).
 *
 * **Selection.** Cells, points and hovered values are those of the input, also if the tetrahedra
 * are parts of other cells or from several blocks. See vtkTimeWeightedTetrahedraMapper for the
 * cells that are seen. Nothing can be selected if ParaView has redistributed the cells.
 *
 * **Several processes.** Blend modes that do not depend on order produce the same image as a single
 * process, for any distribution of the pieces (see vtkTimeWeightedTetrahedraMapper::GatherPieces).
 * COMPOSITE_BLEND does so too if planes separate the boxes of the pieces and all processes render
 * in software. Otherwise, ParaView composites the images of the processes in visibility order, with
 * 8 bits per channel. If the boxes of the pieces overlap, it redistributes the tetrahedra first,
 * and a tetrahedron that extends into two regions is rendered in one of them.
 *
 * Warnings (vtkWarningMacro, once per session) if the image may be incorrect:
 * - The processes cannot send grids to each other (see vtkGridExchange).
 * - COMPOSITE_BLEND is used for tetrahedra with an extent in time, which overlap and have no
 *   visibility order.
 * - Another blend mode is used on a tiled display or in a CAVE, where each process renders only its
 *   own cells.
 */
class INTERLUMEREPRESENTATIONS_EXPORT vtkIntervalVolumeRepresentation
  : public vtkUnstructuredGridVolumeRepresentation
{
public:
  static vtkIntervalVolumeRepresentation* New();
  vtkTypeMacro(vtkIntervalVolumeRepresentation, vtkUnstructuredGridVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set the color and opacity functions of the color array, and a factor for all opacities.
   * Default: null, null, 1. Valid factors: 0 to 1; clamped.
   */
  void SetColor(vtkColorTransferFunction* color);
  void SetScalarOpacity(vtkPiecewiseFunction* opacity);
  void SetOpacity(double opacity);
  ///@}

  /**
   * Set the color to use if there is no color array. Default: white.
   */
  void SetSolidColor(double red, double green, double blue);

  /**
   * Set the mapper. Call it before adding the representation to a view. ParaView sets the mapper's
   * properties directly. Default: a new mapper.
   */
  void SetMapper(vtkTimeWeightedTetrahedraMapper* mapper);

  /**
   * Set the name of the point array with the extent in time. `DeltaT` selects the array of this
   * name if the input has it, and otherwise an extent of 1 everywhere. An empty name selects an
   * extent of 1 everywhere. Default: `DeltaT`.
   */
  void SetDeltaTArrayName(const char* name);

  ///@{
  /**
   * Select the blocks of composite data to draw: the name of the data assembly, and selectors. See
   * the superclass. Default: no block.
   */
  void SetActiveAssembly(const char* name);
  void AddBlockSelector(const char* selector);
  void RemoveAllBlockSelectors();
  ///@}

  ///@{
  /**
   * Set the color and the opacity of boundary triangles with a value of the mapper's
   * BoundaryIdArrayName. Highlights are those of the mapper's BoundaryProperty.
   */
  void SetBoundaryColor(int id, double red, double green, double blue, double opacity);
  void RemoveAllBoundaryColors();
  ///@}

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

  using Superclass::GetInternalOutputPort;
  /// Return the output port. Partitioned datasets are wrapped in a collection, because the
  /// superclass finds blocks only in collections.
  vtkAlgorithmOutput* GetInternalOutputPort(int port, int connection) override;

protected:
  vtkIntervalVolumeRepresentation();
  ~vtkIntervalVolumeRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkIntervalVolumeRepresentation(const vtkIntervalVolumeRepresentation&) = delete;
  void operator=(const vtkIntervalVolumeRepresentation&) = delete;

  /// Passes the boundary triangles that the view has delivered to the mapper.
  void UpdateBoundary(vtkInformation* view);
  /// Returns the color array, or null if the input of the mapper lacks it.
  vtkDataArray* FindScalars();

  /// Returns true if the mapper reduces the level of detail during interaction. Otherwise, as for
  /// ParaView's Volume, a simplified surface is drawn: if a server renders, because the client must
  /// be able to draw the reduced data, or if AutoAdjustLevelOfDetail is off.
  bool DrawsSubsets() const;
  /// Sets how ParaView distributes the cells for rendering. Each process keeps its own cells if the
  /// blend mode does not depend on order, if the bounds of the pieces are disjoint, or if sending
  /// the cells fails or changes them.
  void ConfigureCompositing(vtkInformation* view);
  /// Connects the mappers of all processes to render one image if the blend mode allows it.
  /// Otherwise, warns if the image may be incorrect.
  void GatherPieces(bool isReduced);
  /// Issues a warning on the first process, but only once per session for each text.
  void WarnOnce(const std::string& text);
  /// Called before each rendering. Makes all processes render if they render one image together,
  /// and sets the ids if something is selected.
  void OnRenderStart();
  /// Sets the ids that selection returns.
  void UpdateSelectionIds();

  vtkSmartPointer<vtkTimeWeightedTetrahedraMapper> Mapper;
  vtkNew<vtkTrivialProducer> Collection;
  /// Boundary triangles of this process; null if there are none.
  vtkSmartPointer<vtkDataSet> Boundary;
  vtkWeakPointer<vtkRenderer> ViewRenderer;
  unsigned long Observer = 0;
  /// Whether the data and the client are in this process, and no other process renders.
  bool IsLocal;
  /// Whether all processes render one image together.
  bool IsSingleImage = false;
  /// Whether the bounds of the pieces of all processes are disjoint, and whether any piece has an
  /// extent in time.
  bool AreBoundsDisjoint = true;
  bool HaveExtentInTime = false;
  std::unique_ptr<vtkVolumeFunctions> Functions;
  std::unique_ptr<vtkConstantScalars> Constant;
  std::unique_ptr<vtkSelectionIds> SelectionIds;
};

#endif
