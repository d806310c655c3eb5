// SPDX-License-Identifier: BSD-3-Clause
#ifndef MapperPicture_h
#define MapperPicture_h

#include "Support/Pictures/ReferenceVolumePicture.h" // for the settings

#include "vtkSmartPointer.h" // for what is drawn

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
 * Something to be drawn by a mapper and by the reference.
 */
struct PictureCase
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  vtkSmartPointer<vtkVolumeProperty> Property;
  vtkSmartPointer<vtkCamera> Camera;
  PictureSettings Settings;
  /// Opaque; the reference knows them by Settings.OpaqueDistance.
  std::vector<vtkSmartPointer<vtkActor>> Actors;
};

/// \a grid seen from \a direction.
PictureCase MakeCase(vtkUnstructuredGrid* grid, vtkVolumeProperty* property,
  const std::array<double, 3>& direction, bool parallel,
  const std::array<int, 2>& size = { { 96, 96 } });

/// Gives a mapper the grid and the settings: arrays, blend and integration mode, priorities.
void Configure(vtkTimeWeightedTetrahedraMapper* mapper, const PictureCase& what);

/// The picture by the mapper, configured, in floating point.
RgbaPicture DrawByMapper(vtkTimeWeightedTetrahedraMapper* mapper, const PictureCase& what);
/// The same by a new mapper with one of its render paths.
RgbaPicture DrawByPath(int path, const PictureCase& what);
/// The picture by vtkProjectedTetrahedraMapper, which has nothing but the scalars of the settings.
RgbaPicture DrawByPeer(const PictureCase& what);
RgbaPicture DrawByReference(const PictureCase& what);

/// The render paths that are tested, and what they are called.
const std::vector<int>& AllRenderPaths();
std::string GetPathName(int path);

}

#endif
