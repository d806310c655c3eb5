// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BoundaryShading_h
#define interlume_BoundaryShading_h

#include "Common/Vectors.h"
#include "View/TetrahedraView.h"

#include <array>
#include <memory>
#include <vector>

class vtkProperty;
class vtkRenderer;
class vtkTexture;

namespace interlume
{

/**
 * @class   BoundaryShading
 * @brief   computes the color of boundary triangles
 *
 * It uses up to MAXIMUM_LIGHTS enabled lights of the renderer, with two-sided ambient, diffuse and
 * specular shading, and an optional texture.
 */
class BoundaryShading
{
public:
  static constexpr int MAXIMUM_LIGHTS = 8;
  using Color = std::array<float, 4>;

  struct Light
  {
    /// Position of the light, or the direction toward it, in the eye coordinates of TetrahedraView.
    glm::vec3 Position;
    bool IsPositional;
    std::array<float, 3> Color;
  };

  /**
   * Reads the lights, the property and the texture, which may be null.
   */
  void Set(
    vtkRenderer* renderer, const TetrahedraView& view, vtkProperty* property, vtkTexture* texture);

  /**
   * Returns the RGBA color, premultiplied by opacity, at a point in eye coordinates. \a normal is
   * in mesh coordinates and may have any length and orientation.
   */
  Color Shade(const glm::dvec3& eye, const glm::dvec3& normal,
    const std::array<double, 2>& textureCoordinates) const;

  const std::vector<Light>& GetLights() const { return this->Lights; }
  /// Returns the diffuse color and the opacity.
  const Color& GetColor() const { return this->Base; }
  /// Returns the ambient, diffuse and specular coefficients and the specular power.
  const Color& GetCoefficients() const { return this->Coefficients; }
  const std::array<float, 3>& GetSpecularColor() const { return this->SpecularColor; }
  /// Returns the 3 x 3 matrix from mesh to eye coordinates for normals, in row-major order.
  const std::array<float, 9>& GetNormalMatrix() const { return this->NormalMatrix; }
  /// Returns the texture's pixels, bottom row first; empty if there is no texture.
  const std::vector<Color>& GetImage() const { return *this->Image; }
  int GetImageWidth() const { return this->ImageWidth; }
  int GetImageHeight() const { return this->ImageHeight; }
  bool IsTextureRepeated() const { return this->Repeated; }

  bool HasSameImage(const BoundaryShading& other) const
  {
    return this->ImageTime == other.ImageTime && this->Repeated == other.Repeated;
  }
  bool operator==(const BoundaryShading& other) const;

private:
  void SetImage(vtkTexture* texture);
  Color Sample(double u, double v) const;

  std::vector<Light> Lights;
  Color Base{};
  Color Coefficients{};
  std::array<float, 3> SpecularColor{};
  std::array<float, 9> NormalMatrix{};
  /// The texture image. Copies of this object, which are used to detect changes, share it.
  std::shared_ptr<const std::vector<Color>> Image = std::make_shared<const std::vector<Color>>();
  vtkMTimeType ImageTime = 0;
  int ImageWidth = 0;
  int ImageHeight = 0;
  bool Repeated = false;
};

}

#endif
