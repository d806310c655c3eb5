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
 * What scenes of volumes in light and shadow share: objects, how matter looks, lights, pairs.
 */
namespace gallery
{
class Panel;
class Stage;

using Lights = std::vector<vtkSmartPointer<vtkLight>>;

///@{
/**
 * A box from \a lower to \a upper, and a disk of \a thickness whose upper side lies on \a top: a
 * ground that catches shadows.
 */
vtkSmartPointer<vtkSpatialPrimitive> MakeBox(
  const vtkVector3d& lower, const vtkVector3d& upper, const vtkColor3d& colour);
vtkSmartPointer<vtkSpatialPrimitive> MakeDisk(
  const vtkVector3d& top, double radius, double thickness, const vtkColor3d& colour);
///@}

/// Colour of grounds and walls.
vtkColor3d Plaster();

/// A copy of \a object moved by \a offset and turned by \a degrees around the z axis before.
vtkSmartPointer<vtkSpatialObject> Place(
  vtkSpatialObject* object, const vtkVector3d& offset, double degrees = 0.0);

/// The union of \a objects; where they are equally dense, the first is seen.
vtkSmartPointer<vtkSpatialObject> Unite(
  const std::vector<vtkSmartPointer<vtkSpatialObject>>& objects);

/// Over which distance the edges of boxes and disks are soft, and a good one for Soften().
constexpr double EDGE_WIDTH = 0.02;

/**
 * Gives all solids that \a object consists of edges of \a width, so that normals of their surfaces
 * do not show the lattice they are sampled on. Returns \a object.
 */
vtkSmartPointer<vtkSpatialObject> Soften(vtkSpatialObject* object, double width = EDGE_WIDTH);

/**
 * Samples \a object within \a box on a lattice of \a resolution points along the longest side, as
 * unsigned char `Color`: red, green, blue, density; smoothed by a Gaussian of \a blur voxels.
 */
vtkSmartPointer<vtkImageData> Sample(
  vtkSpatialObject* object, const vtkBoundingBox& box, int resolution, double blur = 1.1);

/**
 * The scalars of \a image as an object: density 0 to 1 for \a lower to \a upper, so that the
 * surface is half way between. Colours are those of the largest value within two samples: that of
 * what is under a surface, not of its edge.
 */
vtkSmartPointer<vtkSpatialImage> MakeImageObject(
  vtkImageData* image, double lower, double upper, vtkColorTransferFunction* colours);

///@{
/**
 * Adds smoke, its density times \a share, to the `Color` of \a image where that is thinner:
 * turbulence within \a box, everywhere if that is empty, which gets the image's lattice; or an
 * object.
 */
void AddSmoke(vtkImageData* image, vtkTurbulenceSource* smoke, double share,
  const vtkColor3d& colour, const vtkBoundingBox& box = vtkBoundingBox());
void AddSmoke(vtkImageData* image, vtkSpatialObject* smoke, double share, const vtkColor3d& colour);
///@}

///@{
/**
 * How the matter of Sample() looks, shaded. The opacities are those of \a unit, a length. Solid
 * matter is that of a density above one half, opaque within a voxel; up to a quarter the density is
 * that of smoke, of \a opacity in a voxel at a quarter.
 */
vtkSmartPointer<vtkVolumeProperty> MakeColouredMatter(vtkPiecewiseFunction* opacity, double unit);
vtkSmartPointer<vtkVolumeProperty> MakeSolidMatter(vtkImageData* image);
vtkSmartPointer<vtkVolumeProperty> MakeSolidMatterInSmoke(vtkImageData* image, double opacity);
///@}

/// From which gradient on matter is a surface where there is smoke too, see
/// vtkShadowedSliceMapper::SetSurfaceGradient.
constexpr double SMOKE_GRADIENT = 0.03;

/**
 * \a image as a volume that vtkShadowedSliceMapper draws, with slices half a voxel apart.
 */
vtkSmartPointer<vtkVolume> MakeSlicedVolume(
  vtkImageData* image, vtkVolumeProperty* property, double surfaceGradient = 0.0);

/**
 * The mapper of a volume made by MakeSlicedVolume().
 */
vtkShadowedSliceMapper* GetSlicedMapper(vtkVolume* volume);

/// What matter in the soft edge of a surface takes from the light before it is seen; lights that
/// cast shadows are that much stronger, so that lit surfaces look the same without and with.
constexpr double EDGE_GAIN = 1.7;

///@{
/**
 * A light at a place, shining everywhere, and one from far away out of direction \a from.
 */
vtkSmartPointer<vtkLight> MakePointLight(const vtkVector3d& position, double intensity);
vtkSmartPointer<vtkLight> MakeParallelLight(const vtkVector3d& from, double intensity);
///@}

/**
 * A point light that casts shadows, EDGE_GAIN times \a intensity, and a weak one from the other
 * side and behind the viewer that casts none, so that form reads in the shadow too.
 */
Lights MakeStudioLights(const vtkVector3d& position, double intensity = 1.0);

/// The two panels of a pair.
struct ShadowPair
{
  Panel& Without;
  Panel& With;

  /// Both from the same side, framed alike; up is z.
  void Look(const vtkVector3d& from, const vtkBoundingBox& frame) const;
};

/**
 * Adds \a image as it is without and with shadows, at the same camera. Without shadows the lights
 * that cast them are weaker by EDGE_GAIN. The captions begin with \a caption.
 */
ShadowPair AddShadowPair(Stage& stage, vtkImageData* image, vtkVolumeProperty* property,
  const Lights& lights, double surfaceGradient = 0.0, const std::string& caption = "");

/**
 * Adds \a image with shadows.
 */
Panel& AddShadowPanel(Stage& stage, vtkImageData* image, vtkVolumeProperty* property,
  const Lights& lights, double surfaceGradient = 0.0);
}

#endif
