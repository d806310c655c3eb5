// SPDX-License-Identifier: BSD-3-Clause
// vtkStreamlineTexture: contents of mipmap levels, number of visible lines as a function of
// distance, contrast, grids, colors, uploads.
#include "StripedQuad.h"
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Pages/StabilityCase.h"

#include "vtkStreamlineTexture.h"

#include "Loader/OpenGLFunctions.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

namespace
{

using namespace reference;

// Render targets and texture filtering of graphics cards have a precision of 8 bits.
constexpr double TOLERANCE = 2.0 / 255.0;

struct Level
{
  int Width;
  int Height;
  std::vector<unsigned char> Texels;
};

std::vector<Level> ReadLevels(StripedQuad& quad, vtkStreamlineTexture* texture, int count)
{
  quad.Window->MakeCurrent();
  texture->GetTextureObject()->Activate();
  std::vector<Level> levels;
  for (int i = 0; i < count; ++i)
  {
    Level level;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, i, GL_TEXTURE_WIDTH, &level.Width);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, i, GL_TEXTURE_HEIGHT, &level.Height);
    level.Texels.resize(4 * static_cast<std::size_t>(level.Width) * level.Height);
    glGetTexImage(GL_TEXTURE_2D, i, GL_RGBA, GL_UNSIGNED_BYTE, level.Texels.data());
    levels.push_back(level);
  }
  texture->GetTextureObject()->Deactivate();
  return levels;
}

/// Returns the fraction of texel \a i covered by lines at multiples of \a period, by brute force.
/// Lines are shifted by \a shift periods.
double GetCoverage(int i, int period, double width, double shift)
{
  constexpr int parts = 1000;
  int covered = 0;
  for (int part = 0; part < parts; ++part)
  {
    const double position = (i + (part + 0.5) / parts) / period - shift;
    covered += std::abs(position - std::round(position)) < 0.5 * width ? 1 : 0;
  }
  return static_cast<double>(covered) / parts;
}

/// Compares every mipmap level with the exact coverage of its texels by lines.
void TestLevels(
  Check& check, int lines, int texels, double width, int direction, double offset = 0.0)
{
  check.SetContext("levels of " + std::to_string(lines) + " lines of " + std::to_string(texels) +
    " texels, width " + std::to_string(width) + ": ");
  const double line[3] = { 0.2, 0.4, 0.6 };
  const double background[4] = { 0.9, 0.8, 0.7, 0.5 };
  vtkNew<vtkStreamlineTexture> texture;
  texture->SetNumberOfLines(lines);
  texture->SetTexelsPerLine(texels);
  texture->SetLineWidth(width);
  texture->SetLineColor(line);
  texture->SetBackgroundColor(background);
  texture->SetDirection(direction);
  texture->SetOffset(offset);
  StripedQuad quad(1.0, 1.0);
  quad.Actor->SetTexture(texture);
  quad.Draw();
  const int count = static_cast<int>(std::lround(std::log2(lines))) + 1;
  check.Equal(texture->GetNumberOfLevels(), count, "number of levels");
  const std::vector<Level> levels = ReadLevels(quad, texture, count + 1);
  check.Equal(levels[count].Width, 0, "there is no further level");
  for (int k = 0; k < count; ++k)
  {
    const Level& level = levels[k];
    const bool isAlongS = direction == vtkStreamlineTexture::S;
    const int length = isAlongS ? level.Width : level.Height;
    check.Equal(isAlongS ? level.Height : level.Width, 1, "texels across the lines");
    check.Equal(length, (lines >> k) * texels, "texels of level " + std::to_string(k));
    double largest = 0.0;
    for (int i = 0; i < length; ++i)
    {
      const double coverage = GetCoverage(i, texels, width, offset * (lines >> k));
      for (int channel = 0; channel < 4; ++channel)
      {
        const double target = channel < 3 ? line[channel] : 1.0;
        const double expected = background[channel] + coverage * (target - background[channel]);
        reference::KeepLargest(largest, std::abs(level.Texels[4 * i + channel] / 255.0 - expected));
      }
    }
    check.That(largest <= 1.01 / 255.0,
      "level " + std::to_string(k) + ": largest error " + std::to_string(largest));
  }
}

/// Checks the distance between visible lines in pixels for different sizes of the quad.
void TestDistances(StabilityCatalogue& catalogue, int direction)
{
  vtkNew<vtkStreamlineTexture> texture;
  texture->SetNumberOfLines(1024);
  texture->SetDirection(direction);
  const bool isColumn = direction == vtkStreamlineTexture::T;
  StripedQuad quad(1.0, 1.0);
  quad.Actor->SetTexture(texture);
  double before = 0.0;
  std::vector<std::pair<double, double>> all;
  for (const double pixels :
    { 40.0, 64.0, 90.0, 100.0, 150.0, 256.0, 400.0, 480.0, 1024.0, 1700.0, 3000.0, 8000.0 })
  {
    std::ostringstream name;
    name << "side-" << pixels << (isColumn ? "-t" : "-s");
    const std::string extreme =
      "1024 lines over " + std::to_string(static_cast<int>(pixels)) + " pixels";
    quad.SetPixels(pixels);
    const int half = static_cast<int>(std::min(pixels, static_cast<double>(WINDOW)) / 2.0);
    const Lines lines = FindLines(quad.Draw(isColumn), WINDOW / 2 - half, WINDOW / 2 + half - 1);
    const double distance = 2.0 * half / static_cast<double>(lines.Positions.size());
    const auto seen = static_cast<double>(lines.Positions.size()) * pixels / (2.0 * half);
    catalogue.Measure(name.str(), extreme,
      "base-2 logarithm of the distance between lines over 16 pixels", std::log2(distance / 16.0),
      std::log2(1.5));
    bool isOrdered = seen >= before;
    for (const auto& farther : all)
    {
      isOrdered = isOrdered && (2.0 * farther.first > pixels || seen >= 1.5 * farther.second);
    }
    catalogue.Check(name.str() + "-order", extreme,
      "at least as many lines as from farther away, and more than from twice as far",
      std::to_string(seen) + " lines", isOrdered);
    all.emplace_back(pixels, seen);
    before = seen;
    catalogue.Measure(name.str() + "-contrast", extreme, "loss of contrast of lines and gaps",
      std::max(1.0 - lines.Lightest, lines.Darkest - 0.25), 0.05);
  }
}

/// With far more lines than pixels, the coarsest level shows one line with visible contrast.
void TestFarAway(StabilityCatalogue& catalogue)
{
  vtkNew<vtkStreamlineTexture> texture;
  texture->SetTexelsPerLine(8);
  StripedQuad quad(1.0, 1.0);
  quad.Actor->SetTexture(texture);
  quad.SetPixels(16.0);
  const Lines lines = FindLines(quad.Draw(), WINDOW / 2 - 8, WINDOW / 2 + 7);
  catalogue.Measure("far-away", "256 lines over 16 pixels", "loss of contrast",
    1.0 - lines.Lightest + lines.Darkest, 0.5);
  // If the texture is repeated 64 times, every period shows one line.
  StripedQuad repeated(64.0, 1.0);
  repeated.Actor->SetTexture(texture);
  const Lines all = FindLines(repeated.Draw(), 0, WINDOW - 1);
  catalogue.Measure("repeated", "texture coordinates to 64 over 512 pixels",
    "difference from 64 lines", static_cast<double>(all.Positions.size()) - 64.0, 1.0);
  catalogue.Measure("repeated-contrast", "texture coordinates to 64 over 512 pixels",
    "loss of contrast", 1.0 - all.Lightest + all.Darkest, 0.3);
}

/// Grid lines have the same spacing in both directions, even if the ranges of the texture
/// coordinates differ.
void TestGrid(Check& check)
{
  check.SetContext("grid: ");
  vtkNew<vtkStreamlineTexture> streamlines;
  vtkNew<vtkStreamlineTexture> timelines;
  timelines->SetDirection(vtkStreamlineTexture::T);
  timelines->SetBackgroundColor(1.0, 1.0, 1.0, 0.0);
  StripedQuad quad(0.5, 8.0);
  vtkStreamlineTexture::AddTo(quad.Actor, streamlines, timelines);
  for (const bool isColumn : { false, true })
  {
    // The camera is moved so that the center row and column are not on a line.
    quad.Renderer->GetActiveCamera()->SetFocalPoint(7.0 / WINDOW, 7.0 / WINDOW, 0.0);
    quad.Renderer->GetActiveCamera()->SetPosition(7.0 / WINDOW, 7.0 / WINDOW, 1.0);
    const Lines lines = FindLines(quad.Draw(isColumn), 8, WINDOW - 16);
    const double distance = (WINDOW - 24.0) / static_cast<double>(lines.Positions.size());
    check.That(distance >= 16.0 / 1.5 && distance <= 16.0 * 1.5,
      (isColumn ? "timelines " : "streamlines ") + std::to_string(distance) + " pixels apart");
    check.That(lines.Lightest >= 0.95 && lines.Darkest <= 0.3, "contrast");
  }
  vtkStreamlineTexture::AddTo(quad.Actor, nullptr, timelines);
  check.That(quad.Actor->GetTexture() == timelines.Get(), "timelines only");
  check.That(quad.Actor->GetProperty()->GetAllTextures().empty(), "no second texture is left");
}

/// The texture is multiplied by the mapper's colors. Without a background, the gaps between lines
/// are transparent.
void TestColors(Check& check)
{
  check.SetContext("colors: ");
  StripedQuad quad(1.0, 1.0);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < quad.Data->GetNumberOfPoints(); ++i)
  {
    colors->InsertNextTuple3(51.0, 204.0, 102.0);
  }
  quad.Data->GetPointData()->SetScalars(colors);
  quad.Renderer->SetBackground(0.8, 0.1, 0.3);
  vtkNew<vtkStreamlineTexture> texture;
  texture->SetNumberOfLines(8);
  texture->SetLineWidth(0.5);
  quad.Actor->SetTexture(texture);
  // Lines are 64 pixels apart and 32 wide, starting at the left.
  const auto expect = [&](const std::string& name, const std::array<double, 3>& line,
                        const std::array<double, 3>& between)
  {
    const StripedQuad::Row row = quad.Draw();
    for (int channel = 0; channel < 3; ++channel)
    {
      check.Near(row[64][channel], line[channel], TOLERANCE, name + ", line", 1.0);
      check.Near(row[96][channel], between[channel], TOLERANCE, name + ", between", 1.0);
    }
  };
  check.Equal(texture->IsTranslucent(), 0, "translucent");
  expect("white background", { { 0.0, 0.0, 0.0 } }, { { 0.2, 0.8, 0.4 } });
  texture->SetLineColor(1.0, 0.5, 0.5);
  texture->SetBackgroundColor(0.5, 1.0, 1.0, 1.0);
  expect("line and background color", { { 0.2, 0.4, 0.2 } }, { { 0.1, 0.8, 0.4 } });
  texture->SetBackgroundColor(1.0, 1.0, 1.0, 0.0);
  check.Equal(texture->IsTranslucent(), 1, "translucent");
  expect("no background", { { 0.2, 0.4, 0.2 } }, { { 0.8, 0.1, 0.3 } });
  texture->SetBackgroundColor(1.0, 1.0, 1.0, 0.5);
  expect("half a background", { { 0.2, 0.4, 0.2 } }, { { 0.5, 0.45, 0.35 } });
}

/// A changed setting causes one upload of the texture. Drawing again causes none. Resources can be
/// released.
void TestUploads(Check& check)
{
  check.SetContext("uploads: ");
  vtkNew<vtkStreamlineTexture> texture;
  StripedQuad quad(1.0, 1.0);
  quad.Actor->SetTexture(texture);
  check.Equal(texture->GetNumberOfUploads(), 0, "no upload before drawing");
  quad.Draw();
  quad.SetPixels(100.0);
  quad.Draw();
  check.Equal(texture->GetNumberOfUploads(), 1, "one upload for two images");
  texture->SetLineWidth(0.5);
  texture->SetTexelsPerLine(8);
  const StripedQuad::Row wide = quad.Draw();
  quad.Draw();
  check.Equal(texture->GetNumberOfUploads(), 2, "after a change");
  texture->SetLineWidth(0.5);
  quad.Draw();
  check.Equal(texture->GetNumberOfUploads(), 2, "no upload for an unchanged setting");
  texture->ReleaseGraphicsResources(quad.Window);
  vtkTextureObject* released = texture->GetTextureObject();
  check.That(!released || released->GetHandle() == 0, "the texture is released");
  check.That(quad.Draw() == wide, "the image is equal after a release");
  check.Equal(texture->GetNumberOfUploads(), 3, "one upload after a release");
  // The texture is used in another window.
  StripedQuad other(1.0, 1.0);
  other.Actor->SetTexture(texture);
  other.SetPixels(100.0);
  quad.Actor->SetTexture(nullptr);
  check.That(other.Draw() == wide, "the image is equal in another window");
  check.Equal(texture->GetNumberOfUploads(), 4, "one upload in another window");
  // A texture with fewer lines has fewer levels.
  texture->SetNumberOfLines(4);
  other.Draw();
  check.Equal(texture->GetNumberOfLevels(), 3, "levels of four lines");
  other.SetPixels(400.0);
  check.Equal(static_cast<long long>(FindLines(other.Draw(), 56, 455).Positions.size()), 4,
    "four lines in a close view");
}

void TestSettings(StabilityCatalogue& catalogue)
{
  vtkNew<vtkStreamlineTexture> texture;
  for (const int number : { 0, -4, 3, 8192 })
  {
    const std::string errors = CaptureErrors(texture, [&]() { texture->SetNumberOfLines(number); });
    const std::string text = std::to_string(number);
    catalogue.Check("lines-" + text, text + " lines",
      "an error that names the number, and 256 lines remain", errors,
      errors.find("NumberOfLines " + text) != std::string::npos &&
        texture->GetNumberOfLines() == 256);
  }
  for (const double offset :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    const std::string errors = CaptureErrors(texture, [&]() { texture->SetOffset(offset); });
    catalogue.Check("offset-" + std::to_string(offset), "an offset of " + std::to_string(offset),
      "an error, and an offset of 0 remains", errors,
      errors.find("is not finite") != std::string::npos && texture->GetOffset() == 0.0);
  }
  texture->SetNumberOfLines(1);
  texture->SetTexelsPerLine(1);
  texture->SetLineWidth(-1.0);
  texture->SetDirection(7);
  catalogue.Check("clamped", "1 texel, a width of -1, direction 7", "2, 0 and T",
    std::to_string(texture->GetTexelsPerLine()) + ", " + std::to_string(texture->GetLineWidth()) +
      ", " + std::to_string(texture->GetDirection()),
    texture->GetTexelsPerLine() == 2 && texture->GetLineWidth() == 0.0 &&
      texture->GetDirection() == vtkStreamlineTexture::T);
  StripedQuad quad(1.0, 1.0);
  quad.Actor->SetTexture(texture);
  StripedQuad::Row row;
  const auto draw = [&]() { row = quad.Draw(); };
  const bool isSilent = CaptureErrors(texture, draw).empty();
  catalogue.Measure("width-0", "one line of zero width", "fraction of light that is lost",
    isSilent ? 1.0 - row[WINDOW / 2][0] : std::nan(""), 0.01);
  texture->SetLineWidth(1.0);
  catalogue.Measure("width-1", "one line as wide as the line spacing",
    "fraction of light that is left", quad.Draw()[WINDOW / 2][0], 0.01);
  // The size of the texture exceeds the limit of OpenGL.
  texture->SetNumberOfLines(4096);
  texture->SetTexelsPerLine(256);
  texture->SetLineWidth(0.5);
  texture->SetDirection(vtkStreamlineTexture::S);
  quad.SetPixels(1000.0);
  const std::string errors = CaptureErrors(texture, draw);
  catalogue.Check("no-room", "4096 lines of 256 texels", "an error that names the number of lines",
    errors, errors.find("does not allow 4096 lines") != std::string::npos);
  catalogue.Measure("no-room-lines", "4096 lines of 256 texels", "brightness of lines",
    FindLines(row, 0, WINDOW - 1).Darkest, 0.1);
}

void TestPrinted(Check& check)
{
  vtkNew<vtkStreamlineTexture> texture;
  texture->SetTexelsPerLine(256);
  check.Contains(Print(texture), "TexelsPerLine: 256");
}

}

int TestStreamlineTexture(int argc, char* argv[])
{
  Check check;
  TestLevels(check, 256, 16, 0.25, vtkStreamlineTexture::S);
  TestLevels(check, 32, 8, 0.3, vtkStreamlineTexture::T);
  TestLevels(check, 1, 2, 1.0, vtkStreamlineTexture::S);
  TestLevels(check, 2, 7, 0.1, vtkStreamlineTexture::S);
  TestLevels(check, 64, 16, 0.25, vtkStreamlineTexture::T, 0.013);
  TestLevels(check, 8, 5, 1.0, vtkStreamlineTexture::S, -3.7);
  TestGrid(check);
  TestColors(check);
  TestUploads(check);
  TestPrinted(check);
  StabilityCatalogue catalogue("TestStreamlineTexture", argc, argv);
  catalogue.SetClass("vtkStreamlineTexture");
  TestDistances(catalogue, vtkStreamlineTexture::S);
  TestDistances(catalogue, vtkStreamlineTexture::T);
  TestFarAway(catalogue);
  TestSettings(catalogue);
  return std::max(check.Result(), catalogue.GetExitCode());
}
