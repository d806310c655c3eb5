// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowScene_h
#define ShadowScene_h

#include "vtkBoundingBox.h"
#include "vtkColor.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkSmartPointer.h"
#include "vtkSpatialImage.h"
#include "vtkSpatialObject.h"
#include "vtkSpatialPrimitive.h"
#include "vtkVector.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <string>
#include <vector>

class vtkColorTransferFunction;
class vtkPiecewiseFunction;
class vtkShadowedSliceMapper;
class vtkTurbulenceSource;

/**
 * Support for scenes with shadows in volumes: objects, media, lights, pairs of panels.
 */
namespace gallery
{
class Panel;
class Stage;

using Lights = std::vector<vtkSmartPointer<vtkLight>>;

///@{
/**
 * MakeBox() returns a box from \a lower to \a upper. MakeDisk() returns a disk of \a thickness
 * whose upper side is centered at \a top, for use as the ground.
 */
vtkSmartPointer<vtkSpatialPrimitive> MakeBox(
  const vtkVector3d& lower, const vtkVector3d& upper, const vtkColor3d& color);
vtkSmartPointer<vtkSpatialPrimitive> MakeDisk(
  const vtkVector3d& top, double radius, double thickness, const vtkColor3d& color);
///@}

/// Returns a color for the ground and walls.
vtkColor3d PlasterColor();

/// Returns a floor whose upper side is at \a height and that extends past the sides of every
/// volume. Frame it so that only its far edge is in view.
vtkSmartPointer<vtkSpatialPrimitive> MakeFloor(const vtkColor3d& color, double height = 0.0);

/// Returns \a object, rotated by \a degrees around the z axis and then moved by \a offset.
vtkSmartPointer<vtkSpatialObject> Place(
  vtkSpatialObject* object, const vtkVector3d& offset, double degrees = 0.0);

/// Returns the union of \a objects. Where densities are equal, the union has the color of the first
/// object.
vtkSmartPointer<vtkSpatialObject> Unite(
  const std::vector<vtkSmartPointer<vtkSpatialObject>>& objects);

/// Width of the soft edges of boxes and disks, and the default of SoftenEdges().
constexpr double EDGE_WIDTH = 0.02;

/**
 * Sets the edge width of all primitives in \a object, and returns \a object. Soft edges prevent
 * artifacts of the sampling grid in normals.
 */
vtkSmartPointer<vtkSpatialObject> SoftenEdges(vtkSpatialObject* object, double width = EDGE_WIDTH);

/**
 * Samples \a object within \a box on a grid of \a resolution points along the longest side. Returns
 * an image with the unsigned char array `Color`: red, green, blue, density. The array is smoothed
 * by a Gaussian with a standard deviation of \a blur voxels.
 */
vtkSmartPointer<vtkImageData> Sample(
  vtkSpatialObject* object, const vtkBoundingBox& box, int resolution, double blur = 1.1);

/**
 * Returns the scalars of \a image as an object. The density rises from 0 to 1 for scalars from
 * \a lower to \a upper, so the surface is halfway between them. Each sample has the color of the
 * maximum scalar within a distance of two samples, so that the edge of an object has the color of
 * its interior.
 */
vtkSmartPointer<vtkSpatialImage> MakeImageObject(
  vtkImageData* image, double lower, double upper, vtkColorTransferFunction* colors);

///@{
/**
 * Add \a smoke to the array `Color` of \a image wherever the smoke is denser than the image. The
 * density of the smoke is first multiplied by \a fraction. The first overload sets the grid of
 * \a smoke to that of \a image, and adds smoke only in \a box, or everywhere if \a box is invalid.
 */
void AddSmoke(vtkImageData* image, vtkTurbulenceSource* smoke, double fraction,
  const vtkColor3d& color, const vtkBoundingBox& box = vtkBoundingBox());
void AddSmoke(
  vtkImageData* image, vtkSpatialObject* smoke, double fraction, const vtkColor3d& color);
///@}

///@{
/**
 * Return a shaded medium for images created by Sample(). In MakeColoredMedium(), \a opacity is a
 * function of density (0 to 255), per distance \a unit. In the other two functions, densities above
 * one half are solid and opaque within a voxel. In MakeSolidMediumInSmoke(), densities up to one
 * quarter are smoke, and \a opacity is the opacity per voxel at a density of one quarter.
 */
vtkSmartPointer<vtkVolumeProperty> MakeColoredMedium(vtkPiecewiseFunction* opacity, double unit);
vtkSmartPointer<vtkVolumeProperty> MakeSolidMedium(vtkImageData* image);
vtkSmartPointer<vtkVolumeProperty> MakeSolidMediumInSmoke(vtkImageData* image, double opacity);
///@}

/// Surface gradient for media that contain smoke, see vtkShadowedSliceMapper::SetSurfaceGradient.
constexpr double SMOKE_GRADIENT = 0.03;

/**
 * Returns \a image as a volume rendered by vtkShadowedSliceMapper, with a slice spacing of half a
 * voxel.
 */
vtkSmartPointer<vtkVolume> MakeSlicedVolume(
  vtkImageData* image, vtkVolumeProperty* property, double surfaceGradient = 0.0);

/**
 * Returns the mapper of a volume created by MakeSlicedVolume().
 */
vtkShadowedSliceMapper* GetSlicedMapper(vtkVolume* volume);

/// Reciprocal of the light's transmittance through the soft edge of a surface. Shadow-casting
/// lights are stronger by this factor, so that lit surfaces are equally bright without and with
/// shadows.
constexpr double EDGE_GAIN = 1.7;

///@{
/**
 * MakePointLight() returns a point light that shines in all directions. MakeParallelLight() returns
 * a directional light from direction \a from.
 */
vtkSmartPointer<vtkLight> MakePointLight(const vtkVector3d& position, double intensity);
vtkSmartPointer<vtkLight> MakeParallelLight(const vtkVector3d& from, double intensity);
///@}

/**
 * Returns a shadow-casting point light of EDGE_GAIN times \a intensity, and a weak fill light from
 * the other side that casts no shadows, so that shapes in shadow remain visible. The point light is
 * slightly yellow, the fill light slightly blue.
 */
Lights MakeStudioLights(const vtkVector3d& position, double intensity = 1.0);

/// Two panels of the same volume, without and with shadows.
struct ShadowPair
{
  Panel& Without;
  Panel& With;

  /// Sets the same view direction and framing in both panels. z is up.
  void Look(const vtkVector3d& from, const vtkBoundingBox& frame) const;

  /// Sets the same gradient as the background of both panels.
  void SetBackground(const vtkColor3d& lower, const vtkColor3d& upper) const;
};

/**
 * Adds two panels of \a image, without and with shadows. ShadowPair::Look() gives them a common
 * camera. In the panel without shadows, the intensity of shadow-casting lights is divided by
 * EDGE_GAIN. \a caption is a prefix of both captions.
 */
ShadowPair AddShadowPair(Stage& stage, vtkImageData* image, vtkVolumeProperty* property,
  const Lights& lights, double surfaceGradient = 0.0, const std::string& caption = "");

/**
 * Adds a panel of \a image with shadows.
 */
Panel& AddShadowPanel(Stage& stage, vtkImageData* image, vtkVolumeProperty* property,
  const Lights& lights, double surfaceGradient = 0.0);
}

#endif
