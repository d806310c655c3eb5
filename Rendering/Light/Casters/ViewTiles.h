// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ViewTiles_h
#define interlume_ViewTiles_h

#include "Casters/CasterView.h"

#include <array>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

class vtkProp;
class vtkShaderProgram;

namespace interlume
{

/**
 * @class   ViewTiles
 * @brief   the places of lights' views in one texture, in tiles that are numbered row by row from
 * below
 */
class ViewTiles
{
public:
  /// Gives each view a tile of \a resolution columns and rows. \a bias is the setting DepthBias of
  /// vtkShadowedScenePass.
  void Set(const std::vector<CasterView>& views, int resolution, double bias);

  const std::vector<CasterView>& GetViews() const { return this->Views; }
  int GetResolution() const { return this->Resolution; }
  double GetBias() const { return this->Bias; }
  /// Returns the number of tiles beside each other, for so many views.
  static int GetColumns(int views);
  int GetColumns() const { return this->Columns; }
  /// Returns the size of the texture.
  int GetWidth() const { return this->Columns * this->Resolution; }
  int GetHeight() const;
  /// Returns the first column and row of a tile, and their number, as a viewport.
  std::array<int, 4> GetTile(std::size_t view) const;

  /// Returns all that pictures of \a props in the tiles depend on.
  std::vector<double> GetState(const std::vector<vtkProp*>& props) const;

  /// Sets the uniforms nameFromPlace, nameTiles, and where they are used placeFromName (with a
  /// capital) and nameTexels, of a program in which places are in coordinates that \a
  /// worldFromPlace leads from.
  void SetUniforms(
    vtkShaderProgram* program, const std::string& name, const glm::dmat4& worldFromPlace) const;

private:
  std::vector<CasterView> Views;
  int Columns = 1;
  int Resolution = 0;
  double Bias = 1.0;
};

}

#endif
