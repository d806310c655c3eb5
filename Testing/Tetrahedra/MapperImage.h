// SPDX-License-Identifier: BSD-3-Clause
#ifndef MapperImage_h
#define MapperImage_h

#include "Support/Images/ReferenceVolumeImage.h" // for the settings

#include "vtkSmartPointer.h" // for the data

#include <array>  // for directions
#include <string> // for names
#include <vector> // for actors

class vtkActor;
class vtkCamera;
class vtkTimeWeightedTetrahedraMapper;
class vtkUnstructuredGrid;
class vtkVolumeProperty;

namespace reference
{

/**
 * A volume to render with a mapper and with the reference implementation.
 */
struct ImageCase
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  vtkSmartPointer<vtkVolumeProperty> Property;
  vtkSmartPointer<vtkCamera> Camera;
  CameraSettings Settings;
  /// Opaque actors. The reference reads their depth from Settings.OpaqueDistance.
  std::vector<vtkSmartPointer<vtkActor>> Actors;
};

/// Returns a case in which the camera looks at \a grid along \a direction.
ImageCase MakeCase(vtkUnstructuredGrid* grid, vtkVolumeProperty* property,
  const std::array<double, 3>& direction, bool parallel,
  const std::array<int, 2>& size = { { 96, 96 } });

/// Passes the grid and the settings to a mapper: arrays, blend and integration mode, priorities.
void Configure(vtkTimeWeightedTetrahedraMapper* mapper, const ImageCase& what);

/// Configures the mapper and returns its floating-point image.
RgbaImage DrawByMapper(vtkTimeWeightedTetrahedraMapper* mapper, const ImageCase& what);
/// Returns the image of a new mapper with the given render path.
RgbaImage DrawByPath(int path, const ImageCase& what);
/// Returns the image of vtkProjectedTetrahedraMapper, which uses only the scalars of the settings.
RgbaImage DrawByVtkMapper(const ImageCase& what);
RgbaImage DrawByReference(const ImageCase& what);

/// Returns the tested render paths.
const std::vector<int>& AllRenderPaths();
std::string GetPathName(int path);

}

#endif
