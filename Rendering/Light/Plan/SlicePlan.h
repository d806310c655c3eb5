// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SlicePlan_h
#define interlume_SlicePlan_h

#include "Common/Vectors.h"
#include "Lights/LightSource.h"

#include <array>
#include <vector>

#include <glm/mat4x4.hpp>

namespace interlume
{

class UnitSpace;

/**
 * @class   SlicePlan
 * @brief   plan of the sweeps, their slices and the lights of each sweep
 *
 * A sweep traverses the slabs between parallel planes along their normal. All its lights shine
 * toward the same side of the planes. If the camera looks along the normal, the sweep runs front to
 * back, otherwise back to front.
 *
 * The normal for a single light is the half vector of the view and light directions if the light is
 * on the viewer's side, or of the opposite view direction and the light direction if the light is
 * behind the volume. It is rotated as far as the rays through the volume's corners require: its
 * cosine is at least ViewCosine with view rays (or their opposites) and at least LightCosine with
 * light rays, if such a normal exists. Several lights share a sweep if one normal meets these
 * bounds for all of them. The half vector is then that of the view direction, or its opposite, and
 * the average light direction (C. Zhang, dissertation, section 2.3.4).
 *
 * A positional light is *wide* if no normal gives it a cosine of at least WideCosine, for example
 * if it is inside the volume. Its light travels along the normal on one side of the slice plane
 * through it and against the normal on the other side, so it takes part in up to two sweeps. If it
 * is the only light of both, they draw two parts of one image, in front of and behind the light:
 * the sweep on the camera's side first, then the other sweep behind it. Otherwise, if a
 * back-to-front sweep that is not the first one has only wide lights, it starts at the first of
 * these lights, since it adds no opacity to the image, and no color before it reaches that light.
 *
 * The normals are continuous in the camera and the lights, unless the number of sweeps, their order
 * or the lights of a sweep change, for example when light and view are perpendicular. The image is
 * an integral that does not depend on the slice planes. Therefore such a change alters the image
 * only by the discretization error of slices and buffers.
 */
class SlicePlan
{
public:
  /// The camera, in unit space.
  struct Camera
  {
    bool IsParallel = false;
    glm::dvec3 Position{ 0.0, 0.0, 4.0 };
    /// View direction, a unit vector.
    glm::dvec3 Direction{ 0.0, 0.0, -1.0 };
    /// Matrix from unit space to clip coordinates.
    glm::dmat4 ClipFromUnit{ 0.0 };
  };

  /// Methods for the soft shadows of area lights.
  enum SoftMethods
  {
    /// Area lights are treated as lights without extent.
    HARD,
    LAYERS,
    CONVOLUTION
  };

  /// A sample of an area light's emitter, and the projection of its transmittance layer.
  struct SampleView
  {
    /// Same as ShadowedLight::BufferFromUnit, for a light at the sample.
    glm::dmat4 LayerFromUnit{ 0.0 };
    /// Fraction of the emitter's light, averaged over the three color channels.
    double Weight = 0.0;
    /// Homogeneous position in unit space; for a directional light, (direction to the light, 0).
    glm::dvec4 Source{ 0.0, 0.0, 0.0, 1.0 };
  };

  /// A light that casts shadows, and its buffer.
  struct ShadowedLight
  {
    /// Index in the list of lights.
    int Light = 0;
    /// Number of columns of the buffer, which equals its number of rows.
    int BufferSize = 0;
    /// If true, the buffer is an octahedral map of the directions in a half space; otherwise it is
    /// planar.
    bool IsWide = false;
    /// If the light is not wide, the matrix from unit space to clip coordinates of the buffer.
    /// After division by w, which is positive in front of the light, the buffer's x and y range
    /// from -1 to 1.
    glm::dmat4 BufferFromUnit{ 0.0 };
    /// If the light is not wide, length of the longer texel edge at the far end of the volumes, and
    /// length of a voxel along the axis of the buffer's projection.
    double TexelSize = 0.0;
    double VoxelLength = 0.0;
    /// Method of the light's soft shadows. Wide lights have hard shadows.
    SoftMethods SoftMethod = HARD;
    /// If SoftMethod is LAYERS, a view for each sample.
    std::vector<SampleView> Samples;
    /// The emitter's center, in the form of SampleView::Source.
    glm::dvec4 Center{ 0.0, 0.0, 0.0, 1.0 };
    /// For soft shadows: the rate, in texels per unit length along the normal, at which the shadows
    /// cast from an emitter sample and from the emitter's center diverge. Spread is the maximum of
    /// this rate over samples and volume corners. Divergence is the maximum of this rate times the
    /// squared distance from a positional light along the normal.
    double Spread = 0.0;
    double Divergence = 0.0;
    /// For wide lights, two directions in the slice plane and the sweep's normal, as rows.
    std::array<double, 9> Frame{};
  };

  struct Sweep
  {
    glm::dvec3 Normal{ 0.0, 0.0, -1.0 };
    bool IsFrontToBack = true;
    /// If true, the slabs are behind all slabs of the previous sweep, in the same image.
    bool IsBehind = false;
    /// Slab i contains the points x whose dot product x.Normal is between First + i * Spacing and
    /// First + (i + 1) * Spacing.
    double First = 0.0;
    double Spacing = 0.0;
    int Slabs = 0;
    std::vector<ShadowedLight> Lights;
  };

  /// A volume in the common unit space.
  struct SlicedVolume
  {
    const UnitSpace* Space = nullptr;
    /// The box that remains after cropping, in texture coordinates.
    std::array<std::array<double, 2>, 3> Box{};
    /// Slice spacing of this volume. If 0, the spacing of the settings is used.
    double Spacing = 0.0;
    /// Maximum extinction, in unit space, if opacity depends only on the scalar values, so that
    /// surfaces are opacity ramps; otherwise 0.
    double RampExtinction = 0.0;
  };

  struct Settings
  {
    /// Slice spacing in unit space. 0 selects an automatic spacing: AutomaticFactor times the
    /// larger of two lengths. One is GetVoxelSpacing along the normal. The other is GetVoxelSpacing
    /// along the view direction, times the cosine of the angle between view direction and normal.
    double Spacing = 0.0;
    double AutomaticFactor = 1.0;
    int BufferSize = 0;
    /// Minimum size of an automatic buffer (BufferSize 0).
    int MinimumBufferSize = 0;
    int LargestBufferSize = 8192;
    /// Number of texels per voxel in an automatic buffer, except for wide lights.
    double TexelsOfVoxel = 1.0;
    /// Number of pixels along the frame's shorter edge.
    int SmallerImageSize = 0;
    int MaximumNumberOfSlabs = 65536;
    int LightsOfSweep = 4;
    SoftMethods SoftMethod = HARD;
    /// Number of samples of each area light, for the method LAYERS.
    int Samples = 0;
  };

  /**
   * Creates the plan. \a lights are all lights; lights with a ShadowStrength above 0 get a buffer.
   * There is at least one sweep. Without shadows, it has no lights and its normal is the view
   * direction. \a box is the box that remains after cropping, in texture coordinates.
   */
  void Make(const Camera& eye, const std::vector<LightSource>& lights, const UnitSpace& space,
    const std::array<std::array<double, 2>, 3>& box, const Settings& settings);
  /// Creates the plan for one or more volumes drawn in shared slices. Sweeps traverse all volumes
  /// with the finest of their spacings. A light's buffer encloses all volumes, and the finest
  /// voxels determine the size of its texels.
  void Make(const Camera& eye, const std::vector<LightSource>& lights,
    const std::vector<SlicedVolume>& volumes, const Settings& settings);

  std::vector<Sweep> Sweeps;
  /// Indices of the area lights that cannot use the soft method of the settings: they are wide, or
  /// slices are seen edge-on from part of the emitter.
  std::vector<int> NotSoft;

  /// Returns true if the sweep belongs to the first image, which contains the opacity and all light
  /// without shadows. The colors of other images are added to it.
  bool IsInFirstImage(std::size_t sweep) const
  {
    return sweep == 0 || (sweep == 1 && this->Sweeps[1].IsBehind);
  }
  /// Returns true if the sweep is the last one of its image.
  bool IsLastInImage(std::size_t sweep) const
  {
    return sweep + 1 == this->Sweeps.size() || !this->Sweeps[sweep + 1].IsBehind;
  }
  /// Returns true if there is more than one image.
  bool HasMultipleImages() const { return !this->IsInFirstImage(this->Sweeps.size() - 1); }

  /// Minimum cosine between a sweep's normal and the view rays, if achievable.
  static constexpr double ViewCosine = 0.5;
  /// Minimum cosine between a sweep's normal and the light rays, if achievable.
  static constexpr double LightCosine = 0.35;
  /// A positional light is wide if one of its rays has a smaller cosine than this with the best
  /// normal for the light.
  static constexpr double WideCosine = 0.2;
  /// Minimum cosine between the normal and rays from any point of an emitter.
  static constexpr double SampleCosine = 0.1;
  /// Optical depth of a slab above which opacity ramps are assumed to be no wider than a buffer's
  /// texels. In a thinner medium, integrating extinction along a ramp would shift the edges of
  /// faint shadows.
  static constexpr double DenseDepth = 1.0;

  /// Returns the length of a line along \a normal within a voxel: 1 / sqrt(sum (n_i / voxel_i)^2),
  /// with the components n_i of \a normal and the voxel size along the volume's axes.
  static double GetVoxelSpacing(const UnitSpace& space, const glm::dvec3& normal);
  /// Returns the slice spacing along \a normal that a volume requests.
  static double GetSpacing(const SlicedVolume& volume, const glm::dvec3& normal,
    const glm::dvec3& direction, const Settings& settings);

  /// Returns the position, from 0 to 1, of a direction d in a wide light's buffer, which is an
  /// octahedral map of the half space d.n >= 0. If (e1, e2, n) are the rows of \a frame and p =
  /// (d.e1, d.e2) / (|d.e1| + |d.e2| + d.n), the position is (p.x + p.y, p.x - p.y) / 2 + 1/2.
  static std::array<double, 2> GetBufferPosition(
    const std::array<double, 9>& frame, const glm::dvec3& direction);
  /// Returns the unit direction at a position in the buffer.
  static glm::dvec3 GetBufferDirection(
    const std::array<double, 9>& frame, const std::array<double, 2>& position);
};

}

#endif
