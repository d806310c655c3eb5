// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPieceSliceMapper_h
#define vtkPieceSliceMapper_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkPieceLight.h"                  // for the lights
#include "vtkShadowedSliceMapper.h"

#include <map>    // for the lights
#include <memory> // for the grid

class vtkExtinctionGrid;
class vtkMultiProcessController;
class vtkVolumeProperty;

/**
 * @class   vtkPieceSliceMapper
 * @brief   render one piece of a volume with shadows from the pieces of other processes
 *
 * During rendering, each light that casts shadows is replaced by its vtkPieceLight. The mapper
 * renders like its superclass if GatherPieces was not called, or if the medium of all other
 * processes is transparent.
 */
class INTERLUMEREPRESENTATIONS_EXPORT vtkPieceSliceMapper : public vtkShadowedSliceMapper
{
public:
  static vtkPieceSliceMapper* New();
  vtkTypeMacro(vtkPieceSliceMapper, vtkShadowedSliceMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Compute a grid of the extinction of all pieces, with \a resolution cells along the longest
   * edge, if the data, the mapper or the property of any process changed. All processes of \a
   * controller must call it together. A resolution of 0 removes the grid.
   */
  void GatherPieces(
    vtkVolumeProperty* property, int resolution, vtkMultiProcessController* controller);

  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

protected:
  vtkPieceSliceMapper();
  ~vtkPieceSliceMapper() override;

private:
  vtkPieceSliceMapper(const vtkPieceSliceMapper&) = delete;
  void operator=(const vtkPieceSliceMapper&) = delete;

  std::unique_ptr<vtkExtinctionGrid> Grid;
  unsigned long Version = 0;
  /// Modification time and resolution for which the grid was computed.
  vtkMTimeType GridTime = 0;
  int GridResolution = 0;
  std::map<vtkLight*, vtkPieceLight> Lights;
};

#endif
