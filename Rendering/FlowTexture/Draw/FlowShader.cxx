// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/FlowShader.h"

#include "Draw/FlowPaints.h"
#include "Draw/FlowView.h"
#include "Grid/FlowGrid.h"
#include "Offscreen/ShaderFeatures.h"

#include "InterlumeFlowCell.h"
#include "InterlumeFlowInflow.h"
#include "InterlumeFlowMatter.h"
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
  for (std::size_t place = text.find(from); place != std::string::npos;
       place = text.find(from, place + to.size()))
  {
    text.replace(place, from.size(), to);
  }
}

// Returns the functions of all images, each of which asks the one before.
std::string MakeInflow(const FlowPaints& paints)
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
  const FlowPaints& paints, const FlowView& view)
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
  // Slices have these themselves.
  const bool isAlone = !parts.IsMedium;
  add(isAlone && view.IsParallel, "PARALLEL");
  add(isAlone && parts.HasOpaqueDepth, "OPAQUE");
  add(
    isAlone && !view.ClippingPlanes.empty(), "CLIPPING_PLANES", number(view.ClippingPlanes.size()));
  add(isAlone && view.Regions.HasGaps(), "CROPPING");
  add(parts.HasSplitCells, "SPLITS");
  add(parts.HasSeamCells, "SEAMS");
  add(!paints.IsOne, "SURFACES");
  add(this->HasTimes, "TIMES");
  add(mapper.GetPaintFilter(), "PAINT_FILTER");
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
  add(isAlone && parts.IsShaded, "SHADE");
  add(parts.IsShaded && parts.IsShadedByVectors, "SHADE_VECTORS");
  this->Names = this->Features.substr(0, this->Features.find_last_not_of(' ') + 1);
  std::transform(this->Names.begin(), this->Names.end(), this->Names.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });

  // What follows is no feature but a number that the shader is compiled with.
  add(parts.IsSoftware, "SMOOTH_PLACES");
  add(parts.HasEmptyCells, "EMPTY_CELLS");
  this->Add("WAYS", std::to_string(FlowGrid::Ways));
  add(isAlone && parts.IsShaded, "LIGHTS", std::to_string(parts.Lights));
  if (paints.IsOne)
  {
    const bool hasSurface = paints.Surfaces.size() > 4;
    const auto is = [&](std::size_t i)
    { return hasSurface && paints.Surfaces[4 + i] != 0.0F ? "true" : "false"; };
    this->Add("PAINT", number(hasSurface ? static_cast<std::size_t>(paints.Surfaces[4]) : 0));
    this->Add("PERIOD_U", is(1));
    this->Add("PERIOD_V", is(2));
  }
  this->Source = isAlone ? InterlumeFlowVolumeFS : InterlumeFlowMatter;
  Replace(this->Source, "//INTERLUME::WALK", InterlumeFlowWalk);
  Replace(this->Source, "//INTERLUME::CELL", InterlumeFlowCell);
  Replace(this->Source, "//INTERLUME::PAINT\n", std::string(InterlumeFlowPaint) + "\n");
  Replace(this->Source, "//INTERLUME::PAINTS", MakeInflow(paints));
  Replace(this->Source, "//INTERLUME::SHADE",
    parts.IsShaded ? std::string(InterlumeFlowShade) : std::string());
  this->Source = ShaderFeatures::Insert(this->Source, this->Features);
}

}
