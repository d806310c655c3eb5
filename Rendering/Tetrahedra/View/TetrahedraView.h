// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraView_h
#define interlume_TetrahedraView_h

#include "Common/Vectors.h"
#include "Mesh/TetrahedraMesh.h"
#include "View/ViewRays.h"

#include <array>
#include <string>

class vtkRenderer;
class vtkVolume;

namespace interlume
{

/**
 * @class   TetrahedraView
 * @brief   projects the mesh's coordinates to pixels and depths
 *
 * Along a pixel's line of sight every face of a tetrahedron has a depth that is affine in the
 * pixel, if depth d is 1/z in perspective and -z in parallel, z the distance along the view axis:
 * the larger the nearer. There v d is affine for an attribute v in perspective, and v itself in
 * parallel. Lengths are in units of the mesh's coordinates as they appear in the world, GetUnit()
 * long.
 */
class TetrahedraView
{
public:
  struct Projected
  {
    /// The place in pixels: the centre of the first is at (0.5, 0.5).
    double X;
    double Y;
    double Depth;
  };

  /**
   * Reads the camera and the volume's place. \a stride pixels of the viewport are one pixel here.
   * Returns what is wrong, or nothing.
   */
  std::string Set(vtkRenderer* renderer, vtkVolume* volume, const TetrahedraMesh& mesh, int stride);

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  bool IsParallel() const { return this->Parallel; }
  /// Returns the world length of one unit of the mesh's coordinates.
  double GetUnit() const { return this->Unit; }

  /// Returns eye coordinates in units: the eye looks along -z.
  glm::dvec3 GetEyePoint(const double* point) const
  {
    glm::dvec3 eye;
    for (int i = 0; i < 3; ++i)
    {
      const double* row = &this->EyeFromMesh[4 * i];
      eye[i] = row[0] * point[0] + row[1] * point[1] + row[2] * point[2] + row[3];
    }
    return eye;
  }
  /// Projects a point beyond the near plane.
  Projected Project(const glm::dvec3& eye) const
  {
    const double depth = this->Parallel ? eye[2] : -1.0 / eye[2];
    const double weight = this->Parallel ? 1.0 : depth;
    return { (this->ScaleX * eye[0] + this->ShiftX * eye[2]) * weight + this->OffsetX,
      (this->ScaleY * eye[1] + this->ShiftY * eye[2]) * weight + this->OffsetY, depth };
  }
  /// Returns the eye coordinates of a pixel's point at a depth.
  glm::dvec3 GetEyePoint(double x, double y, double depth) const
  {
    const double z = this->Parallel ? depth : -1.0 / depth;
    const double weight = this->Parallel ? 1.0 : depth;
    return { ((x - this->OffsetX) / weight - this->ShiftX * z) / this->ScaleX,
      ((y - this->OffsetY) / weight - this->ShiftY * z) / this->ScaleY, z };
  }
  /// Returns where the near plane is, on the axis; points with -z less than it are before it.
  double GetNear() const { return this->Near; }
  /// Returns where the far plane is; points with -z more than it are beyond it.
  double GetFar() const { return this->Far; }
  /// Returns the smallest and largest -z in the box that the coordinates of meshes are in.
  std::array<double, 2> GetReach() const;

  /// Returns the length of a line of sight between two depths, over the length between them along
  /// the axis.
  double GetSlant(double x, double y) const;

  /// Returns the coefficients of depth = first + second * (value of the depth buffer, 0 to 1).
  const std::array<double, 2>& GetDepthOfBuffer() const { return this->DepthOfBuffer; }
  /// Returns the inverse: the value of the depth buffer of a depth.
  double GetBufferOfDepth(double depth) const
  {
    return (depth - this->DepthOfBuffer[0]) / this->DepthOfBuffer[1];
  }

  /// Returns the lines of sight of the pixels, in the mesh's coordinates.
  ViewRays GetRays() const;

  /// Returns the matrix from mesh to eye, as three rows of four.
  const std::array<double, 12>& GetEyeFromMesh() const { return this->EyeFromMesh; }
  /// Returns the map from eye to pixels: scale, shift and offset of x, then of y, as Project() has
  /// them.
  std::array<double, 6> GetPixelsFromEye() const
  {
    return { { this->ScaleX, this->ShiftX, this->OffsetX, this->ScaleY, this->ShiftY,
      this->OffsetY } };
  }

  bool operator==(const TetrahedraView& other) const;
  bool operator!=(const TetrahedraView& other) const { return !(*this == other); }

private:
  int Width = 0;
  int Height = 0;
  bool Parallel = false;
  double Unit = 1.0;
  double Near = 0.0;
  double Far = 0.0;
  std::array<double, 12> EyeFromMesh{};
  double ScaleX = 1.0;
  double ShiftX = 0.0;
  double OffsetX = 0.0;
  double ScaleY = 1.0;
  double ShiftY = 0.0;
  double OffsetY = 0.0;
  std::array<double, 2> DepthOfBuffer{};
};

}

#endif
