// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkIntervalVolumeRepresentation_h
#define vtkIntervalVolumeRepresentation_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkNew.h"                         // for the collection
#include "vtkSmartPointer.h"                // for the mapper
#include "vtkUnstructuredGridVolumeRepresentation.h"
#include "vtkWeakPointer.h" // for the renderer

#include <memory> // for what it is made of
#include <string> // for warnings

class vtkColorTransferFunction;
class vtkConstantScalars;
class vtkDataArray;
class vtkPiecewiseFunction;
class vtkRenderer;
class vtkTimeWeightedTetrahedraMapper;
class vtkTrivialProducer;
class vtkVolumeFunctions;

/**
 * @class   vtkIntervalVolumeRepresentation
 * @brief   shows unstructured grids in ParaView by vtkTimeWeightedTetrahedraMapper
 *
 * Input: a vtkUnstructuredGrid or a composite dataset of them; cells that are no tetrahedra are cut
 * into tetrahedra. Colour and opacity are ParaView's: the array to colour by, of points or cells,
 * with its colour and opacity functions, and the unit distance of the opacity. Without an array to
 * colour by, or where the data lack it, the solid colour is drawn with one opacity (see
 * vtkVolumeFunctions).
 *
 * With several processes the blend modes that need no order make one picture of all pieces,
 * wherever these are (see vtkTimeWeightedTetrahedraMapper::GatherPieces), the same as with one
 * process; so does COMPOSITE_BLEND of pieces in boxes that planes part, where the processes draw in
 * software. Elsewhere ParaView lays the pictures of the processes over each other for
 * COMPOSITE_BLEND, each rounded to 8 bits, and redistributes the tetrahedra before where the boxes
 * around pieces overlap; what straddles two regions is then drawn in one of them. Where the
 * processes cannot send each other grids (see vtkGridExchange), each draws its own; that, and
 * tetrahedra with an extent in time, which overlap and have no order, is warned of once. On a tiled
 * display pieces make no picture together, with a warning.
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
   * Set the functions of the array to colour by; all opacities are multiplied by Opacity, 0 to 1,
   * default 1.
   */
  void SetColor(vtkColorTransferFunction* color);
  void SetScalarOpacity(vtkPiecewiseFunction* opacity);
  void SetOpacity(double opacity);
  ///@}

  /**
   * Sets the colour without an array to colour by. Default white.
   */
  void SetSolidColor(double red, double green, double blue);

  /**
   * Sets the mapper, before the representation is in a view. ParaView sets its own values on it.
   * Default a new one.
   */
  void SetMapper(vtkTimeWeightedTetrahedraMapper* mapper);

  /**
   * The name of the point array with the extent in time. `DeltaT`, the default: that array where
   * the input has it, else 1 everywhere. The empty name: 1 everywhere.
   */
  void SetDeltaTArrayName(const char* name);

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

  using Superclass::GetInternalOutputPort;
  /// Returns a partitioned dataset as a collection of one, in which the superclass finds blocks.
  vtkAlgorithmOutput* GetInternalOutputPort(int port, int connection) override;

protected:
  vtkIntervalVolumeRepresentation();
  ~vtkIntervalVolumeRepresentation() override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkIntervalVolumeRepresentation(const vtkIntervalVolumeRepresentation&) = delete;
  void operator=(const vtkIntervalVolumeRepresentation&) = delete;

  /// Returns the array to colour by, null where the data that the mapper is given lack it.
  vtkDataArray* FindScalars();

  /// Has each process of several draw its own cells where the blend mode needs no order, or they
  /// are in order where they are, or sending them would change them.
  void KeepPieces(vtkInformation* view);
  /// Puts the pieces of several processes together where the blend mode needs no order, and warns
  /// where there is an order that they do not have.
  void GatherPieces(bool isReduced);
  /// Warns once of each text in a session.
  void WarnOnce(const std::string& text);
  /// Comes before each picture.
  void StartPicture();

  vtkSmartPointer<vtkTimeWeightedTetrahedraMapper> Mapper;
  vtkNew<vtkTrivialProducer> Collection;
  vtkWeakPointer<vtkRenderer> ViewRenderer;
  unsigned long Observer = 0;
  /// Whether the processes draw one picture together.
  bool IsOnePicture = false;
  /// Of the pieces of all processes: whether their boxes are apart, and whether they overlap in
  /// time.
  bool AreApart = true;
  bool AreInTime = false;
  std::unique_ptr<vtkVolumeFunctions> Functions;
  std::unique_ptr<vtkConstantScalars> Constant;
};

#endif
