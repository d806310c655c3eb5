// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowShader_h
#define interlume_FlowShader_h

#include <string>

class vtkImplicitFlowVolumeMapper;

namespace interlume
{

class FlowPaints;
class FlowView;

/**
 * @class   FlowShader
 * @brief   puts the shader of a picture together, with nothing of what is off
 *
 * It is that of lines of sight, or the functions of matter that vtkSliceMedium tells of.
 */
class FlowShader
{
public:
  /// What a picture has beside its settings.
  struct Parts
  {
    bool HasOpaqueDepth = false;
    bool HasSplitCells = false;
    bool HasSeamCells = false;
    bool HasEmptyCells = false;
    /// Whether textures of floats are interpolated in full.
    bool IsSoftware = false;
    /// The dimensions of the detail texture, 2 or 3; 0 without one.
    int DetailDimensions = 0;
    bool HasTransfer = false;
    /// Whether there is shading, by vectors or by a gradient.
    bool IsShaded = false;
    bool IsShadedByVectors = false;
    int Lights = 0;
    /// Whether it is matter of slices, not lines of sight, that is looked up.
    bool IsMedium = false;
  };

  /// The columns of textures of functions.
  static constexpr int Columns = 1024;

  FlowShader(vtkImplicitFlowVolumeMapper& mapper, const Parts& parts, const FlowPaints& paints,
    const FlowView& view);

  /// The words of the report.
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
