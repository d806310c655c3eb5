// SPDX-License-Identifier: BSD-3-Clause
#include "PaintCanvas.h"

#include <vtkImageData.h>
#include <vtkImageReader2.h>
#include <vtkImageReader2Factory.h>
#include <vtkImageResize.h>
#include <vtkLine.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace
{
vtkSmartPointer<vtkImageData> NewImage(const std::array<int, 2>& size, int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size[0], size[1], 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  return image;
}

unsigned char* GetPixel(vtkImageData* image, int column, int row)
{
  return static_cast<unsigned char*>(image->GetScalarPointer(column, row, 0));
}

unsigned char ToByte(double fraction)
{
  return static_cast<unsigned char>(std::lround(255.0 * std::clamp(fraction, 0.0, 1.0)));
}

/// Blends the brush into a pixel. \a part is the fraction of the pixel that the brush covers.
void Mix(unsigned char* pixel, const std::array<double, 4>& brush, double part)
{
  const double before = (1.0 - part) * pixel[3] / 255.0;
  const double added = part * brush[3];
  const double opacity = before + added;
  for (int c = 0; opacity > 0.0 && c < 3; ++c)
  {
    const auto i = static_cast<std::size_t>(c);
    pixel[c] = ToByte((before * pixel[c] / 255.0 + added * brush[i]) / opacity);
  }
  pixel[3] = ToByte(opacity);
}
}

PaintCanvas::PaintCanvas(int columns, int rows)
  : Size{ { columns, rows } }
  , Paint(NewImage(Size, 4))
  , Page(NewImage(Size, 3))
{
  this->Clear();
}

void PaintCanvas::SaveState()
{
  const unsigned char* pixels = GetPixel(this->Paint, 0, 0);
  this->Steps.emplace_back(pixels, pixels + 4 * this->Paint->GetNumberOfPoints());
  if (this->Steps.size() > MaximumSteps)
  {
    this->Steps.erase(this->Steps.begin());
  }
}

bool PaintCanvas::Undo()
{
  if (this->Steps.empty())
  {
    return false;
  }
  std::copy(this->Steps.back().begin(), this->Steps.back().end(), GetPixel(this->Paint, 0, 0));
  this->Steps.pop_back();
  this->UpdateEntirePage();
  return true;
}

void PaintCanvas::Stroke(const Position& from, const Position& to, const Brush& brush)
{
  std::array<int, 2> first;
  std::array<int, 2> last;
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double end = this->Size[axis] - 1.0;
    first[axis] = static_cast<int>(
      std::clamp(std::floor(std::min(from[axis], to[axis]) - brush.Radius - 1.0), 0.0, end));
    last[axis] = static_cast<int>(
      std::clamp(std::ceil(std::max(from[axis], to[axis]) + brush.Radius + 1.0), 0.0, end));
  }
  const double begin[3] = { from[0], from[1], 0.0 };
  const double end[3] = { to[0], to[1], 0.0 };
  const bool isPoint = from == to;
  for (int row = first[1]; row <= last[1]; ++row)
  {
    for (int column = first[0]; column <= last[0]; ++column)
    {
      const double position[3] = { static_cast<double>(column), static_cast<double>(row), 0.0 };
      double t = 0.0;
      const double distance = isPoint
        ? std::hypot(position[0] - begin[0], position[1] - begin[1])
        : std::sqrt(vtkLine::DistanceToLine(position, begin, end, t, nullptr));
      const double part = std::clamp(brush.Radius - distance + 0.5, 0.0, 1.0);
      if (part > 0.0)
      {
        Mix(GetPixel(this->Paint, column, row), brush.Color, part);
      }
    }
  }
  this->UpdatePage(first[0], last[0], first[1], last[1]);
}

void PaintCanvas::Clear()
{
  std::fill_n(GetPixel(this->Paint, 0, 0), 4 * this->Paint->GetNumberOfPoints(), 0);
  this->UpdateEntirePage();
}

std::string PaintCanvas::Load(const std::string& file)
{
  if (!std::ifstream(file))
  {
    return "Cannot read " + file + ".";
  }
  const auto reader =
    vtk::TakeSmartPointer(vtkImageReader2Factory::CreateImageReader2(file.c_str()));
  if (!reader)
  {
    return file + " is not an image file that VTK can read.";
  }
  reader->SetFileName(file.c_str());
  vtkNew<vtkImageResize> resize;
  resize->SetInputConnection(reader->GetOutputPort());
  resize->SetOutputDimensions(this->Size[0], this->Size[1], 1);
  resize->Update();
  vtkImageData* image = resize->GetOutput();
  const int components = image->GetNumberOfScalarComponents();
  const int type = image->GetScalarType();
  if (image->GetNumberOfPoints() != this->Paint->GetNumberOfPoints() || components > 4 ||
    (type != VTK_UNSIGNED_CHAR && type != VTK_UNSIGNED_SHORT))
  {
    return file + " must be an image of 8 or 16 bits with one to four channels.";
  }
  const double largest = type == VTK_UNSIGNED_CHAR ? 255.0 : 65535.0;
  for (int row = 0; row < this->Size[1]; ++row)
  {
    for (int column = 0; column < this->Size[0]; ++column)
    {
      unsigned char* pixel = GetPixel(this->Paint, column, row);
      const auto get = [&](int component)
      { return ToByte(image->GetScalarComponentAsDouble(column, row, 0, component) / largest); };
      for (int c = 0; c < 3; ++c)
      {
        pixel[c] = get(components < 3 ? 0 : c);
      }
      pixel[3] = components % 2 == 0 ? get(components - 1) : 255;
    }
  }
  this->UpdateEntirePage();
  return {};
}

std::string PaintCanvas::Save(const std::string& file) const
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(this->Paint);
  writer->SetFileName(file.c_str());
  writer->Write();
  return writer->GetErrorCode() ? "Cannot write " + file + "." : std::string();
}

void PaintCanvas::UpdatePage(int firstColumn, int lastColumn, int firstRow, int lastRow)
{
  for (int row = firstRow; row <= lastRow; ++row)
  {
    for (int column = firstColumn; column <= lastColumn; ++column)
    {
      const unsigned char* paint = GetPixel(this->Paint, column, row);
      const double opacity = paint[3] / 255.0;
      unsigned char* page = GetPixel(this->Page, column, row);
      for (int c = 0; c < 3; ++c)
      {
        page[c] = ToByte(1.0 + opacity * (paint[c] / 255.0 - 1.0));
      }
    }
  }
  this->Paint->Modified();
  this->Page->Modified();
}

void PaintCanvas::UpdateEntirePage()
{
  this->UpdatePage(0, this->Size[0] - 1, 0, this->Size[1] - 1);
}
