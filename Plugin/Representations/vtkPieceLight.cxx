// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPieceLight.h"

#include "vtkExtinctionGrid.h"

#include "vtkAreaLight.h"
#include "vtkBoundingBox.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkProjectiveLight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace
{
constexpr int ImageSize = 128;
// Factor by which the screen is larger than the projection of the piece onto it, and by which the
// piece is enlarged to include rays that narrowly miss it.
constexpr double Margin = 1.05;

using Point = std::array<double, 3>;

Point Transform(vtkMatrix4x4* matrix, const Point& point)
{
  const double from[4] = { point[0], point[1], point[2], 1.0 };
  double to[4];
  matrix->MultiplyPoint(from, to);
  return { { to[0], to[1], to[2] } };
}

Point Along(const Point& point, double length, const Point& direction)
{
  return { { point[0] + length * direction[0], point[1] + length * direction[1],
    point[2] + length * direction[2] } };
}

Point Subtract(const Point& a, const Point& b)
{
  return Along(a, -1.0, b);
}

double Dot(const Point& a, const Point& b)
{
  return vtkMath::Dot(a.data(), b.data());
}

double Distance(const Point& a, const Point& b)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), b.data()));
}
}

/// Screen that covers a piece as seen from a light, in world coordinates.
struct vtkPieceLight::View
{
  bool IsPositional = false;
  Point Position{};
  Point Forward{};
  Point Right{};
  Point Up{};
  /// Distance from Position to the screen, and half of the screen's width and height.
  double Distance = 1.0;
  double Half[2] = { 1.0, 1.0 };
  std::array<double, 6> Bounds{};
  vtkMatrix4x4* ToWorld = nullptr;
  vtkNew<vtkMatrix4x4> ToData;

  /// Computes the screen for the box \a bounds. Returns false if no screen can cover the box.
  bool Set(vtkLight* light, const double bounds[6], vtkMatrix4x4* matrix)
  {
    std::copy_n(bounds, 6, this->Bounds.begin());
    this->ToWorld = matrix;
    vtkMatrix4x4::Invert(matrix, this->ToData);
    this->IsPositional = light->GetPositional() != 0;
    Point focus;
    light->GetTransformedPosition(this->Position.data());
    light->GetTransformedFocalPoint(focus.data());
    vtkBoundingBox world;
    Point corners[8];
    for (int corner = 0; corner < 8; ++corner)
    {
      corners[corner] = Transform(matrix,
        { { bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)],
          bounds[4 + ((corner >> 2) & 1)] } });
      world.AddPoint(corners[corner].data());
    }
    Point center;
    world.GetCenter(center.data());
    // A light with a cone retains its axis. Other positional lights are directed at the piece.
    const bool hasCone = this->IsPositional && light->GetConeAngle() < 90.0;
    this->Forward = Subtract(this->IsPositional && !hasCone ? center : focus, this->Position);
    if (vtkMath::Normalize(this->Forward.data()) == 0.0)
    {
      return false;
    }
    if (!this->IsPositional)
    {
      this->Position = Along(center, -world.GetDiagonalLength(), this->Forward);
    }
    vtkMath::Perpendiculars(this->Forward.data(), this->Up.data(), this->Right.data(), 0.0);
    vtkMath::Cross(this->Forward.data(), this->Up.data(), this->Right.data());
    this->Distance = Dot(Subtract(center, this->Position), this->Forward);
    this->Half[0] = this->Half[1] = 0.0;
    for (const Point& corner : corners)
    {
      const Point to = Subtract(corner, this->Position);
      const double depth = Dot(to, this->Forward);
      if (!(depth > 1e-3 * this->Distance))
      {
        return false;
      }
      const double scale = this->IsPositional ? this->Distance / depth : 1.0;
      this->Half[0] = std::max(this->Half[0], Margin * scale * std::abs(Dot(to, this->Right)));
      this->Half[1] = std::max(this->Half[1], Margin * scale * std::abs(Dot(to, this->Up)));
    }
    return this->Half[0] > 0.0 && this->Half[1] > 0.0;
  }

  /// Returns the world position of a point on the screen. \a x and \a y range from -1 to 1.
  Point GetScreenPoint(double x, double y) const
  {
    const Point center = Along(this->Position, this->Distance, this->Forward);
    return Along(Along(center, x * this->Half[0], this->Right), y * this->Half[1], this->Up);
  }
};

vtkPieceLight::vtkPieceLight() = default;

vtkPieceLight::~vtkPieceLight() = default;

void vtkPieceLight::PlaceScreen(vtkLight* light, const View& view)
{
  this->Light->SetLightTypeToSceneLight();
  this->Light->SetPositional(light->GetPositional());
  this->Light->SetAmbientColor(light->GetAmbientColor());
  this->Light->SetDiffuseColor(light->GetDiffuseColor());
  this->Light->SetSpecularColor(light->GetSpecularColor());
  this->Light->SetIntensity(light->GetIntensity());
  this->Light->SetConeAngle(light->GetConeAngle());
  this->Light->SetExponent(light->GetExponent());
  this->Light->SetAttenuationValues(light->GetAttenuationValues());
  this->Light->SetShadowAttenuation(light->GetShadowAttenuation());
  const Point focus = Along(view.Position, view.Distance, view.Forward);
  this->Light->SetPosition(view.Position.data());
  this->Light->SetFocalPoint(focus.data());
  this->Light->SetViewUp(view.Up[0], view.Up[1], view.Up[2]);
  this->Light->SetScreenSize(2.0 * view.Half[0], 2.0 * view.Half[1]);
}

bool vtkPieceLight::Fill(vtkLight* light, const View& view, const vtkExtinctionGrid& grid)
{
  auto* projector = vtkProjectiveLight::SafeDownCast(light);
  vtkNew<vtkMatrix4x4> screen;
  if (projector && !projector->GetScreenMatrix(screen))
  {
    return false;
  }
  std::array<double, 6> enlarged = view.Bounds;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double margin = 0.5 * (Margin - 1.0) * (enlarged[2 * axis + 1] - enlarged[2 * axis]);
    enlarged[2 * axis] -= margin;
    enlarged[2 * axis + 1] += margin;
  }
  const double strength = std::clamp(static_cast<double>(light->GetShadowAttenuation()), 0.0, 1.0);
  this->Image->SetDimensions(ImageSize, ImageSize, 1);
  vtkNew<vtkFloatArray> colors;
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(static_cast<vtkIdType>(ImageSize) * ImageSize);
  bool isAttenuated = false;
  for (int row = 0; row < ImageSize; ++row)
  {
    for (int column = 0; column < ImageSize; ++column)
    {
      const Point point = view.GetScreenPoint(
        2.0 * (column + 0.5) / ImageSize - 1.0, 2.0 * (row + 0.5) / ImageSize - 1.0);
      const Point begin =
        view.IsPositional ? view.Position : Along(point, -1e3 * view.Distance, view.Forward);
      const Point end = Along(begin, 2e3, Subtract(point, begin));
      const Point from = Transform(view.ToData, begin);
      const Point to = Transform(view.ToData, end);
      double entryFraction = vtkExtinctionGrid::FindEntry(view.Bounds, from, to);
      entryFraction =
        entryFraction > 1.0 ? vtkExtinctionGrid::FindEntry(enlarged, from, to) : entryFraction;
      double color[3] = { 1.0, 1.0, 1.0 };
      if (entryFraction <= 1.0)
      {
        const Point entry = Along(from, entryFraction, Subtract(to, from));
        const Point start =
          Along(from, std::min(entryFraction, grid.FindEntry(from, to)), Subtract(to, from));
        const double scale =
          Distance(Transform(view.ToWorld, start), Transform(view.ToWorld, entry)) /
          std::max(Distance(start, entry), VTK_DBL_MIN);
        double depths[3] = { 0.0, 0.0, 0.0 };
        grid.Integrate(start, entry, depths);
        for (int k = 0; k < 3; ++k)
        {
          const double depth = scale * depths[std::min(k, grid.GetChannels() - 1)];
          isAttenuated = isAttenuated || depth > 0.0;
          color[k] = 1.0 - strength * (1.0 - std::exp(-depth));
        }
      }
      if (projector)
      {
        const double position[4] = { point[0], point[1], point[2], 1.0 };
        double uv[4];
        double screenColor[3] = { 0.0, 0.0, 0.0 };
        screen->MultiplyPoint(position, uv);
        if (uv[3] > 0.0)
        {
          projector->GetScreenColor(uv[0] / uv[3], uv[1] / uv[3], screenColor);
        }
        std::transform(color, color + 3, screenColor, color, std::multiplies<double>());
      }
      colors->SetTuple(static_cast<vtkIdType>(row) * ImageSize + column, color);
    }
  }
  this->Image->GetPointData()->SetScalars(colors);
  this->Image->Modified();
  this->Light->SetImage(this->Image);
  return isAttenuated;
}

vtkLight* vtkPieceLight::Update(vtkLight* light, const vtkExtinctionGrid& grid,
  unsigned long version, const double bounds[6], vtkMatrix4x4* matrix)
{
  auto* area = vtkAreaLight::SafeDownCast(light);
  View view;
  if ((area && (area->GetSize()[0] > 0.0 || area->GetSize()[1] > 0.0)) ||
    !view.Set(light, bounds, matrix))
  {
    return light;
  }
  std::vector<double> key(matrix->GetData(), matrix->GetData() + 16);
  key.insert(key.end(), bounds, bounds + 6);
  key.insert(key.end(), view.Position.begin(), view.Position.end());
  key.insert(key.end(), view.Forward.begin(), view.Forward.end());
  key.push_back(static_cast<double>(version));
  // The modification time is not sufficient: VTK moves headlights and camera lights by changing
  // only their transform matrix. Therefore, the key also contains the position and direction.
  key.push_back(static_cast<double>(light->GetMTime()));
  if (key != this->Key)
  {
    this->Key = key;
    this->PlaceScreen(light, view);
    this->IsAttenuated = this->Fill(light, view, grid);
  }
  return this->IsAttenuated ? this->Light.Get() : light;
}
