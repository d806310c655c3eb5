// SPDX-License-Identifier: BSD-3-Clause
// vtkStreamSurfaceMapper: number and positions of lines on the screen, images equal to those of
// vtkPolyDataMapper with the same textures, combination with textures and colors, changes, errors.
#include "StripedQuad.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Support/Pages/StabilityCase.h"

#include "vtkStreamSurfaceMapper.h"
#include "vtkStreamlineTexture.h"

#include "vtkImageData.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <functional>
#include <string>

namespace
{

using namespace reference;

using Mapper = vtkSmartPointer<vtkStreamSurfaceMapper>;

/// A quad drawn by a mapper of stream surfaces.
struct Surface
{
  explicit Surface(double s = 1.0, double t = 1.0)
    : Quad(s, t, this->Draws)
  {
  }
  Mapper Draws = Mapper::New();
  StripedQuad Quad;
};

/// At distances of lines that are a level of the texture, the number of lines is known.
void TestNumberOfLines(Check& check)
{
  check.SetContext("number of lines");
  for (const bool isColumn : { false, true })
  {
    Surface surface;
    surface.Draws->SetStreamlines(!isColumn);
    surface.Draws->SetTimelines(isColumn);
    for (const int pixels : { 64, 128, 256, 512, 1024 })
    {
      surface.Quad.SetPixels(pixels);
      const int seen = std::min(pixels, WINDOW);
      // The search begins and ends between two lines.
      const int first = (WINDOW - seen) / 2 + 8;
      const Lines lines = FindLines(surface.Quad.Draw(isColumn), first, first + seen - 16);
      check.Equal(static_cast<long long>(lines.Positions.size()), seen / 16 - 1,
        std::string(isColumn ? "timelines" : "streamlines") + " over " + std::to_string(pixels) +
          " pixels");
      check.That(lines.Lightest > 0.99 && lines.Darkest < 0.01, "contrast");
    }
  }
}

/// A change of the offset moves all lines by this texture coordinate.
void TestOffset(Check& check)
{
  check.SetContext("offset");
  Surface surface;
  surface.Draws->StreamlinesOff();
  surface.Draws->TimelinesOn();
  vtkStreamlineTexture* lines = surface.Draws->GetTimelineTexture();
  lines->SetNumberOfLines(8);
  const StripedQuad::Row before = surface.Quad.Draw(true);
  lines->SetOffset(24.0 / WINDOW);
  const StripedQuad::Row after = surface.Quad.Draw(true);
  double error = 0.0;
  for (int i = 0; i < WINDOW; ++i)
  {
    error = std::max(error, std::abs(after[(i + 24) % WINDOW][0] - before[i][0]));
  }
  check.Near(error, 0.0, 1.5 / 255.0, "lines of a shifted image", 1.0);
  check.That(after != before, "lines move");
  lines->SetOffset(-5.0 / 8.0);
  check.That(surface.Quad.Draw(true) == before, "an offset by whole distances changes nothing");
  lines->SetOffset(-1e300);
  check.That(surface.Quad.Draw(true) == before, "an offset by a huge whole number");
}

void SetLines(vtkStreamlineTexture* streamlines, vtkStreamlineTexture* timelines)
{
  streamlines->SetNumberOfLines(32);
  streamlines->SetLineColor(0.2, 0.1, 0.4);
  timelines->SetNumberOfLines(8);
  timelines->SetDirection(vtkStreamlineTexture::T);
  timelines->SetLineColor(0.8, 0.2, 0.1);
  timelines->SetBackgroundColor(1.0, 1.0, 1.0, 0.0);
}

void AddColors(StripedQuad& quad)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < quad.Data->GetNumberOfPoints(); ++i)
  {
    colors->InsertNextTuple3(51.0 + 40.0 * i, 204.0, 102.0);
  }
  quad.Data->GetPointData()->SetScalars(colors);
}

/// Images equal those of the same textures on an actor with VTK's mapper.
void TestImages(Check& check)
{
  for (const bool hasTimelines : { false, true })
  {
    for (const double pixels : { 100.0, 512.0, 2000.0 })
    {
      check.SetContext(hasTimelines ? "image of a grid" : "image of streamlines");
      Surface surface(0.7, 3.0);
      SetLines(surface.Draws->GetStreamlineTexture(), surface.Draws->GetTimelineTexture());
      surface.Draws->SetTimelines(hasTimelines);
      AddColors(surface.Quad);
      surface.Quad.SetPixels(pixels);
      StripedQuad quad(0.7, 3.0);
      vtkNew<vtkStreamlineTexture> streamlines;
      vtkNew<vtkStreamlineTexture> timelines;
      SetLines(streamlines, timelines);
      vtkStreamlineTexture::AddTo(
        quad.Actor, streamlines, hasTimelines ? timelines.GetPointer() : nullptr);
      AddColors(quad);
      quad.SetPixels(pixels);
      check.That(surface.Quad.Draw() == quad.Draw(), "a row");
      check.That(surface.Quad.Draw(true) == quad.Draw(true), "a column");
    }
  }
}

/// Lines multiply an image on the surface, or are composited over it.
void TestTexture(Check& check)
{
  check.SetContext("texture of the actor");
  Surface surface;
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 12; ++i)
  {
    values[i] = static_cast<unsigned char>(i % 3 == 1 ? 204 : 102);
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  surface.Quad.Actor->SetTexture(texture);
  vtkStreamlineTexture* lines = surface.Draws->GetStreamlineTexture();
  lines->SetNumberOfLines(8);
  lines->SetLineWidth(0.5);
  lines->SetLineColor(1.0, 0.5, 0.5);
  const auto expect = [&](const char* name, double line, double between)
  {
    const StripedQuad::Row row = surface.Quad.Draw();
    // Lines are 64 pixels apart and 32 wide, starting at the left.
    check.Near(row[64][1], line, 2.0 / 255.0, std::string(name) + ", line", 1.0);
    check.Near(row[96][1], between, 2.0 / 255.0, std::string(name) + ", between", 1.0);
  };
  expect("white background", 0.4, 0.8);
  lines->SetBackgroundColor(1.0, 1.0, 1.0, 0.0);
  expect("no background", 0.5, 0.8);
  lines->SetBackgroundColor(1.0, 0.5, 1.0, 1.0);
  expect("colored background", 0.4, 0.4);
}

/// Lines of textures on the actor and of the mapper combine, and colors that VTK looks up in a
/// texture do not change the lines.
void TestOtherTextures(Check& check)
{
  check.SetContext("other textures");
  Surface surface;
  surface.Draws->GetStreamlineTexture()->SetNumberOfLines(8);
  Surface both;
  both.Draws->GetStreamlineTexture()->SetNumberOfLines(8);
  vtkNew<vtkStreamlineTexture> streamlines;
  vtkNew<vtkStreamlineTexture> timelines;
  for (vtkStreamlineTexture* texture : { streamlines.Get(), timelines.Get() })
  {
    texture->SetNumberOfLines(8);
    texture->SetLineColor(1.0, 1.0, 1.0);
  }
  timelines->SetDirection(vtkStreamlineTexture::T);
  vtkStreamlineTexture::AddTo(both.Quad.Actor, streamlines, timelines);
  both.Draws->TimelinesOn();
  both.Draws->GetTimelineTexture()->SetLineWidth(0.0);
  check.That(both.Quad.Draw() == surface.Quad.Draw(), "white lines change nothing");

  vtkNew<vtkFloatArray> values;
  for (vtkIdType i = 0; i < surface.Quad.Data->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(static_cast<float>(i % 2));
  }
  surface.Quad.Data->GetPointData()->SetScalars(values);
  const StripedQuad::Row row = surface.Quad.Draw();
  surface.Draws->InterpolateScalarsBeforeMappingOn();
  check.That(surface.Quad.Draw() == row, "colors of a lookup table as a texture");

  Surface copy;
  // VTK 9.1 calls its own deprecated functions here.
  vtkObject::GlobalWarningDisplayOff();
  copy.Draws->ShallowCopy(surface.Draws);
  vtkObject::GlobalWarningDisplayOn();
  copy.Draws->SetInputData(surface.Quad.Data);
  check.That(copy.Quad.Draw() == row, "a shallow copy");
}

void TestTranslucent(Check& check)
{
  check.SetContext("translucent");
  Surface surface;
  surface.Draws->TimelinesOn();
  vtkActor* actor = surface.Quad.Actor;
  check.That(actor->HasOpaqueGeometry() && !actor->HasTranslucentPolygonalGeometry(), "opaque");
  surface.Draws->GetTimelineTexture()->SetBackgroundColor(1.0, 1.0, 1.0, 0.0);
  check.That(actor->HasOpaqueGeometry() && !actor->HasTranslucentPolygonalGeometry(),
    "timelines on opaque streamlines");
  surface.Draws->GetStreamlineTexture()->SetBackgroundColor(1.0, 1.0, 1.0, 0.0);
  check.That(
    !actor->HasOpaqueGeometry() && actor->HasTranslucentPolygonalGeometry(), "no background");
  surface.Quad.Renderer->SetBackground(0.8, 0.1, 0.3);
  surface.Draws->TimelinesOff();
  surface.Draws->GetStreamlineTexture()->SetNumberOfLines(8);
  const StripedQuad::Row row = surface.Quad.Draw();
  check.Near(row[32][0], 0.8, 2.0 / 255.0, "the background of the renderer is visible", 1.0);
  check.Near(row[64][0], 0.0, 2.0 / 255.0, "a line", 1.0);
  surface.Draws->StreamlinesOff();
  check.That(actor->HasOpaqueGeometry() != 0, "no lines");
}

/// Without lines, images equal those of VTK's mapper, and no texture is uploaded.
void TestOff(Check& check)
{
  check.SetContext("lines off");
  Surface surface;
  surface.Draws->StreamlinesOff();
  AddColors(surface.Quad);
  StripedQuad quad(1.0, 1.0);
  AddColors(quad);
  check.That(surface.Quad.Draw() == quad.Draw(), "image");
  check.Equal(surface.Draws->GetStreamlineTexture()->GetNumberOfUploads() +
      surface.Draws->GetTimelineTexture()->GetNumberOfUploads(),
    0, "uploads");
}

/// Texture coordinates that lines cannot use: one error for each input, and a surface without
/// lines.
void TestErrors(StabilityCatalogue& catalogue)
{
  Surface surface;
  StripedQuad quad(1.0, 1.0);
  vtkPointData* points = surface.Quad.Data->GetPointData();
  const vtkSmartPointer<vtkDataArray> coordinates = points->GetTCoords();
  const StripedQuad::Row striped = surface.Quad.Draw();
  const StripedQuad::Row plain = quad.Draw();
  StripedQuad::Row row;
  const auto draw = [&] { row = surface.Quad.Draw(); };
  const auto expect = [&](const std::string& name, const std::string& input, vtkDataArray* array,
                        const std::string& message)
  {
    points->SetTCoords(array);
    const std::string errors = CaptureErrors(surface.Draws, draw);
    const bool isPlain = row == plain;
    const bool isSilent = CaptureErrors(surface.Draws, draw).empty();
    catalogue.Check(name, input, "one error, and the surface without lines", errors,
      errors.find(message) != std::string::npos && isPlain && isSilent);
    points->SetTCoords(coordinates);
    const bool isValid = CaptureErrors(surface.Draws, draw).empty();
    catalogue.Check(name + "-mended", "two components after " + input, "lines without an error",
      isValid ? "no error" : "an error", isValid && row == striped);
  };
  expect("no-coordinates", "no texture coordinates", nullptr, "the number of components is 0");
  vtkNew<vtkFloatArray> three;
  three->SetNumberOfComponents(3);
  three->SetNumberOfTuples(surface.Quad.Data->GetNumberOfPoints());
  three->Fill(0.0);
  expect("three-components", "three components", three, "the number of components is 3");
  vtkNew<vtkFloatArray> one;
  one->SetNumberOfTuples(surface.Quad.Data->GetNumberOfPoints());
  one->CopyComponent(0, coordinates, 0);
  points->SetTCoords(one);
  const std::string errors = CaptureErrors(surface.Draws, draw);
  catalogue.Check("one-component", "one component and streamlines", "the lines of two components",
    errors, errors.empty() && row == striped);
  surface.Draws->TimelinesOn();
  const std::string timelines = CaptureErrors(surface.Draws, draw);
  catalogue.Check("one-component-timelines", "one component and timelines",
    "an error, and the surface without lines", timelines,
    timelines.find("Timelines need texture coordinates with two components") != std::string::npos &&
      row == plain);
  surface.Draws->TimelinesOff();
  vtkNew<vtkPolyData> empty;
  surface.Draws->SetInputData(empty);
  const std::string none = CaptureErrors(surface.Draws, draw);
  catalogue.Check("empty", "an empty input", "no error", none, none.empty());
}

/// After each of many random changes, the image equals that of a new mapper.
void TestChanges(Check& check)
{
  Surface surface;
  vtkStreamSurfaceMapper* mapper = surface.Draws;
  vtkStreamlineTexture* streamlines = mapper->GetStreamlineTexture();
  vtkStreamlineTexture* timelines = mapper->GetTimelineTexture();
  Random numbers(5);
  double pixels = WINDOW;
  const std::vector<std::function<void(double)>> changes = {
    [&](double x) { mapper->SetStreamlines(x < 0.7); },
    [&](double x) { mapper->SetTimelines(x < 0.7); },
    [&](double x) { streamlines->SetNumberOfLines(1 << static_cast<int>(6.0 * x)); },
    [&](double x) { timelines->SetNumberOfLines(1 << static_cast<int>(6.0 * x)); },
    [&](double x) { streamlines->SetBackgroundColor(1.0, 0.7, x, x < 0.5 ? 1.0 : 0.3); },
    [&](double x) { timelines->SetBackgroundColor(0.6, 1.0, x, x < 0.5 ? 1.0 : 0.0); },
    [&](double x) { timelines->SetOffset(x); },
    [&](double x) { streamlines->SetTexelsPerLine(8 + static_cast<int>(20.0 * x)); },
    [&](double x) { timelines->SetLineWidth(x); },
    [&](double x) { pixels = 100.0 + 900.0 * x; },
    [&](double) { mapper->ReleaseGraphicsResources(surface.Quad.Window); },
  };
  for (int i = 0; i < 60; ++i)
  {
    check.SetContext("change " + std::to_string(i));
    const auto kind = static_cast<std::size_t>(numbers.Get(0.0, 0.999) * changes.size());
    changes[kind](numbers.Get(0.0, 0.999));
    surface.Quad.SetPixels(pixels);
    Surface fresh;
    fresh.Draws->SetStreamlines(mapper->GetStreamlines());
    fresh.Draws->SetTimelines(mapper->GetTimelines());
    fresh.Quad.SetPixels(pixels);
    const auto copy = [](vtkStreamlineTexture* to, vtkStreamlineTexture* from)
    {
      to->SetNumberOfLines(from->GetNumberOfLines());
      to->SetBackgroundColor(from->GetBackgroundColor());
      to->SetOffset(from->GetOffset());
      to->SetTexelsPerLine(from->GetTexelsPerLine());
      to->SetLineWidth(from->GetLineWidth());
    };
    copy(fresh.Draws->GetStreamlineTexture(), streamlines);
    copy(fresh.Draws->GetTimelineTexture(), timelines);
    const bool isColumn = i % 2 == 1;
    check.That(surface.Quad.Draw(isColumn) == fresh.Quad.Draw(isColumn),
      "the image equals that of a new mapper after change " + std::to_string(kind));
  }
}

}

int TestStreamSurfaceMapper(int argc, char* argv[])
{
  Check check;
  TestNumberOfLines(check);
  TestOffset(check);
  TestImages(check);
  TestTexture(check);
  TestOtherTextures(check);
  TestTranslucent(check);
  TestOff(check);
  TestChanges(check);
  StabilityCatalogue catalogue("TestStreamSurfaceMapper", argc, argv);
  catalogue.SetClass("vtkStreamSurfaceMapper");
  TestErrors(catalogue);
  return std::max(check.Result(), catalogue.GetExitCode());
}
