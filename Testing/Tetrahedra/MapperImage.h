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

class VolumeStage;

/**
 * A volume to render with a mapper and with the reference implementation.
 */
struct ImageCase
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  vtkSmartPointer<vtkVolumeProperty> Property;
  vtkSmartPointer<vtkCamera> Camera;
  CameraSettings Settings;
  /// Opaque actors. The reference implementation uses Settings.OpaqueDistance instead.
  std::vector<vtkSmartPointer<vtkActor>> Actors;
};

/// Returns a case in which the camera looks at \a grid along \a direction.
ImageCase MakeCase(vtkUnstructuredGrid* grid, vtkVolumeProperty* property,
  const std::array<double, 3>& direction, bool parallel,
  const std::array<int, 2>& size = { { 96, 96 } });

/// Passes the grid, the arrays, the blend and integration modes, and the layer priorities to a
/// mapper.
void Configure(vtkTimeWeightedTetrahedraMapper* mapper, const ImageCase& what);

/// Configures the mapper and returns the floating-point image that it renders.
RgbaImage DrawByMapper(vtkTimeWeightedTetrahedraMapper* mapper, const ImageCase& what);
/// Returns the image of a new mapper with the given render path.
RgbaImage DrawByPath(int path, const ImageCase& what);
/// Renders the same image on a stage that is reused, since a new window compiles its shaders again.
RgbaImage DrawByPath(int path, const ImageCase& what, VolumeStage& stage);
/// Returns the image of vtkProjectedTetrahedraMapper. Only the scalars of the settings are used.
RgbaImage DrawWithVtkMapper(const ImageCase& what);
RgbaImage DrawReference(const ImageCase& what);

/// Adds a slanted, opaque plane that fills the image. It passes through the camera's focal point,
/// moved by \a behind along the view direction.
void AddPlane(ImageCase& what, double behind, const std::array<double, 3>& color);

const std::vector<int>& AllRenderPaths();
std::string GetPathName(int path);

}

#endif
