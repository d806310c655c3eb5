// SPDX-License-Identifier: BSD-3-Clause
// Tests the example that paints on an inflow surface, driven by events in the format of
// vtkInteractorEventRecorder: pixels of the file compared with a formula for the brush, the view of
// the flow, and uploads to the graphics card.
#include "Support/Checks/ReferenceCheck.h"

#include "PainterWindow.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkImplicitFlowField.h>
#include <vtkImplicitFlowVolumeMapper.h>
#include <vtkInteractorEventRecorder.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkTerminationPlane.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

namespace
{

using namespace reference;

constexpr int Columns = 96;
constexpr int Rows = 64;

/// Returns a straight flow along x through a box, and places \a plane where the flow enters the
/// box.
vtkSmartPointer<vtkImageData> MakeFlow(vtkTerminationPlane* plane)
{
  vtkNew<vtkImageData> field;
  field->SetDimensions(3, 3, 3);
  vtkNew<vtkDoubleArray> velocity;
  velocity->SetName("Velocity");
  velocity->SetNumberOfComponents(3);
  for (int i = 0; i < 27; ++i)
  {
    velocity->InsertNextTuple3(1.0, 0.0, 0.0);
  }
  field->GetPointData()->SetVectors(velocity);
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetPoint1(0.0, 2.0, 0.0);
  plane->SetPoint2(0.0, 0.0, 2.0);
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetInputData(field);
  filter->AddTerminationSurface(plane);
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  filter->SetSampleDimensions(9, 9, 9);
  filter->Update();
  return vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
}

/// Number of uploads to the GPU while frames are rendered, and number of these frames.
struct Uploads
{
  int Grid = 0;
  int Inflow = 0;
  int Others = 0;
  int Images = 0;
};

/// A painter window, and a recorder that plays queued events in it.
class Session
{
public:
  Session()
    : Flow(MakeFlow(Plane))
    , Painter(Flow, Plane, Columns, Rows)
  {
    this->Painter.GetWindow()->SetSize(480, 240);
    this->Painter.GetInteractor()->Initialize();
    this->Painter.GetWindow()->Render();
    this->Recorder->SetInteractor(this->Painter.GetInteractor());
    this->Recorder->ReadFromInputStringOn();
    this->Painter.GetRight()->AddObserver(vtkCommand::EndEvent, this, &Session::Count);
  }

  PainterWindow& GetPainter() { return this->Painter; }

  /// Queues an event at a position on the canvas.
  void Send(const std::string& event, double column, double row)
  {
    vtkRenderer* left = this->Painter.GetLeft();
    left->SetWorldPoint(column, row, 0.0, 1.0);
    left->WorldToDisplay();
    const double* display = left->GetDisplayPoint();
    this->SendAt(event, static_cast<int>(display[0]), static_cast<int>(display[1]));
  }
  void SendAt(const std::string& event, int x, int y)
  {
    this->Events += event + " " + std::to_string(x) + " " + std::to_string(y) + " 0 0 0 0\n";
    // Store the canvas position of this pixel, which CheckFile() needs.
    vtkRenderer* left = this->Painter.GetLeft();
    left->SetDisplayPoint(x, y, 0.0);
    left->DisplayToWorld();
    this->CanvasPosition = { { left->GetWorldPoint()[0], left->GetWorldPoint()[1] } };
  }
  void Press(char key)
  {
    this->Events += "CharEvent 10 10 0 " + std::to_string(static_cast<int>(key)) + " 1 " +
      std::string(1, key) + "\n";
  }
  /// Returns the canvas position of the last event.
  const PaintCanvas::Position& GetCanvasPosition() const { return this->CanvasPosition; }

  /// Plays the queued events and returns the uploads that they caused.
  Uploads Play()
  {
    this->Sum = Uploads();
    const std::string all = "# StreamVersion 1.1\n" + this->Events;
    this->Events.clear();
    this->Recorder->SetInputString(all.c_str());
    this->Recorder->Play();
    return this->Sum;
  }

  /// Returns the pixels of the right view.
  std::vector<unsigned char> GrabRight()
  {
    const int* size = this->Painter.GetWindow()->GetSize();
    const int* origin = this->Painter.GetRight()->GetOrigin();
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Painter.GetWindow()->Render();
    this->Painter.GetWindow()->GetPixelData(origin[0], 0, size[0] - 1, size[1] - 1, 0, pixels);
    return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
  }

private:
  void Count()
  {
    vtkInterlumeReport* report = this->Painter.GetMapper()->GetReport();
    this->Sum.Grid += report->GetNumber("GridUploads");
    this->Sum.Inflow += report->GetNumber("InflowUploads");
    this->Sum.Others += report->GetNumber("DetailUploads") + report->GetNumber("GateUploads") +
      report->GetNumber("TransferUploads") + report->GetNumber("ArrayUploads");
    ++this->Sum.Images;
  }

  vtkNew<vtkTerminationPlane> Plane;
  vtkSmartPointer<vtkImageData> Flow;
  PainterWindow Painter;
  vtkNew<vtkInteractorEventRecorder> Recorder;
  std::string Events;
  PaintCanvas::Position CanvasPosition{ { 0.0, 0.0 } };
  Uploads Sum;
};

vtkSmartPointer<vtkImageData> Read(const std::string& file)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

int GetByte(vtkImageData* image, int column, int row, int component)
{
  return static_cast<int>(image->GetScalarComponentAsDouble(column, row, 0, component));
}

double GetDistance(
  const PaintCanvas::Position& a, const PaintCanvas::Position& b, double x, double y)
{
  const double direction[2] = { b[0] - a[0], b[1] - a[1] };
  const double length = direction[0] * direction[0] + direction[1] * direction[1];
  const double fraction = length > 0.0
    ? std::clamp(((x - a[0]) * direction[0] + (y - a[1]) * direction[1]) / length, 0.0, 1.0)
    : 0.0;
  return std::hypot(x - a[0] - fraction * direction[0], y - a[1] - fraction * direction[1]);
}

/// Checks every pixel of an image file by its distance to \a line, which was painted with \a brush.
void CheckFile(const std::string& file, const std::vector<PaintCanvas::Position>& line,
  const PaintCanvas::Brush& brush, Check& check)
{
  const vtkSmartPointer<vtkImageData> image = Read(file);
  check.Equal(image->GetDimensions()[0], Columns, "columns");
  check.Equal(image->GetDimensions()[1], Rows, "rows");
  check.Equal(image->GetNumberOfScalarComponents(), 4, "RGBA");
  int painted = 0;
  int errors = 0;
  for (int row = 0; row < Rows; ++row)
  {
    for (int column = 0; column < Columns; ++column)
    {
      double distance = 1e9;
      for (std::size_t i = 1; i < line.size(); ++i)
      {
        distance = std::min(distance, GetDistance(line[i - 1], line[i], column, row));
      }
      const bool isInside = distance < brush.Radius - 0.51;
      painted += isInside ? 1 : 0;
      for (int c = 0; c < 4; ++c)
      {
        const auto expected = std::lround(255.0 * brush.Color[static_cast<std::size_t>(c)]);
        const int found = GetByte(image, column, row, c);
        errors += isInside && found != expected ? 1 : 0;
        errors += distance > brush.Radius + 0.51 && found != 0 ? 1 : 0;
      }
    }
  }
  check.That(painted > 100 && painted < Columns * Rows / 2, "only part of the canvas is painted");
  check.Equal(errors, 0, "values that differ from the brush color");
}

/// Returns the number of color values that changed in the right half of the right view, which shows
/// only the flow.
vtkIdType CountChanges(
  const std::vector<unsigned char>& one, const std::vector<unsigned char>& other, std::size_t width)
{
  vtkIdType changes = 0;
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    const bool isFlow = i / 3 % width > width / 2;
    const int change = std::abs(static_cast<int>(one[i]) - static_cast<int>(other[i]));
    changes += isFlow && change > 20 ? 1 : 0;
  }
  return changes;
}

/// Tests the saved file, the rendered view and the GPU uploads of a stroke, and that it can be
/// undone.
void TestStroke(const std::string& folder, Check& check)
{
  Session session;
  PainterWindow& painter = session.GetPainter();
  const std::string file = folder + "/painted.png";
  painter.SetFile(file);
  std::remove(file.c_str());
  const std::vector<unsigned char> before = session.GrabRight();

  session.Press('[');
  session.Press('3');
  check.That(session.Play().Images >= 2, "keys redraw the brush");
  const PaintCanvas::Brush brush = painter.GetBrush();
  check.Near(brush.Radius, 0.8 * PaintCanvas::Brush().Radius, 1e-12, "radius of the smaller brush");
  check.That(
    brush.Color[1] > 0.8 && brush.Color[0] < 0.2 && brush.Color[2] < 0.2, "the brush is green");

  std::vector<PaintCanvas::Position> line;
  session.Send("LeftButtonPressEvent", 24.0, 20.0);
  line.push_back(session.GetCanvasPosition());
  for (const PaintCanvas::Position& to : { PaintCanvas::Position{ { 48.0, 44.0 } },
         PaintCanvas::Position{ { 70.0, 44.0 } }, PaintCanvas::Position{ { 74.0, 20.0 } } })
  {
    session.Send("MouseMoveEvent", to[0], to[1]);
    line.push_back(session.GetCanvasPosition());
  }
  session.Send("LeftButtonReleaseEvent", 74.0, 20.0);
  session.Send("MouseMoveEvent", 10.0, 55.0);
  session.Press('s');
  const Uploads sent = session.Play();
  CheckFile(file, line, brush, check);
  check.Equal(sent.Inflow, 4, "uploads of the texture, one per painting event");
  check.Equal(sent.Grid, 0, "uploads of voxels");
  check.Equal(sent.Others, 0, "uploads of other textures");
  check.That(sent.Images >= 5, "one frame per painting event, and one at full quality");
  const std::vector<unsigned char> painted = session.GrabRight();
  const vtkIdType changes =
    CountChanges(before, painted, static_cast<std::size_t>(painter.GetRight()->GetSize()[0]));
  check.That(changes > 1000, std::to_string(changes) + " values of the flow changed");

  session.Press('z');
  session.Play();
  check.That(session.GrabRight() == before, "the right view without the stroke");
  session.Press('l');
  session.Play();
  check.That(session.GrabRight() == painted, "the right view with the stroke from its file");
  session.Press('c');
  session.Play();
  check.That(session.GrabRight() == before, "the right view of an empty canvas");
  session.Press('z');
  session.Play();
  check.That(session.GrabRight() == painted, "clearing is undone");

  // The eraser makes paint transparent, so the white canvas is visible.
  session.Press('x');
  session.Send("LeftButtonPressEvent", 48.0, 44.0);
  session.Send("LeftButtonReleaseEvent", 48.0, 44.0);
  session.Play();
  check.Equal(GetByte(painter.GetCanvas().GetPaint(), 48, 44, 3), 0, "opacity after erasing");
  check.Equal(GetByte(painter.GetCanvas().GetPage(), 48, 44, 0), 255, "the canvas is white");
  check.That(GetByte(painter.GetCanvas().GetPaint(), 24, 20, 3) > 0, "other paint is unchanged");
}

/// Tests that moving a slider does not paint, and that rotating the view does not upload anything.
void TestControls(Check& check)
{
  Session session;
  PainterWindow& painter = session.GetPainter();
  const int* size = painter.GetLeft()->GetSize();
  const int level = size[1] / 10;
  session.SendAt("LeftButtonPressEvent", size[0] * 107 / 1000, level);
  session.SendAt("MouseMoveEvent", size[0] * 24 / 100, level);
  session.SendAt("LeftButtonReleaseEvent", size[0] * 24 / 100, level);
  session.Play();
  const double radius = painter.GetBrush().Radius;
  check.That(radius > 35.0 && radius < 55.0, "radius of the brush is " + std::to_string(radius));
  check.That(!painter.GetCanvas().Undo(), "a slider does not paint");
  session.SendAt("LeftButtonPressEvent", size[0] * 82 / 100, level);
  session.SendAt("LeftButtonReleaseEvent", size[0] * 82 / 100, level);
  session.Play();
  const auto& color = painter.GetBrush().Color;
  check.That(color[2] > 0.7 && color[0] < 0.3, "the slider changes the hue");

  const std::vector<unsigned char> before = session.GrabRight();
  const int x = painter.GetRight()->GetOrigin()[0] + 100;
  session.SendAt("LeftButtonPressEvent", x, 120);
  session.SendAt("MouseMoveEvent", x + 30, 130);
  session.SendAt("LeftButtonReleaseEvent", x + 30, 130);
  const Uploads sent = session.Play();
  check.Equal(sent.Inflow + sent.Grid + sent.Others, 0, "uploads caused by rotating the view");
  check.That(session.GrabRight() != before, "the view is rotated");
  check.That(!painter.GetCanvas().Undo(), "rotating does not paint");
}

/// Tests loading an image of a different size and type, and loading a missing file.
void TestFiles(const std::string& folder, Check& check)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2 * Columns, 2 * Rows, 1);
  image->AllocateScalars(VTK_UNSIGNED_SHORT, 3);
  for (int row = 0; row < 2 * Rows; ++row)
  {
    for (int column = 0; column < 2 * Columns; ++column)
    {
      auto* pixel = static_cast<unsigned short*>(image->GetScalarPointer(column, row, 0));
      pixel[0] = column < Columns ? 65535 : 0;
      pixel[1] = 257 * 90;
      pixel[2] = row < Rows ? 65535 : 0;
    }
  }
  const std::string file = folder + "/painter-input.png";
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.c_str());
  writer->Write();
  PaintCanvas canvas(Columns, Rows);
  check.That(canvas.Load(file).empty(), "a 16-bit image is loaded");
  for (const int column : { 10, 80 })
  {
    for (const int row : { 10, 50 })
    {
      const int expected[4] = { column < Columns / 2 ? 255 : 0, 90, row < Rows / 2 ? 255 : 0, 255 };
      for (int c = 0; c < 4; ++c)
      {
        check.Equal(
          GetByte(canvas.GetPaint(), column, row, c), expected[c], "channels of an image");
      }
    }
  }
  check.That(!canvas.Load(folder + "/no such file.png").empty(), "a missing file is an error");
  check.Equal(GetByte(canvas.GetPaint(), 10, 10, 1), 90, "the paint is unchanged");
  check.That(!canvas.Undo(), "there is nothing to undo");
}

}

int main(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::cerr << "usage: TestInflowPainter RESULT_DIRECTORY\n";
    return EXIT_FAILURE;
  }
  Check check;
  TestStroke(argv[1], check);
  TestControls(check);
  TestFiles(argv[1], check);
  return check.Result();
}
