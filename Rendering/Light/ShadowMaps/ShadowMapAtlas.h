// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ShadowMapAtlas_h
#define interlume_ShadowMapAtlas_h

#include "ShadowMaps/ShadowMapView.h"

#include <array>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

class vtkProp;
class vtkShaderProgram;

namespace interlume
{

/**
 * @class   ShadowMapAtlas
 * @brief   texture with one tile per shadow map view, in rows from the bottom
 */
class ShadowMapAtlas
{
public:
  /// Assigns a tile of \a resolution by \a resolution texels to each view. \a bias is the DepthBias
  /// of vtkShadowedScenePass.
  void Set(const std::vector<ShadowMapView>& views, int resolution, double bias);

  const std::vector<ShadowMapView>& GetViews() const { return this->Views; }
  int GetResolution() const { return this->Resolution; }
  double GetBias() const { return this->Bias; }
  /// Returns the number of tiles per row of an atlas with \a views tiles.
  static int GetColumns(int views);
  int GetColumns() const { return this->Columns; }
  /// Return the size of the texture in texels.
  int GetWidth() const { return this->Columns * this->Resolution; }
  int GetHeight() const;
  /// Returns the first column and row of a tile, and its width and height, as a viewport.
  std::array<int, 4> GetTile(std::size_t view) const;

  /// Returns values that change if the tiles must be redrawn. \a props are the props drawn into
  /// them.
  std::vector<double> GetState(const std::vector<vtkProp*>& props) const;

  /// Sets the uniforms NAMEFromPosition, NAMETiles, positionFromNAME and NAMETexels, where NAME is
  /// \a name, with a capital first letter in positionFromNAME. \a worldFromPosition transforms the
  /// program's positions to world coordinates.
  void SetUniforms(
    vtkShaderProgram* program, const std::string& name, const glm::dmat4& worldFromPosition) const;

private:
  std::vector<ShadowMapView> Views;
  int Columns = 1;
  int Resolution = 0;
  double Bias = 1.0;
};

}

#endif
