// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowShader_h
#define interlume_FlowShader_h

#include <string>

class vtkImplicitFlowVolumeMapper;

namespace interlume
{

class SurfacePaintTextures;
class FlowViewRays;

/**
 * @class   FlowShader
 * @brief   assembles the shader of a frame, without code for unused features
 *
 * The result is either a complete fragment shader for ray casting, or the functions of a
 * vtkSliceMedium.
 */
class FlowShader
{
public:
  /// Properties of a frame that are not settings of the mapper.
  struct Parts
  {
    bool HasOpaqueDepth = false;
    bool HasSplitCells = false;
    bool HasSeamCells = false;
    bool HasEmptyCells = false;
    /// If true, OpenGL is implemented in software, which interpolates floating-point textures in
    /// full precision.
    bool IsSoftware = false;
    /// Number of dimensions of the detail texture, 2 or 3, or 0 if there is no detail texture.
    int DetailDimensions = 0;
    bool HasTransfer = false;
    /// If true, the volume is shaded, either like lines along vectors or by a gradient.
    bool IsShaded = false;
    bool IsShadedByVectors = false;
    int Lights = 0;
    /// If true, create the functions of a slice medium, otherwise a shader for ray casting.
    bool IsMedium = false;
  };

  /// Number of columns of the textures that tabulate the time gate and the opacity function.
  static constexpr int Columns = 1024;

  FlowShader(vtkImplicitFlowVolumeMapper& mapper, const Parts& parts,
    const SurfacePaintTextures& paints, const FlowViewRays& view);

  /// Returns the names of the features, for the report.
  const std::string& GetNames() const { return this->Names; }
  const std::string& GetSource() const { return this->Source; }

private:
  void Add(const std::string& feature, const std::string& value = std::string());

  bool HasTimes = false;
  std::string Features;
  std::string Names;
  std::string Source;
};

}

#endif
