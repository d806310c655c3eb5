// SPDX-License-Identifier: BSD-3-Clause
// The example that paints on an inflow, driven by events as vtkInteractorEventRecorder has them:
// the pixels of the file against the brush's formula, the view of the flow, what was sent for it.
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

/// A straight flow along x through a box, and the plane where it comes in.
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

/// What was sent to the graphics card for several pictures.
struct Uploads
{
  int Grid = 0;
  int Inflow = 0;
  int Others = 0;
  int Pictures = 0;
};

/// A window with a recorder that plays what it is told.
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

  /// Moves the mouse to a place of the page, and sends the event.
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
    // Where the page has this pixel, for the formula.
    vtkRenderer* left = this->Painter.GetLeft();
    left->SetDisplayPoint(x, y, 0.0);
    left->DisplayToWorld();
    this->Place = { { left->GetWorldPoint()[0], left->GetWorldPoint()[1] } };
  }
  void Press(char key)
  {
    this->Events += "CharEvent 10 10 0 " + std::to_string(static_cast<int>(key)) + " 1 " +
      std::string(1, key) + "\n";
  }
  /// Returns where on the page the last event was.
  const PaintCanvas::Place& GetPlace() const { return this->Place; }

  /// Plays what was sent; returns what that uploaded.
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
    ++this->Sum.Pictures;
  }

  vtkNew<vtkTerminationPlane> Plane;
  vtkSmartPointer<vtkImageData> Flow;
  PainterWindow Painter;
  vtkNew<vtkInteractorEventRecorder> Recorder;
  std::string Events;
  PaintCanvas::Place Place{ { 0.0, 0.0 } };
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

double GetDistance(const PaintCanvas::Place& a, const PaintCanvas::Place& b, double x, double y)
{
  const double way[2] = { b[0] - a[0], b[1] - a[1] };
  const double length = way[0] * way[0] + way[1] * way[1];
  const double part =
    length > 0.0 ? std::clamp(((x - a[0]) * way[0] + (y - a[1]) * way[1]) / length, 0.0, 1.0) : 0.0;
  return std::hypot(x - a[0] - part * way[0], y - a[1] - part * way[1]);
}

/// Every pixel of a file against the lines that were painted, all with one brush.
void CheckFile(const std::string& file, const std::vector<PaintCanvas::Place>& line,
  const PaintCanvas::Brush& brush, Check& check)
{
  const vtkSmartPointer<vtkImageData> image = Read(file);
  check.Equal(image->GetDimensions()[0], Columns, "columns");
  check.Equal(image->GetDimensions()[1], Rows, "rows");
  check.Equal(image->GetNumberOfScalarComponents(), 4, "RGBA");
  int painted = 0;
  int wrong = 0;
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
        const auto expected = std::lround(255.0 * brush.Colour[static_cast<std::size_t>(c)]);
        const int found = GetByte(image, column, row, c);
        wrong += isInside && found != expected ? 1 : 0;
        wrong += distance > brush.Radius + 0.51 && found != 0 ? 1 : 0;
      }
    }
  }
  check.That(painted > 100 && painted < Columns * Rows / 2, "paint on a part of the page");
  check.Equal(wrong, 0, "values that differ from the brush's");
}

/// The values that differ in the right half of the right view, where the flow is and not the page.
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

/// A stroke: the file, the view, what was sent; then back.
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
  check.That(session.Play().Pictures >= 2, "keys draw the brush");
  const PaintCanvas::Brush brush = painter.GetBrush();
  check.Near(brush.Radius, 0.8 * PaintCanvas::Brush().Radius, 1e-12, "a smaller brush");
  check.That(brush.Colour[1] > 0.8 && brush.Colour[0] < 0.2 && brush.Colour[2] < 0.2, "green");

  std::vector<PaintCanvas::Place> line;
  session.Send("LeftButtonPressEvent", 24.0, 20.0);
  line.push_back(session.GetPlace());
  for (const PaintCanvas::Place& to : { PaintCanvas::Place{ { 48.0, 44.0 } },
         PaintCanvas::Place{ { 70.0, 44.0 } }, PaintCanvas::Place{ { 74.0, 20.0 } } })
  {
    session.Send("MouseMoveEvent", to[0], to[1]);
    line.push_back(session.GetPlace());
  }
  session.Send("LeftButtonReleaseEvent", 74.0, 20.0);
  session.Send("MouseMoveEvent", 10.0, 55.0);
  session.Press('s');
  const Uploads sent = session.Play();
  CheckFile(file, line, brush, check);
  check.Equal(sent.Inflow, 4, "the texture is sent for each event that paints");
  check.Equal(sent.Grid, 0, "no voxel is sent");
  check.Equal(sent.Others, 0, "no other texture is sent");
  check.That(sent.Pictures >= 5, "a picture for each event that paints, and one without haste");
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
  check.That(session.GrabRight() == before, "the right view of an empty page");
  session.Press('z');
  session.Play();
  check.That(session.GrabRight() == painted, "clearing undone");

  // The eraser takes opacity alone away.
  session.Press('x');
  session.Send("LeftButtonPressEvent", 48.0, 44.0);
  session.Send("LeftButtonReleaseEvent", 48.0, 44.0);
  session.Play();
  check.Equal(GetByte(painter.GetCanvas().GetPaint(), 48, 44, 3), 0, "erased");
  check.Equal(GetByte(painter.GetCanvas().GetPage(), 48, 44, 0), 255, "white paper");
  check.That(GetByte(painter.GetCanvas().GetPaint(), 24, 20, 3) > 0, "the rest is left");
}

/// A slider, which paints nothing, and a turn of the view, which sends nothing.
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
  check.That(radius > 35.0 && radius < 55.0, "a brush of " + std::to_string(radius));
  check.That(!painter.GetCanvas().Undo(), "a slider paints nothing");
  session.SendAt("LeftButtonPressEvent", size[0] * 82 / 100, level);
  session.SendAt("LeftButtonReleaseEvent", size[0] * 82 / 100, level);
  session.Play();
  const auto& colour = painter.GetBrush().Colour;
  check.That(colour[2] > 0.7 && colour[0] < 0.3, "hue by its slider");

  const std::vector<unsigned char> before = session.GrabRight();
  const int x = painter.GetRight()->GetOrigin()[0] + 100;
  session.SendAt("LeftButtonPressEvent", x, 120);
  session.SendAt("MouseMoveEvent", x + 30, 130);
  session.SendAt("LeftButtonReleaseEvent", x + 30, 130);
  const Uploads sent = session.Play();
  check.Equal(sent.Inflow + sent.Grid + sent.Others, 0, "a turn of the view sends nothing");
  check.That(session.GrabRight() != before, "the view has turned");
  check.That(!painter.GetCanvas().Undo(), "a turn paints nothing");
}

/// An image of another size and type, and what is none.
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
  check.That(canvas.Load(file).empty(), "an image of 16 bits");
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
  check.That(!canvas.Load(folder + "/no such file.png").empty(), "no file");
  check.Equal(GetByte(canvas.GetPaint(), 10, 10, 1), 90, "paint stays");
  check.That(!canvas.Undo(), "nothing was kept");
}

}

int main(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::cerr << "the first argument is a folder for results\n";
    return EXIT_FAILURE;
  }
  Check check;
  TestStroke(argv[1], check);
  TestControls(check);
  TestFiles(argv[1], check);
  return check.Result();
}
