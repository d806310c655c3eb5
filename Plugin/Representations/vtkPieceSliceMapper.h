// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPieceSliceMapper_h
#define vtkPieceSliceMapper_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkPieceLight.h"                  // for the lights
#include "vtkShadowedSliceMapper.h"

#include <map>    // for the lights
#include <memory> // for the grid

class vtkMatterGrid;
class vtkMultiProcessController;
class vtkVolumeProperty;

/**
 * @class   vtkPieceSliceMapper
 * @brief   draws one piece of a volume in the light that the pieces of other processes leave
 *
 * While the piece is drawn, each light that casts shadows is replaced by its vtkPieceLight. Without
 * GatherPieces, and where other processes have no matter, it draws as its superclass does.
 */
class INTERLUMEREPRESENTATIONS_EXPORT vtkPieceSliceMapper : public vtkShadowedSliceMapper
{
public:
  static vtkPieceSliceMapper* New();
  vtkTypeMacro(vtkPieceSliceMapper, vtkShadowedSliceMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Exchanges a grid of the matter of all pieces, with \a resolution cells along the longest edge,
   * where any process has changed its matter since. All processes of \a controller must call it
   * together. With a resolution of 0 there is no grid.
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

  std::unique_ptr<vtkMatterGrid> Grid;
  unsigned long Version = 0;
  /// Of what the grid was made.
  vtkMTimeType GridTime = 0;
  int GridResolution = 0;
  std::map<vtkLight*, vtkPieceLight> Lights;
};

#endif
