// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/TetrahedraSubset.h"

#include "Common/ParallelFor.h"
#include "Common/ThreadLocals.h"
#include "Draw/LevelOfDetail.h"
#include "Frame/BoundaryShading.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace interlume
{

namespace
{
/// Key of a tetrahedron that is never drawn.
constexpr std::uint32_t INVISIBLE = ~0u;
/// Number of tetrahedra per task.
constexpr vtkIdType CHUNK = 1 << 16;
/// Maximum factor of the extent in time of a tetrahedron that the bounding box limits.
constexpr double MAXIMUM_GAIN = 8.0;

// Returns a number in (0, 1]. Multiplicative hashing (D. Knuth) spreads the smallest numbers evenly
// over the indices, which are usually ordered in space.
float GetHash(std::uint32_t tetrahedron)
{
  return (static_cast<float>(tetrahedron * 2654435761u) + 0.5f) * 0x1p-32f;
}

float ToFloat(std::uint32_t key)
{
  float value;
  std::memcpy(&value, &key, sizeof value);
  return value;
}

// Estimates how much tetrahedra contribute to an image.
class Importance
{
public:
  Importance(const TetrahedraFrame& frame, float surfaceOpacity)
    : Frame(frame)
    , Fields(*frame.Fields)
    , SurfaceOpacity(surfaceOpacity)
  {
  }

  double Get(std::uint32_t tetrahedron) const
  {
    const TetrahedraMesh& mesh = *this->Frame.Mesh;
    const std::uint32_t* corners = mesh.GetCorners(tetrahedron);
    double value =
      std::abs(mesh.GetVolumeTimesSix(corners)) * this->GetExtinction(tetrahedron, corners);
    if (!this->Fields.DeltaT.empty())
    {
      const std::vector<float>& extents = this->Fields.DeltaT;
      value *= 0.25 *
        ((extents[corners[0]] + extents[corners[1]]) + (extents[corners[2]] + extents[corners[3]]));
    }
    if (this->SurfaceOpacity > 0.0f && this->Fields.Faces[tetrahedron] != 0)
    {
      value += this->GetSurface(tetrahedron, corners);
    }
    // Relative to the opacity of a unit of length, so that single precision suffices.
    return value / this->Frame.ExtinctionUnit;
  }

private:
  float GetExtinction(std::uint32_t tetrahedron, const std::uint32_t* corners) const
  {
    if (this->Frame.Blend == TetrahedraFrame::MAXIMUM)
    {
      // The image depends on the scalar, not on extinction.
      return 1.0f;
    }
    const auto& colors = this->Fields.Colors;
    switch (this->Fields.Kind)
    {
      case TetrahedraFields::SCALARS:
        return this->GetExtinctionOfScalars(corners);
      case TetrahedraFields::POINT_COLORS:
        return 0.25f *
          ((colors[corners[0]][3] + colors[corners[1]][3]) +
            (colors[corners[2]][3] + colors[corners[3]][3]));
      default:
        return colors[tetrahedron][3];
    }
  }

  // Returns the mean over the corners and over the control points between the scalars.
  float GetExtinctionOfScalars(const std::uint32_t* corners) const
  {
    const PiecewiseLinearTransferFunction& pieces = *this->Frame.Pieces;
    float sum = 0.0f;
    int first = std::numeric_limits<int>::max();
    int last = 0;
    for (int k = 0; k < 4; ++k)
    {
      const float scalar = std::clamp(this->Fields.Scalars[corners[k]], 0.0f, 1.0f);
      const int piece = pieces.Find(scalar);
      sum += pieces.GetExtinctions()[piece] +
        pieces.GetExtinctionSlopes()[piece] * (scalar - pieces.GetStarts()[piece]);
      first = std::min(first, piece);
      last = std::max(last, piece);
    }
    for (int piece = first + 1; piece <= last; ++piece)
    {
      sum += pieces.GetExtinctions()[piece];
    }
    return sum / static_cast<float>(4 + last - first);
  }

  // Returns six times the area of the boundary triangles, multiplied by their opacity.
  double GetSurface(std::uint32_t tetrahedron, const std::uint32_t* corners) const
  {
    double area = 0.0;
    for (int face = 0; face < 4; ++face)
    {
      if ((this->Fields.Faces[tetrahedron] >> face) & 1)
      {
        glm::dvec3 p[3];
        for (int i = 0; i < 3; ++i)
        {
          p[i] = glm::make_vec3(this->Frame.Mesh->GetPoint(corners[(face + 1 + i) % 4]));
        }
        area += 0.5 * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
      }
    }
    return 6.0 * this->SurfaceOpacity * area;
  }

  const TetrahedraFrame& Frame;
  const TetrahedraFields& Fields;
  float SurfaceOpacity;
};

// Computes the keys of all tetrahedra, and the number of keys with the same 17 first bits.
class KeyTable
{
public:
  KeyTable(std::uint32_t number, const Importance& importance)
    : Keys(number)
  {
    ThreadLocals<std::vector<std::uint32_t>> local;
    vtkSMPTools::For(0, number, CHUNK,
      [&](vtkIdType first, vtkIdType last)
      {
        std::vector<std::uint32_t>& counts = local.Local();
        counts.resize(BINS);
        for (vtkIdType t = first; t < last; ++t)
        {
          const auto tetrahedron = static_cast<std::uint32_t>(t);
          const double value = importance.Get(tetrahedron);
          std::uint32_t& bits = this->Keys[tetrahedron];
          bits = INVISIBLE;
          if (value > 0.0)
          {
            using Limits = std::numeric_limits<float>;
            const auto key = static_cast<float>(
              std::clamp<double>(GetHash(tetrahedron) / value, Limits::min(), Limits::max()));
            // The bits of positive floats have the same order as the floats.
            std::memcpy(&bits, &key, sizeof bits);
            ++counts[bits >> SHIFT];
          }
        }
      });
    for (const std::vector<std::uint32_t>& counts : local)
    {
      for (std::size_t bin = 0; bin < counts.size(); ++bin)
      {
        this->Counts[bin] += counts[bin];
      }
    }
  }

  // Returns the tetrahedra with the \a number smallest keys, by index. Also returns tetrahedra if
  // only the last bits of their keys differ from the largest of these keys.
  std::vector<std::uint32_t> FindSmallest(std::uint32_t number) const
  {
    std::uint32_t sum = 0;
    std::uint32_t bin = 0;
    while (bin + 1 < BINS && sum + this->Counts[bin] < number)
    {
      sum += this->Counts[bin];
      ++bin;
    }
    const auto size = static_cast<vtkIdType>(this->Keys.size());
    std::vector<std::vector<std::uint32_t>> chunks((size + CHUNK - 1) / CHUNK);
    ParallelFor(0, static_cast<vtkIdType>(chunks.size()), 1,
      [&](vtkIdType chunk)
      {
        for (vtkIdType t = chunk * CHUNK; t < std::min(size, (chunk + 1) * CHUNK); ++t)
        {
          if (this->Keys[t] >> SHIFT <= bin)
          {
            chunks[chunk].push_back(static_cast<std::uint32_t>(t));
          }
        }
      });
    std::vector<std::uint32_t> found;
    for (const std::vector<std::uint32_t>& chunk : chunks)
    {
      found.insert(found.end(), chunk.begin(), chunk.end());
    }
    return found;
  }

  std::uint32_t Get(std::uint32_t tetrahedron) const { return this->Keys[tetrahedron]; }

private:
  static constexpr int SHIFT = 15;
  /// The sign bit of valid keys is 0.
  static constexpr std::uint32_t BINS = 1u << (31 - SHIFT);

  std::vector<std::uint32_t> Keys;
  std::vector<std::uint32_t> Counts = std::vector<std::uint32_t>(BINS);
};

std::array<std::array<double, 3>, 2> FindBounds(const TetrahedraMesh& mesh)
{
  using Box = std::array<std::array<double, 3>, 2>;
  ThreadLocals<Box> boxes;
  vtkSMPTools::For(0, static_cast<vtkIdType>(mesh.Points.size() / 3), CHUNK,
    [&](vtkIdType first, vtkIdType last)
    {
      Box& box = boxes.Local();
      for (vtkIdType p = first; p < last; ++p)
      {
        for (int i = 0; i < 3; ++i)
        {
          box[0][i] = std::min(box[0][i], mesh.Points[3 * p + i]);
          box[1][i] = std::max(box[1][i], mesh.Points[3 * p + i]);
        }
      }
    });
  Box all{};
  for (const Box& box : boxes)
  {
    for (int i = 0; i < 3; ++i)
    {
      all[0][i] = std::min(all[0][i], box[0][i]);
      all[1][i] = std::max(all[1][i], box[1][i]);
    }
  }
  return all;
}

// Copies the values of the members. Each tetrahedron gets its own points.
template <typename Members>
TetrahedraFields CopyFields(const TetrahedraFrame& frame, const Members& members)
{
  const std::size_t number = members.size();
  const TetrahedraFields& from = *frame.Fields;
  TetrahedraFields to;
  to.Kind = from.Kind;
  std::copy_n(from.Range, 2, to.Range);
  const auto copy = [&](const auto& source, auto& target, bool isOfPoints)
  {
    target.resize(source.empty() ? 0 : isOfPoints ? 4 * number : number);
    ParallelFor(0, static_cast<vtkIdType>(target.size()), CHUNK,
      [&](vtkIdType i)
      {
        target[i] = source[isOfPoints ? frame.Mesh->GetCorners(members[i / 4].Tetrahedron)[i % 4]
                                      : members[i].Tetrahedron];
      });
  };
  copy(from.Scalars, to.Scalars, true);
  copy(from.Colors, to.Colors, from.Kind == TetrahedraFields::POINT_COLORS);
  copy(from.DeltaT, to.DeltaT, true);
  copy(from.Layers, to.Layers, false);
  copy(from.Faces, to.Faces, false);
  copy(from.FaceMaterials, to.FaceMaterials, false);
  copy(from.Normals, to.Normals, true);
  copy(from.TextureCoordinates, to.TextureCoordinates, true);
  if (to.DeltaT.empty())
  {
    to.DeltaT.assign(4 * number, 1.0f);
  }
  return to;
}
}

void TetrahedraSubset::Rank(const TetrahedraFrame& frame, std::uint32_t number)
{
  const TetrahedraMesh& mesh = *frame.Mesh;
  const KeyTable table(mesh.GetNumberOfTetrahedra(), Importance(frame, this->SurfaceOpacity));
  this->Ranked = table.FindSmallest(number + 1);
  this->Keys.resize(this->Ranked.size());
  std::transform(this->Ranked.begin(), this->Ranked.end(), this->Keys.begin(),
    [&table](std::uint32_t tetrahedron) { return table.Get(tetrahedron); });
  this->NumberRanked = number;
  this->Bounds = FindBounds(mesh);
}

std::vector<TetrahedraSubset::Member> TetrahedraSubset::Select(std::uint32_t number) const
{
  std::vector<Member> members;
  if (number >= this->Ranked.size())
  {
    for (const std::uint32_t tetrahedron : this->Ranked)
    {
      members.push_back({ tetrahedron, 1.0 });
    }
    return members;
  }
  std::vector<std::uint32_t> keys = this->Keys;
  std::nth_element(keys.begin(), keys.begin() + number, keys.end());
  const std::uint32_t next = keys[number];
  // If keys are equal, the tetrahedra with the smallest indices come first.
  auto ties = number -
    std::count_if(
      keys.begin(), keys.begin() + number, [next](std::uint32_t key) { return key < next; });
  members.reserve(number);
  for (std::size_t i = 0; i < this->Ranked.size(); ++i)
  {
    if (this->Keys[i] < next || (this->Keys[i] == next && ties-- > 0))
    {
      // The key is the hash divided by the importance. The weight is the ratio of 1 / (key of the
      // next tetrahedron) to the importance, but at least 1.
      const double weight = ToFloat(this->Keys[i]) / (ToFloat(next) * GetHash(this->Ranked[i]));
      members.push_back({ this->Ranked[i], std::max(1.0, weight) });
    }
  }
  return members;
}

bool TetrahedraSubset::Update(const TetrahedraFrame& frame, std::uint32_t number,
  TetrahedraMesh& mesh, TetrahedraFields& fields)
{
  const float opacity = frame.Surface ? frame.Surface->GetLargestOpacity() : 0.0f;
  TetrahedraFrame::Changes versions = frame.Versions;
  versions.Order = 0;
  versions.Surface = 0;
  const bool isRanked = versions == this->Versions && frame.Blend == this->Blend &&
    opacity == this->SurfaceOpacity && number <= this->NumberRanked;
  if (isRanked && number == this->Number)
  {
    return false;
  }
  this->Versions = versions;
  this->Blend = frame.Blend;
  this->SurfaceOpacity = opacity;
  this->Number = number;
  if (!isRanked)
  {
    // Finer levels of detail then need no other pass over the mesh.
    this->Rank(frame, std::max(number, LevelOfDetail::MAXIMUM_SUBSET));
  }

  const std::vector<Member> members = this->Select(number);
  const std::size_t size = members.size();
  fields = CopyFields(frame, members);
  mesh = TetrahedraMesh();
  mesh.Origin = frame.Mesh->Origin;
  mesh.Scale = frame.Mesh->Scale;
  mesh.Points.resize(12 * size);
  mesh.Corners.resize(4 * size);
  ParallelFor(0, static_cast<vtkIdType>(size), CHUNK,
    [&](vtkIdType t)
    { this->Enlarge(frame, members[t], static_cast<std::uint32_t>(t), mesh, fields); });
  return true;
}

void TetrahedraSubset::Enlarge(const TetrahedraFrame& frame, const Member& member,
  std::uint32_t tetrahedron, TetrahedraMesh& mesh, TetrahedraFields& fields) const
{
  const std::uint32_t* corners = frame.Mesh->GetCorners(member.Tetrahedron);
  const double weight = frame.Mesh->CellStride * member.Weight;
  const bool hasTriangle = this->SurfaceOpacity > 0.0f && fields.Faces[tetrahedron] != 0;
  const double factor = hasTriangle ? std::sqrt(weight) : std::cbrt(weight);
  glm::dvec3 center(0.0);
  for (int k = 0; k < 4; ++k)
  {
    center += 0.25 * glm::make_vec3(frame.Mesh->GetPoint(corners[k]));
  }
  for (std::uint32_t k = 0; k < 4; ++k)
  {
    const double* from = frame.Mesh->GetPoint(corners[k]);
    mesh.Corners[4 * std::size_t{ tetrahedron } + k] = 4 * tetrahedron + k;
    for (int i = 0; i < 3; ++i)
    {
      mesh.Points[3 * (4 * std::size_t{ tetrahedron } + k) + i] = factor > 1.0
        ? std::clamp(
            center[i] + factor * (from[i] - center[i]), this->Bounds[0][i], this->Bounds[1][i])
        : from[i];
    }
  }
  if (factor > 1.0)
  {
    const double represented = weight * std::abs(frame.Mesh->GetVolumeTimesSix(corners));
    const double volume = std::abs(mesh.GetVolumeTimesSix(tetrahedron));
    const auto gain =
      static_cast<float>(represented < MAXIMUM_GAIN * volume ? represented / volume : MAXIMUM_GAIN);
    for (int k = 0; k < 4; ++k)
    {
      fields.DeltaT[4 * std::size_t{ tetrahedron } + k] *= gain;
    }
  }
}

}
