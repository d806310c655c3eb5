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
 * specular shading, and an optional texture. There are one or more materials, each with its color,
 * coefficients and texture.
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

  /// Texture coordinates at a pixel, and their changes to the next pixel along x and y.
  struct TexturePosition
  {
    glm::dvec2 At;
    glm::dvec2 ChangeX;
    glm::dvec2 ChangeY;
  };

  /// Image of a texture, with mipmap levels if the texture uses mipmaps. Each level has half the
  /// width and height, rounded down, of the level before.
  class Image
  {
  public:
    void Set(vtkTexture* texture);
    /// Returns the color at a position, interpolated in the two levels whose pixels are closest in
    /// size to those of the screen.
    Color Sample(const TexturePosition& position) const;

    bool IsEmpty() const { return this->Pixels->empty(); }
    /// Returns the pixels of all levels, the bottom row first.
    const std::vector<Color>& GetPixels() const { return *this->Pixels; }
    int GetWidth() const { return this->Width; }
    int GetHeight() const { return this->Height; }
    int GetNumberOfLevels() const { return this->NumberOfLevels; }
    bool IsRepeated() const { return this->Repeated; }
    bool operator==(const Image& other) const
    {
      return this->Time == other.Time && this->Repeated == other.Repeated;
    }

  private:
    /// A level of \a width x \a height pixels that begins at \a first.
    struct Level
    {
      std::size_t First;
      int Width;
      int Height;
    };
    Level GetLevel(int number) const;
    Color SampleLevel(const Level& level, const glm::dvec2& at) const;

    /// Copies of this object, which are used to detect changes, share the pixels.
    std::shared_ptr<const std::vector<Color>> Pixels = std::make_shared<const std::vector<Color>>();
    vtkMTimeType Time = 0;
    int Width = 0;
    int Height = 0;
    int NumberOfLevels = 0;
    bool Repeated = false;
  };

  struct Material
  {
    /// Diffuse color and opacity.
    Color Base{};
    /// Ambient, diffuse and specular coefficients, and specular power.
    Color Coefficients{};
    std::array<float, 3> SpecularColor{};
    /// Index of the texture's image; -1 without a texture.
    int Texture = -1;

    bool operator==(const Material& other) const
    {
      return this->Base == other.Base && this->Coefficients == other.Coefficients &&
        this->SpecularColor == other.SpecularColor && this->Texture == other.Texture;
    }
  };

  /// Property of a material, and its texture, which may be null.
  struct Source
  {
    vtkProperty* Property;
    vtkTexture* Texture;
  };

  /**
   * Reads the lights and the materials, of which there must be at least one.
   */
  void Set(vtkRenderer* renderer, const TetrahedraView& view, const std::vector<Source>& materials);

  /**
   * Returns the RGBA color, premultiplied by opacity, at a point in eye coordinates. \a normal is
   * in mesh coordinates and may have any length and orientation.
   */
  Color Shade(const Material& material, const glm::dvec3& eye, const glm::dvec3& normal,
    const TexturePosition& texturePosition) const;

  const std::vector<Light>& GetLights() const { return this->Lights; }
  const std::vector<Material>& GetMaterials() const { return this->Materials; }
  /// Returns the images of the materials, without repetition.
  const std::vector<Image>& GetImages() const { return this->Images; }
  /// Returns the largest opacity of all materials.
  float GetLargestOpacity() const;
  /// Returns the 3 x 3 matrix from mesh to eye coordinates for normals, in row-major order.
  const std::array<float, 9>& GetNormalMatrix() const { return this->NormalMatrix; }

  bool HasSameImages(const BoundaryShading& other) const { return this->Images == other.Images; }
  bool operator==(const BoundaryShading& other) const;

private:
  void SetLights(vtkRenderer* renderer, const TetrahedraView& view);
  /// Sets the images and returns their indices for the materials.
  std::vector<int> SetImages(const std::vector<Source>& materials);

  std::vector<Light> Lights;
  std::vector<Material> Materials;
  std::vector<Image> Images;
  std::array<float, 9> NormalMatrix{};
};

}

#endif
