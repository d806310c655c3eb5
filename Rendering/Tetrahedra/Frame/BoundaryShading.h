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
 * @brief   computes the colour of boundary triangles
 *
 * It uses the renderer's lights, up to MAXIMUM_LIGHTS that are switched on, with ambient, diffuse
 * and specular light on either side, and an image over the texture coordinates.
 */
class BoundaryShading
{
public:
  static constexpr int MAXIMUM_LIGHTS = 8;
  using Color = std::array<float, 4>;

  struct Light
  {
    /// The place of the light, or the direction to it, in eye coordinates, in units of the view.
    glm::vec3 Place;
    bool IsPositional;
    std::array<float, 3> Color;
  };

  /**
   * Reads the lights, the property and the image, which may be null.
   */
  void Set(
    vtkRenderer* renderer, const TetrahedraView& view, vtkProperty* property, vtkTexture* texture);

  /**
   * Returns colour times opacity at a point in eye coordinates. \a normal is in mesh coordinates,
   * of any length and either side.
   */
  Color Shade(const glm::dvec3& eye, const glm::dvec3& normal,
    const std::array<double, 2>& textureCoordinates) const;

  const std::vector<Light>& GetLights() const { return this->Lights; }
  /// Return RGB and opacity; ambient, diffuse, specular and its power; the specular colour.
  const Color& GetColor() const { return this->Base; }
  const Color& GetShares() const { return this->Shares; }
  const std::array<float, 3>& GetSpecularColor() const { return this->SpecularColor; }
  /// Returns the matrix of normals from mesh to eye, as three rows.
  const std::array<float, 9>& GetNormalMatrix() const { return this->NormalMatrix; }
  /// Returns the image row by row from below; no pixels where there is none.
  const std::vector<Color>& GetImage() const { return *this->Image; }
  int GetImageWidth() const { return this->ImageWidth; }
  int GetImageHeight() const { return this->ImageHeight; }
  bool IsRepeated() const { return this->Repeated; }

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
  Color Shares{};
  std::array<float, 3> SpecularColor{};
  std::array<float, 9> NormalMatrix{};
  /// The image, shared with copies, which are made to tell what has changed.
  std::shared_ptr<const std::vector<Color>> Image = std::make_shared<const std::vector<Color>>();
  vtkMTimeType ImageTime = 0;
  int ImageWidth = 0;
  int ImageHeight = 0;
  bool Repeated = false;
};

}

#endif
