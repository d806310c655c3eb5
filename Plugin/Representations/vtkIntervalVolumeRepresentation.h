#ifndef vtkIntervalVolumeRepresentation_h
#define vtkIntervalVolumeRepresentation_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkNew.h"                         // for the mapper
#include "vtkUnstructuredGridVolumeRepresentation.h"

class vtkTimeWeightedTetrahedraMapper;

/**
 * @class   vtkIntervalVolumeRepresentation
 * @brief   shows unstructured grids in ParaView by vtkTimeWeightedTetrahedraMapper
 *
 * Input: a vtkUnstructuredGrid or a composite dataset of them; cells that are no tetrahedra are cut
 * into tetrahedra. Colour and opacity are ParaView's: the array to colour by, of points or cells,
 * with its colour and opacity functions, and the unit distance of the opacity. Without an array to
 * colour by nothing is drawn. The other setters are those of the mapper, with its defaults.
 *
 * With several processes ParaView redistributes the tetrahedra and composites the pictures of the
 * processes in order. That is exact for COMPOSITE_BLEND alone: the other blend modes, and
 * overlapping tetrahedra with an extent in time, are right within what one process draws.
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
   * Passed on to the mapper.
   */
  void SetBlendMode(int mode);
  void SetIntegrationMode(int mode);
  void SetSortMode(int mode);
  void SetRenderPath(int path);
  void SetAutoAdjustLevelOfDetail(bool adjust);
  void SetLayerArrayName(const char* name);
  void AddLayerPriority(int layer, double priority);
  void RemoveAllLayerPriorities();
  ///@}

  /**
   * Name of the point array with the extent in time. `DeltaT`, the default: that array where the
   * input has it, else 1 everywhere. The empty name: 1 everywhere.
   */
  void SetDeltaTArrayName(const char* name);

protected:
  vtkIntervalVolumeRepresentation();
  ~vtkIntervalVolumeRepresentation() override;

  void UpdateMapperParameters() override;

private:
  vtkIntervalVolumeRepresentation(const vtkIntervalVolumeRepresentation&) = delete;
  void operator=(const vtkIntervalVolumeRepresentation&) = delete;

  vtkNew<vtkTimeWeightedTetrahedraMapper> Mapper;
};

#endif
