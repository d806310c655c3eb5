// SPDX-License-Identifier: BSD-3-Clause
#include "Software/SurfaceFragments.h"

#include <algorithm>
#include <limits>

namespace interlume
{

void SurfaceFragments::SetTetrahedron(std::uint32_t tetrahedron)
{
  this->Tetrahedron = tetrahedron;
  const std::uint32_t* corners = this->Frame.Mesh->GetCorners(tetrahedron);
  const TetrahedraFields& fields = *this->Frame.Fields;
  std::array<const TetrahedraView::Projected*, 4> p;
  for (int k = 0; k < 4; ++k)
  {
    p[k] = &this->Bins.GetPoints()[corners[k]].Position;
  }
  this->Shape.Set(*p[0], *p[1], *p[2], *p[3]);
  this->Shape.SetSlopes();
  for (int c = 0; c < CHANNELS; ++c)
  {
    std::array<double, 4> v;
    for (int k = 0; k < 4; ++k)
    {
      const double weight = this->Frame.View.IsParallel() ? 1.0 : p[k]->Depth;
      if (c == 0)
      {
        v[k] = p[k]->Depth;
      }
      else if (c < 4)
      {
        v[k] = weight * fields.Normals[corners[k]][c - 1];
      }
      else
      {
        v[k] = fields.TextureCoordinates.empty()
          ? 0.0
          : weight * fields.TextureCoordinates[corners[k]][c - 4];
      }
    }
    this->Values[c] = this->Shape.GetValue(v);
  }
}

double SurfaceFragments::Locate(double x, double y, int& edge) const
{
  const double dx = x - this->Shape.GetThickX();
  const double dy = y - this->Shape.GetThickY();
  double minimum = std::numeric_limits<double>::max();
  edge = 0;
  for (int i = 0; i < this->Shape.GetNumberOfEdges(); ++i)
  {
    const TetrahedronSilhouette::Slope& e = this->Shape.GetEdge(i);
    const double value = 1.0 + e.X * dx + e.Y * dy;
    const bool isUsed = e.X != 0.0 || e.Y != 0.0;
    if (isUsed && value < minimum)
    {
      minimum = value;
      edge = i;
    }
  }
  return std::max(0.0, std::min(minimum, 1.0));
}

BoundaryShading::TexturePosition SurfaceFragments::GetTexturePosition(
  const std::array<double, CHANNELS>& at, double dx, double dy, int edge) const
{
  const bool isParallel = this->Frame.View.IsParallel();
  const TetrahedronSilhouette::Slope& crease = this->Shape.GetCrease();
  const bool isPastCrease = crease.X * dx + crease.Y * dy > 0.0;
  // Returns the changes of a channel from pixel to pixel.
  const auto getChanges = [&](int channel)
  {
    const Value& value = this->Values[channel];
    glm::dvec2 change(value.Base.X, value.Base.Y);
    if (isPastCrease)
    {
      change += value.Bend * glm::dvec2(crease.X, crease.Y);
    }
    if (edge >= 0)
    {
      const TetrahedronSilhouette::Slope& slope = this->Shape.GetEdge(edge);
      change += value.Difference * glm::dvec2(slope.X, slope.Y);
    }
    return change;
  };
  const double weight = isParallel ? 1.0 : at[0];
  const glm::dvec2 weightChanges = isParallel ? glm::dvec2(0.0) : getChanges(0);
  BoundaryShading::TexturePosition position{};
  for (int i = 0; i < 2; ++i)
  {
    position.At[i] = at[4 + i] / weight;
    const glm::dvec2 changes = (getChanges(4 + i) - position.At[i] * weightChanges) / weight;
    position.ChangeX[i] = changes.x;
    position.ChangeY[i] = changes.y;
  }
  return position;
}

void SurfaceFragments::Compute(
  const Fragments& fragments, int left, int bottom, const float* opaque)
{
  const Fragments::Color none{ { 0.0f, 0.0f, 0.0f, 0.0f } };
  const TetrahedraView& view = this->Frame.View;
  for (int run = 0; run < fragments.NumberOfRuns; ++run)
  {
    const Fragments::Run& r = fragments.Runs[run];
    const unsigned int faces = this->Frame.Fields->Faces[r.Tetrahedron];
    for (auto& colors : this->Colors)
    {
      std::fill(&colors[r.Begin], colors.data() + r.End, none);
    }
    if (faces == 0)
    {
      continue;
    }
    if (r.Tetrahedron != this->Tetrahedron)
    {
      this->SetTetrahedron(r.Tetrahedron);
    }
    const int base = this->Values[0].Difference > 0.0 ? 1 : 0;
    for (int i = r.Begin; i < r.End; ++i)
    {
      const int pixel = r.Pixel + i - r.Begin;
      const int column = left + pixel % TileBins::SIZE;
      const int row = bottom + pixel / TileBins::SIZE;
      const double x = column + 0.5;
      const double y = row + 0.5;
      int edge = 0;
      const double lambda = this->Locate(x, y, edge);
      const double dx = x - this->Shape.GetThickX();
      const double dy = y - this->Shape.GetThickY();
      const TetrahedronSilhouette::Slope& crease = this->Shape.GetCrease();
      const double pastCrease = std::max(0.0, crease.X * dx + crease.Y * dy);
      for (int end = 0; end < 2; ++end)
      {
        const bool isBase = end == base;
        const int face = isBase ? this->Shape.GetBaseFace(edge) : this->Shape.GetOtherFace(edge);
        if (!(faces & (1u << face)))
        {
          continue;
        }
        std::array<double, CHANNELS> at;
        for (int c = 0; c < CHANNELS; ++c)
        {
          const Value& value = this->Values[c];
          at[c] = value.At + value.Base.X * dx + value.Base.Y * dy + value.Bend * pastCrease +
            (isBase ? 0.0 : lambda * value.Difference);
        }
        if (opaque && at[0] <= opaque[pixel])
        {
          continue;
        }
        const double weight = view.IsParallel() ? 1.0 : at[0];
        const auto& numbers = this->Frame.Fields->FaceMaterials;
        const std::size_t number = numbers.empty() ? 0 : numbers[r.Tetrahedron][face];
        const BoundaryShading::Material& material = this->Frame.Surface->GetMaterials()[number];
        BoundaryShading::TexturePosition texture{};
        if (material.Texture >= 0)
        {
          texture = this->GetTexturePosition(at, dx, dy, isBase ? -1 : edge);
        }
        this->Colors[end][i] =
          this->Frame.Surface->Shade(material, view.GetEyeCoordinates(x, y, at[0]),
            { at[1] / weight, at[2] / weight, at[3] / weight }, texture);
      }
    }
  }
}

}
