// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SlicePlan_h
#define interlume_SlicePlan_h

#include "Common/Vectors.h"
#include "Lights/LightSource.h" // for the lights

#include <array>
#include <vector>

#include <glm/mat4x4.hpp>

namespace interlume
{

class UnitSpace;

/**
 * @class   SlicePlan
 * @brief   which slices are drawn in which order, for which lights
 *
 * A sweep goes through the slabs of one set of parallel planes along their normal; light goes the
 * same way in all of its lights. Where the eye looks along the normal too, the sweep is from front
 * to back, else from back to front.
 *
 * One light, one sweep: its normal is the half vector of view and light where the light is on the
 * viewer's side, and of view and the light's opposite where it is behind the volume, turned as far
 * as the rays through the corners of the volume need it: wherever that can be had the eye's make a
 * cosine of at least EyeCosine with the normal, and the lights' one of at least LightCosine.
 * Several lights share a sweep as long as the average vector (2.3.4) leaves all of them and the eye
 * these angles; lights that no normal serves together have sweeps of their own. A positional light
 * that no normal gives a cosine of at least WideCosine, as one in whose plane some of the volume
 * lies, is *wide*: it shines along the normal on one side of that plane, and against it on the
 * other, and takes part in one sweep for each side on which there is something of the volume. Where
 * it has both sweeps for itself they are halves of one picture, cut at the light: first from there
 * to the eye, then away from the eye, behind what is drawn. Else a sweep from back to front begins
 * at its first light if all are wide: it adds no opacity to the picture, and before that light it
 * has no colour.
 *
 * A small change of eye or light changes normals by little, except where it changes the number of
 * sweeps, their sides, or the lights that share one, as where light and view are perpendicular.
 * What slices show is an integral that does not depend on the choice of planes: such a change moves
 * the picture by the error of the slices (their distance and the size of the buffers), by no more.
 */
class SlicePlan
{
public:
  /// The eye, in unit space.
  struct Eye
  {
    bool IsParallel = false;
    glm::dvec3 Position{ 0.0, 0.0, 4.0 };
    /// Length 1.
    glm::dvec3 Direction{ 0.0, 0.0, -1.0 };
    /// From unit space to clip coordinates.
    glm::dmat4 ClipFromUnit{ 0.0 };
  };

  /// How soft shadows of area lights are planned.
  enum SoftMethods
  {
    /// Area lights are lights without extent.
    HARD,
    LAYERS,
    CONVOLUTION
  };

  /// A sample of an area light's emitter, with its layer of transmittance.
  struct SampleView
  {
    /// A matrix as BufferFromUnit of ShadowedLight, for the light at the sample.
    glm::dmat4 LayerFromUnit{ 0.0 };
    /// Its share of the light, the mean over the three channels.
    double Weight = 0.0;
    /// Its place and 1 in unit space; where light comes from and 0 without a place.
    glm::dvec4 Source{ 0.0, 0.0, 0.0, 1.0 };
  };

  /// A light with its buffer.
  struct ShadowedLight
  {
    /// The index in the list of lights.
    int Light = 0;
    /// The number of columns and rows of the buffer.
    int BufferSize = 0;
    /// Whether its buffer holds directions of a half space (octahedral) instead of a plane.
    bool IsWide = false;
    /// For lights that are not wide, the matrix from unit space to clip coordinates of the buffer,
    /// -1 to 1 after division by the fourth, which is above 0 in front of the light.
    glm::dmat4 BufferFromUnit{ 0.0 };
    /// For lights that are not wide, the longer edge of a texel where it is largest in the volume,
    /// and the length of a voxel along the light.
    double TexelSize = 0.0;
    double VoxelLength = 0.0;
    /// How the light's shadows are made soft; hard for wide lights.
    SoftMethods SoftMethod = HARD;
    /// For layers, one view for each sample, and how far a sample's shadow goes from the centre's,
    /// in texels, on its way through a distance of 1 along the normal: the most in the volume, and
    /// the most of it times the square of the distance from a positional light.
    std::vector<SampleView> Samples;
    /// The emitter's centre, as Source of a sample.
    glm::dvec4 Center{ 0.0, 0.0, 0.0, 1.0 };
    double Spread = 0.0;
    double Divergence = 0.0;
    /// For wide lights, two directions in the slices' plane and the sweep's normal, as rows.
    std::array<double, 9> Frame{};
  };

  struct Sweep
  {
    glm::dvec3 Normal{ 0.0, 0.0, -1.0 };
    bool IsFrontToBack = true;
    /// Whether its slabs lie behind all of the sweep before, in the same picture.
    bool IsBehind = false;
    /// Slab i is First + i Spacing <= x.Normal <= First + (i + 1) Spacing.
    double First = 0.0;
    double Spacing = 0.0;
    int Slabs = 0;
    std::vector<ShadowedLight> Lights;
  };

  /// A volume in the common unit space.
  struct Matter
  {
    const UnitSpace* Space = nullptr;
    /// The part with something to see, in texture coordinates.
    std::array<std::array<double, 2>, 3> Box{};
    /// The spacing of slices that this volume asks for; 0 stands for that of the settings.
    double Spacing = 0.0;
    /// The largest extinction in unit space of matter whose surfaces are ramps of opacity;
    /// otherwise 0.
    double RampExtinction = 0.0;
  };

  struct Settings
  {
    /// The spacing of slices in unit space; 0 stands for GetVoxelSpacing times AutomaticFactor, of
    /// the normal or, where that is more, of the direction of view times its cosine with the
    /// normal.
    double Spacing = 0.0;
    double AutomaticFactor = 1.0;
    int BufferSize = 0;
    /// The least size where BufferSize is 0.
    int LeastBufferSize = 0;
    int LargestBufferSize = 8192;
    /// The number of an automatic buffer's columns for each voxel, but for lights within the
    /// volume.
    double TexelsOfVoxel = 1.0;
    /// The number of pixels along the picture's shorter edge.
    int PictureSize = 0;
    int MaximumNumberOfSlabs = 65536;
    int LightsOfSweep = 4;
    SoftMethods SoftMethod = HARD;
    /// The number of samples of each area light, for layers.
    int Samples = 0;
  };

  /**
   * Makes the plan. \a lights are all that shine; those with a ShadowStrength above 0 get a buffer.
   * There is at least one sweep, the first one, with no lights where none has shadows; its normal
   * is then the direction of view. \a box is the part of the volume with something to see, in
   * texture coordinates.
   */
  void Make(const Eye& eye, const std::vector<LightSource>& lights, const UnitSpace& space,
    const std::array<std::array<double, 2>, 3>& box, const Settings& settings);
  /// Makes the plan of volumes whose slices are drawn together, at least one: sweeps go through all
  /// of them with the finest spacing that one asks for, and a light's buffer is around all of them
  /// with texels as fine as the finest voxels.
  void Make(const Eye& eye, const std::vector<LightSource>& lights,
    const std::vector<Matter>& matter, const Settings& settings);

  std::vector<Sweep> Sweeps;
  /// The area lights, by their index, that cannot have the soft method of the settings: they are
  /// wide, or slices are seen edge-on from some of the emitter.
  std::vector<int> NotSoft;

  /// Whether the sweep is of the first picture, which has the opacity and all light that casts no
  /// shadows; other pictures' colours are added to it.
  bool IsOfFirstPicture(std::size_t sweep) const
  {
    return sweep == 0 || (sweep == 1 && this->Sweeps[1].IsBehind);
  }
  /// Whether the sweep is the last one of its picture.
  bool IsLastOfPicture(std::size_t sweep) const
  {
    return sweep + 1 == this->Sweeps.size() || !this->Sweeps[sweep + 1].IsBehind;
  }
  /// Whether there is more than one picture.
  bool HasFurtherPictures() const { return !this->IsOfFirstPicture(this->Sweeps.size() - 1); }

  /// Least cosines between a sweep's normal and the rays of the eye and of lights, and the least of
  /// a light that is not wide.
  static constexpr double EyeCosine = 0.5;
  static constexpr double LightCosine = 0.35;
  static constexpr double WideCosine = 0.2;
  /// The least cosine of rays from all of an emitter with the normal.
  static constexpr double SampleCosine = 0.1;
  /// The optical depth of a slab from which on the surfaces of matter are ramps as narrow as the
  /// texels of light buffers. In thinner matter interpolation along a ramp would move edges of
  /// faint shadows.
  static constexpr double DenseDepth = 1.0;

  /// Distance of slices that is one voxel along \a normal: the length within a voxel of a line
  /// along it, 1 / sqrt(sum (n_i / voxel_i)^2) in the volume's own axes.
  static double GetVoxelSpacing(const UnitSpace& space, const glm::dvec3& normal);
  /// The spacing of slices along \a normal that a volume asks for.
  static double GetSpacing(const Matter& matter, const glm::dvec3& normal,
    const glm::dvec3& direction, const Settings& settings);

  /// Returns the place of direction d of the half space d.n >= 0 in the buffer of a wide light, 0
  /// to 1: with (e1, e2, n) the rows of \a frame and p = (d.e1, d.e2) / (|d.e1| + |d.e2| + d.n),
  /// this is ((p.x + p.y), (p.x - p.y)) / 2 + 1/2 (the octahedral map).
  static std::array<double, 2> GetBufferPlace(
    const std::array<double, 9>& frame, const glm::dvec3& direction);
  /// The direction, of length 1, that has this place.
  static glm::dvec3 GetBufferDirection(
    const std::array<double, 9>& frame, const std::array<double, 2>& place);
};

}

#endif
