// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Inputs/Models.h"

#include "vtkMath.h"
#include "vtkPolyData.h"

#include <cmath>

namespace interlume
{

namespace
{

const std::array<double, 3> Ivory = { { 0.93, 0.89, 0.78 } };
const std::array<double, 3> Wood = { { 0.60, 0.40, 0.24 } };
const std::array<double, 3> DarkWood = { { 0.42, 0.27, 0.16 } };
const std::array<double, 3> Steel = { { 0.62, 0.65, 0.69 } };

/// Scales a profile by \a radius and \a height and shifts it to \a z.
std::vector<ProfilePoint> Scale(
  std::vector<ProfilePoint> profile, double radius, double height, double z)
{
  for (ProfilePoint& point : profile)
  {
    point = { { radius * point[0], z + height * point[1] } };
  }
  return profile;
}

ModelPart MakeBlock(const Position3& center, const Position3& lengths, double radius,
  const std::array<double, 3>& color)
{
  return { MoveShape(MakeRoundedBox(lengths, radius), center), color, 0.12 };
}

}

Model MakeMushroom(double height, double capRadius, double lean)
{
  const double capHeight = 0.72 * capRadius;
  const double rim = height - capHeight;
  const double shift = lean * height;
  // The profile has a dome, a rim that curls inward, and gills that rise toward the stem.
  vtkSmartPointer<vtkPolyData> cap =
    Revolve(Scale({ { { 0.0, 1.0 } }, { { 0.25, 0.97 } }, { { 0.5, 0.86 } }, { { 0.75, 0.63 } },
                    { { 0.93, 0.32 } }, { { 1.0, 0.08 } }, { { 0.97, -0.03 } }, { { 0.88, -0.01 } },
                    { { 0.6, 0.1 } }, { { 0.25, 0.18 } }, { { 0.0, 0.2 } } },
              capRadius, capHeight, rim),
      true, 80.0);
  const double r = 0.22 * capRadius;
  const double top = rim + 0.22 * capHeight;
  vtkSmartPointer<vtkPolyData> stem =
    MakeTube({ { { 0.0, 0.0, 0.0 } }, { { 0.02 * shift, 0.0, 0.12 * top } },
               { { 0.2 * shift, 0.0, 0.45 * top } }, { { 0.62 * shift, 0.0, 0.8 * top } },
               { { shift, 0.0, top } } },
      { 1.25 * r, 1.45 * r, 1.0 * r, 0.86 * r, 0.95 * r });
  Model model = { { MoveShape(cap, { { shift, 0.0, 0.0 } }, { { 0.0, 40.0 * lean, 0.0 } }),
                    { { 0.72, 0.20, 0.13 } }, 0.35 },
    { stem, Ivory, 0.08 } };
  // White spots on the dome, arranged in a spiral by the golden angle.
  for (int i = 0; i < 14; ++i)
  {
    const double polar = std::sqrt((i + 0.6) / 14.0) * 72.0;
    const double around = 137.508 * i;
    const double size = (0.12 - 0.0011 * polar) * capRadius;
    const double angle = vtkMath::RadiansFromDegrees(polar);
    // Radius and height of the spot relative to the size of the cap, approximating its profile.
    const double out = std::sin(angle) * 0.97;
    const double up = std::pow(std::max(1.0 - out * out, 0.0), 0.56) * 0.985;
    vtkSmartPointer<vtkPolyData> spot = Revolve(
      { { { 0.0, -0.35 * size } }, { { size, -0.35 * size } }, { { 0.92 * size, 0.12 * size } },
        { { 0.6 * size, 0.3 * size } }, { { 0.0, 0.36 * size } } },
      false, 75.0);
    spot = MoveShape(spot, { { 0.0, 0.0, 0.0 } }, { { 0.0, 0.85 * polar, 0.0 } });
    spot = MoveShape(spot, { { out * capRadius, 0.0, up * capHeight } });
    spot = MoveShape(spot, { { 0.0, 0.0, rim } }, { { 0.0, 0.0, around } });
    model.push_back(
      { MoveShape(spot, { { shift, 0.0, 0.0 } }, { { 0.0, 40.0 * lean, 0.0 } }), Ivory, 0.1 });
  }
  return model;
}

Model MakeTeapot()
{
  const std::array<double, 3> glaze = { { 0.16, 0.38, 0.58 } };
  vtkSmartPointer<vtkPolyData> body =
    Revolve({ { { 0.0, 0.0 } }, { { 0.3, 0.0 } }, { { 0.36, 0.025 } }, { { 0.44, 0.12 } },
              { { 0.5, 0.27 } }, { { 0.48, 0.43 } }, { { 0.41, 0.57 } }, { { 0.36, 0.645 } },
              { { 0.355, 0.67 } }, { { 0.33, 0.68 } }, { { 0.15, 0.68 } }, { { 0.0, 0.68 } } },
      true, 60.0);
  vtkSmartPointer<vtkPolyData> lid = MoveShape(
    Revolve({ { { 0.0, 0.0 } }, { { 0.3, 0.0 } }, { { 0.325, 0.012 } }, { { 0.29, 0.045 } },
              { { 0.17, 0.085 } }, { { 0.07, 0.115 } }, { { 0.045, 0.145 } }, { { 0.085, 0.19 } },
              { { 0.075, 0.235 } }, { { 0.03, 0.256 } }, { { 0.0, 0.258 } } },
      true, 60.0),
    { { 0.0, 0.0, 0.675 } });
  vtkSmartPointer<vtkPolyData> handle =
    MakeTube({ { { -0.37, 0.0, 0.56 } }, { { -0.55, 0.0, 0.6 } }, { { -0.71, 0.0, 0.53 } },
               { { -0.72, 0.0, 0.36 } }, { { -0.6, 0.0, 0.21 } }, { { -0.44, 0.0, 0.15 } } },
      { 0.045, 0.046, 0.048, 0.046, 0.042, 0.04 });
  vtkSmartPointer<vtkPolyData> spout =
    MakeTube({ { { 0.4, 0.0, 0.22 } }, { { 0.55, 0.0, 0.27 } }, { { 0.66, 0.0, 0.41 } },
               { { 0.74, 0.0, 0.57 } }, { { 0.85, 0.0, 0.67 } } },
      { 0.15, 0.115, 0.075, 0.058, 0.062 });
  return { { body, glaze, 0.6 }, { lid, glaze, 0.6 }, { handle, glaze, 0.6 },
    { spout, glaze, 0.6 } };
}

Model MakeDart()
{
  const std::array<double, 3> red = { { 0.78, 0.16, 0.12 } };
  // Built along z with the tip at 0, then rotated.
  vtkSmartPointer<vtkPolyData> tip =
    Revolve({ { { 0.0, 0.0 } }, { { 0.012, 0.07 } }, { { 0.014, 0.2 } }, { { 0.0, 0.2 } } }, false);
  std::vector<ProfilePoint> profile = { { { 0.0, 0.19 } }, { { 0.018, 0.19 } },
    { { 0.034, 0.225 } } };
  for (int groove = 0; groove < 6; ++groove)
  {
    const double z = 0.25 + 0.035 * groove;
    profile.push_back({ { 0.036, z } });
    profile.push_back({ { 0.036, z + 0.016 } });
    profile.push_back({ { 0.029, z + 0.02 } });
    profile.push_back({ { 0.029, z + 0.031 } });
  }
  profile.insert(profile.end(),
    { { { 0.034, 0.47 } }, { { 0.034, 0.49 } }, { { 0.02, 0.53 } }, { { 0.0, 0.53 } } });
  vtkSmartPointer<vtkPolyData> barrel = Revolve(profile, false, 25.0);
  vtkSmartPointer<vtkPolyData> shaft =
    Revolve({ { { 0.0, 0.52 } }, { { 0.017, 0.52 } }, { { 0.013, 0.7 } }, { { 0.013, 0.97 } },
              { { 0.0, 0.98 } } },
      false);
  std::vector<vtkSmartPointer<vtkPolyData>> fins;
  for (int i = 0; i < 4; ++i)
  {
    vtkSmartPointer<vtkPolyData> fin =
      MakePlate({ { { 0.008, 0.71 } }, { { 0.11, 0.81 } }, { { 0.13, 0.88 } }, { { 0.13, 1.0 } },
                  { { 0.09, 0.985 } }, { { 0.008, 0.95 } } },
        0.007);
    fin = MoveShape(fin, { { 0.0, 0.0, 0.0 } }, { { 90.0, 0.0, 0.0 } });
    fins.push_back(MoveShape(fin, { { 0.0, 0.0, 0.0 } }, { { 0.0, 0.0, 45.0 + 90.0 * i } }));
  }
  Model dart = { { tip, Steel, 0.7 }, { barrel, { { 0.80, 0.64, 0.28 } }, 0.6 },
    { shaft, { { 0.15, 0.16, 0.19 } }, 0.4 }, { Join(fins), red, 0.2 } };
  for (ModelPart& part : dart)
  {
    part.Shape = MoveShape(part.Shape, { { 0.0, 0.0, 0.0 } }, { { 0.0, -90.0, 0.0 } });
  }
  return dart;
}

Model MakeAirplane()
{
  const std::array<double, 3> white = { { 0.94, 0.94, 0.93 } };
  const std::array<double, 3> blue = { { 0.10, 0.24, 0.55 } };
  const Position3 alongX = { { 0.0, 90.0, 0.0 } };
  vtkSmartPointer<vtkPolyData> hull =
    Revolve({ { { 0.0, 0.0 } }, { { 0.012, 0.01 } }, { { 0.04, 0.14 } }, { { 0.052, 0.3 } },
              { { 0.052, 0.78 } }, { { 0.044, 0.9 } }, { { 0.02, 0.985 } }, { { 0.0, 1.0 } } },
      true);
  vtkSmartPointer<vtkPolyData> engine =
    Revolve({ { { 0.0, 0.0 } }, { { 0.014, 0.0 } }, { { 0.026, 0.05 } }, { { 0.027, 0.12 } },
              { { 0.02, 0.13 } }, { { 0.018, 0.11 } }, { { 0.0, 0.1 } } },
      false);
  std::vector<vtkSmartPointer<vtkPolyData>> wings;
  std::vector<vtkSmartPointer<vtkPolyData>> engines;
  for (const double side : { 1.0, -1.0 })
  {
    // Plates are symmetric about z = 0, so the wing toward -y is the wing toward +y rotated by 180
    // degrees about x.
    const double turn = side > 0.0 ? 0.0 : 180.0;
    const double rise = 5.0 * side;
    wings.push_back(
      MoveShape(MakePlate({ { { 0.44, 0.0 } }, { { 0.68, 0.0 } }, { { 0.62, 0.06 } },
                            { { 0.36, 0.5 } }, { { 0.30, 0.5 } }, { { 0.42, 0.14 } } },
                  0.012),
        { { 0.0, 0.0, -0.02 } }, { { turn + rise, 0.0, 0.0 } }));
    wings.push_back(MoveShape(
      MakePlate(
        { { { 0.03, 0.0 } }, { { 0.15, 0.0 } }, { { 0.05, 0.19 } }, { { 0.0, 0.19 } } }, 0.009),
      { { 0.0, 0.0, 0.01 } }, { { turn + rise, 0.0, 0.0 } }));
    engines.push_back(MoveShape(engine, { { 0.5, 0.18 * side, -0.04 } }, alongX));
  }
  vtkSmartPointer<vtkPolyData> fin = MoveShape(
    MakePlate(
      { { { 0.02, 0.0 } }, { { 0.2, 0.0 } }, { { 0.05, 0.2 } }, { { -0.02, 0.2 } } }, 0.011),
    { { 0.0, 0.0, 0.02 } }, { { 90.0, 0.0, 0.0 } });
  return { { MoveShape(hull, { { 0.0, 0.0, 0.0 } }, alongX), white, 0.4 },
    { Join(wings), { { 0.80, 0.82, 0.85 } }, 0.3 }, { Join(engines), Steel, 0.5 },
    { fin, blue, 0.3 } };
}

Model MakeDesk()
{
  Model desk = { MakeBlock({ { 0.0, 0.0, 0.7 } }, { { 1.2, 0.6, 0.04 } }, 0.012, Wood),
    MakeBlock({ { 0.42, 0.01, 0.385 } }, { { 0.32, 0.54, 0.61 } }, 0.01, DarkWood),
    MakeBlock({ { -0.05, 0.24, 0.53 } }, { { 0.98, 0.02, 0.3 } }, 0.006, DarkWood) };
  for (double y : { -0.24, 0.24 })
  {
    desk.push_back(MakeBlock({ { -0.54, y, 0.35 } }, { { 0.06, 0.06, 0.7 } }, 0.01, Wood));
  }
  for (double x : { 0.3, 0.54 })
  {
    for (double y : { -0.2, 0.22 })
    {
      desk.push_back(MakeBlock({ { x, y, 0.045 } }, { { 0.05, 0.05, 0.1 } }, 0.008, DarkWood));
    }
  }
  for (double z : { 0.18, 0.385, 0.59 })
  {
    desk.push_back(MakeBlock({ { 0.42, -0.265, z } }, { { 0.28, 0.02, 0.17 } }, 0.006, Wood));
    ModelPart knob = { MoveShape(
                         Revolve({ { { 0.0, 0.0 } }, { { 0.008, 0.0 } }, { { 0.01, 0.012 } },
                                   { { 0.018, 0.02 } }, { { 0.014, 0.032 } }, { { 0.0, 0.036 } } },
                           false, 60.0),
                         { { 0.42, -0.274, z } }, { { 90.0, 0.0, 0.0 } }),
      Steel, 0.6 };
    desk.push_back(knob);
  }
  return desk;
}

Model MakeChair()
{
  Model chair = { MakeBlock({ { 0.0, 0.0, 0.45 } }, { { 0.46, 0.44, 0.035 } }, 0.012, Wood),
    MakeBlock({ { 0.0, -0.2, 0.82 } }, { { 0.44, 0.025, 0.1 } }, 0.01, Wood),
    MakeBlock({ { 0.0, -0.2, 0.64 } }, { { 0.4, 0.02, 0.06 } }, 0.008, Wood) };
  for (double x : { -0.2, 0.2 })
  {
    chair.push_back(MakeBlock({ { x, 0.18, 0.22 } }, { { 0.04, 0.04, 0.44 } }, 0.01, DarkWood));
    chair.push_back(MakeBlock({ { x, -0.2, 0.45 } }, { { 0.04, 0.04, 0.9 } }, 0.01, DarkWood));
    chair.push_back(MakeBlock({ { x, 0.0, 0.2 } }, { { 0.025, 0.36, 0.025 } }, 0.006, DarkWood));
  }
  return chair;
}

Model MakeLamp()
{
  const std::array<double, 3> green = { { 0.16, 0.42, 0.34 } };
  vtkSmartPointer<vtkPolyData> base =
    Revolve({ { { 0.0, 0.0 } }, { { 0.1, 0.0 } }, { { 0.105, 0.008 } }, { { 0.09, 0.022 } },
              { { 0.02, 0.032 } }, { { 0.0, 0.034 } } },
      false, 50.0);
  vtkSmartPointer<vtkPolyData> arm =
    MakeTube({ { { 0.0, 0.0, 0.02 } }, { { -0.02, 0.0, 0.22 } }, { { 0.03, 0.0, 0.41 } },
               { { 0.13, 0.0, 0.47 } }, { { 0.2, 0.0, 0.41 } } },
      { 0.011, 0.01, 0.01, 0.01, 0.01 });
  // A thin shell: the profile runs down on the outside and up on the inside.
  vtkSmartPointer<vtkPolyData> shade = MoveShape(
    Revolve({ { { 0.0, 0.1 } }, { { 0.035, 0.1 } }, { { 0.05, 0.085 } }, { { 0.115, 0.0 } },
              { { 0.109, 0.0 } }, { { 0.045, 0.08 } }, { { 0.0, 0.093 } } },
      false, 30.0),
    { { 0.2, 0.0, 0.32 } });
  return { { base, green, 0.4 }, { arm, Steel, 0.6 }, { shade, green, 0.4 } };
}

Model MakeBooks()
{
  Model books;
  const std::array<std::array<double, 3>, 3> colors = { { { { 0.55, 0.13, 0.12 } },
    { { 0.14, 0.29, 0.42 } }, { { 0.70, 0.55, 0.20 } } } };
  for (int i = 0; i < 3; ++i)
  {
    const double z = 0.02 + 0.042 * i;
    const Position3 lengths = { { 0.26 - 0.03 * i, 0.19 - 0.015 * i, 0.0 } };
    const double degrees = 9.0 * i - 6.0;
    const auto add =
      [&](double height, double thickness, double shrink, const std::array<double, 3>& color)
    {
      ModelPart part = MakeBlock({ { 0.0, 0.0, z + height } },
        { { lengths[0] - shrink, lengths[1] - shrink, thickness } }, 0.4 * thickness, color);
      books.push_back(
        { MoveShape(part.Shape, { { 0.0, 0.0, 0.0 } }, { { 0.0, 0.0, degrees } }), color, 0.1 });
    };
    add(-0.017, 0.006, 0.0, colors[i]);
    add(0.017, 0.006, 0.0, colors[i]);
    add(0.0, 0.03, 0.014, Ivory);
  }
  return books;
}

Model MakeMug()
{
  const std::array<double, 3> white = { { 0.90, 0.90, 0.88 } };
  vtkSmartPointer<vtkPolyData> cup =
    Revolve({ { { 0.0, 0.0 } }, { { 0.036, 0.0 } }, { { 0.04, 0.004 } }, { { 0.042, 0.095 } },
              { { 0.04, 0.098 } }, { { 0.038, 0.095 } }, { { 0.036, 0.01 } }, { { 0.0, 0.008 } } },
      false, 40.0);
  vtkSmartPointer<vtkPolyData> handle =
    MakeTube({ { { 0.04, 0.0, 0.08 } }, { { 0.068, 0.0, 0.078 } }, { { 0.074, 0.0, 0.045 } },
               { { 0.04, 0.0, 0.02 } } },
      { 0.007, 0.007, 0.007, 0.007 });
  return { { cup, white, 0.5 }, { handle, white, 0.5 } };
}

Model Move(const Model& model, const Position3& offset, const Position3& degrees)
{
  Model moved = model;
  for (ModelPart& part : moved)
  {
    part.Shape = MoveShape(part.Shape, offset, degrees);
  }
  return moved;
}

Model& Append(Model& model, const Model& more)
{
  model.insert(model.end(), more.begin(), more.end());
  return model;
}

}
