// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/FlowShader.h"

#include "Draw/SurfacePaintTextures.h"
#include "Draw/FlowViewRays.h"
#include "Grid/FlowGrid.h"
#include "Offscreen/ShaderFeatures.h"

#include "InterlumeFlowCell.h"
#include "InterlumeFlowInflow.h"
#include "InterlumeFlowMedium.h"
#include "InterlumeFlowPaint.h"
#include "InterlumeFlowShade.h"
#include "InterlumeFlowVolumeFS.h"
#include "InterlumeFlowWalk.h"
#include "vtkImplicitFlowVolumeMapper.h"

#include <algorithm>
#include <cctype>

namespace interlume
{

namespace
{
void Replace(std::string& text, const std::string& from, const std::string& to)
{
  for (std::size_t position = text.find(from); position != std::string::npos;
       position = text.find(from, position + to.size()))
  {
    text.replace(position, from.size(), to);
  }
}

// Returns GLSL code with a lookup function for each inflow texture. Each function calls the
// previous one for smaller texture numbers.
std::string MakeInflow(const SurfacePaintTextures& paints)
{
  std::string before = "none";
  std::string source = "vec4 inflowUpTo_none(int paint, vec2 place, float level)\n"
                       "{\n  return defaultColor;\n}\n";
  for (std::size_t i = 0; i < paints.Paints.size(); ++i)
  {
    std::string copy = InterlumeFlowInflow;
    Replace(copy, "NUMBER", std::to_string(i + 1));
    Replace(copy, "_P(", "_" + before + "(");
    Replace(copy, "_N", "_" + paints.Paints[i].Name);
    before = paints.Paints[i].Name;
    source += copy;
  }
  return source + "#define inflowAt inflowUpTo_" + before + "\n";
}
}

void FlowShader::Add(const std::string& feature, const std::string& value)
{
  this->Features += feature + (value.empty() ? "" : "=" + value) + " ";
}

FlowShader::FlowShader(vtkImplicitFlowVolumeMapper& mapper, const Parts& parts,
  const SurfacePaintTextures& paints, const FlowViewRays& view)
{
  const auto number = [](std::size_t value) { return std::to_string(value); };
  const auto add = [this](bool isOn, const std::string& feature, const std::string& value = {})
  {
    if (isOn)
    {
      this->Add(feature, value);
    }
  };
  const bool hasDetail = parts.DetailDimensions > 0;
  const bool hasGate = mapper.GetTimeGate() != nullptr;
  this->HasTimes = hasGate || parts.DetailDimensions == 3;
  // Features that are added only for ray casting are provided by the slice mapper for slices.
  const bool isRayCasting = !parts.IsMedium;
  add(isRayCasting && view.IsParallel, "PARALLEL");
  add(isRayCasting && parts.HasOpaqueDepth, "OPAQUE");
  add(isRayCasting && !view.ClippingPlanes.empty(), "CLIPPING_PLANES",
    number(view.ClippingPlanes.size()));
  add(isRayCasting && view.Regions.HasGaps(), "CROPPING");
  add(parts.HasSplitCells, "SPLITS");
  add(parts.HasSeamCells, "SEAMS");
  add(!paints.IsUniform, "SURFACES");
  add(this->HasTimes, "TIMES");
  add(mapper.GetTextureFilter(), "PAINT_FILTER");
  add(hasDetail, "DETAIL", std::to_string(parts.DetailDimensions));
  const char* modes[] = { "DETAIL_MODULATE", "DETAIL_OVER", "DETAIL_ADD" };
  add(hasDetail, modes[mapper.GetDetailMode()]);
  add(hasGate, "GATE", number(Columns));
  add(hasGate && mapper.GetTimeGateRepeat(), "GATE_REPEATS");
  const bool isBoth = mapper.GetTimeGateTarget() == vtkImplicitFlowVolumeMapper::GATE_BOTH;
  add(hasGate && (isBoth || mapper.GetTimeGateTarget() == vtkImplicitFlowVolumeMapper::GATE_INFLOW),
    "GATE_INFLOW");
  add(hasGate && hasDetail &&
      (isBoth || mapper.GetTimeGateTarget() == vtkImplicitFlowVolumeMapper::GATE_DETAIL),
    "GATE_DETAIL");
  add(parts.HasTransfer, "TRANSFER", number(Columns));
  add(isRayCasting && parts.IsShaded, "SHADE");
  add(parts.IsShaded && parts.IsShadedByVectors, "SHADE_VECTORS");
  this->Names = this->Features.substr(0, this->Features.find_last_not_of(' ') + 1);
  std::transform(this->Names.begin(), this->Names.end(), this->Names.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });

  // The following defines are not listed as features in the report.
  add(parts.IsSoftware, "SMOOTH_POSITIONS");
  add(parts.HasEmptyCells, "EMPTY_CELLS");
  this->Add("NUMBER_OF_SIDES", std::to_string(FlowGrid::NumberOfSides));
  add(isRayCasting && parts.IsShaded, "LIGHTS", std::to_string(parts.Lights));
  if (paints.IsUniform)
  {
    const bool hasSurface = paints.Surfaces.size() > 4;
    const auto is = [&](std::size_t i)
    { return hasSurface && paints.Surfaces[4 + i] != 0.0F ? "true" : "false"; };
    this->Add("PAINT", number(hasSurface ? static_cast<std::size_t>(paints.Surfaces[4]) : 0));
    this->Add("PERIOD_U", is(1));
    this->Add("PERIOD_V", is(2));
  }
  this->Source = isRayCasting ? InterlumeFlowVolumeFS : InterlumeFlowMedium;
  Replace(this->Source, "//INTERLUME::WALK", InterlumeFlowWalk);
  Replace(this->Source, "//INTERLUME::CELL", InterlumeFlowCell);
  Replace(this->Source, "//INTERLUME::PAINT\n", std::string(InterlumeFlowPaint) + "\n");
  Replace(this->Source, "//INTERLUME::PAINTS", MakeInflow(paints));
  Replace(this->Source, "//INTERLUME::SHADE",
    parts.IsShaded ? std::string(InterlumeFlowShade) : std::string());
  this->Source = ShaderFeatures::Insert(this->Source, this->Features);
}

}
