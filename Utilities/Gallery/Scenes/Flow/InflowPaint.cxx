// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Scenes/Flow/InflowPaint.h"

#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkNew.h"
#include "vtkTextProperty.h"
#include "vtkStringArray.h" // required by vtkTextRenderer.h
#include "vtkTextRenderer.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace gallery
{
vtkSmartPointer<vtkImageData> MakePaint(
  int columns, int rows, const std::function<Paint(double u, double v)>& paint)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(columns, rows, 1);
  image->AllocateScalars(VTK_FLOAT, 4);
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const Paint here = paint(i / (columns - 1.0), j / (rows - 1.0));
      for (int c = 0; c < 3; ++c)
      {
        image->SetScalarComponentFromDouble(i, j, 0, c, here.Color[c]);
      }
      image->SetScalarComponentFromDouble(i, j, 0, 3, here.Opacity);
    }
  }
  return image;
}

void DrawTextLine(vtkImageData* image, const std::string& text, const vtkColor3d& color,
  double opacity, double height, double center)
{
  int size[3];
  image->GetDimensions(size);
  vtkNew<vtkTextProperty> style;
  style->SetFontSize(static_cast<int>(height * size[1]));
  style->BoldOn();
  style->SetColor(1.0, 1.0, 1.0);
  vtkNew<vtkImageData> letters;
  int written[2] = { 0, 0 };
  vtkTextRenderer::GetInstance()->RenderString(style, text.c_str(), letters, written, 72);
  int extent[6];
  letters->GetExtent(extent);
  const int left = (size[0] - written[0]) / 2;
  const int bottom = static_cast<int>(center * size[1]) - written[1] / 2;
  for (int j = 0; j < written[1]; ++j)
  {
    for (int i = 0; i < written[0]; ++i)
    {
      const int x = left + i;
      const int y = bottom + j;
      if (x < 0 || y < 0 || x >= size[0] || y >= size[1])
      {
        continue;
      }
      const double fraction =
        letters->GetScalarComponentAsDouble(extent[0] + i, extent[2] + j, 0, 3) / 255.0;
      for (int c = 0; c < 4; ++c)
      {
        const double before = image->GetScalarComponentAsDouble(x, y, 0, c);
        const double value = c < 3 ? color[c] : opacity;
        image->SetScalarComponentFromDouble(
          x, y, 0, c, before + (c < 3 && fraction > 0.0 ? 1.0 : fraction) * (value - before));
      }
    }
  }
}

vtkSmartPointer<vtkVolume> MakeInflowVolume(
  vtkDataSet* flow, vtkImageData* image, double unitDistance)
{
  vtkNew<vtkImplicitFlowVolumeMapper> mapper;
  mapper->SetInputData(flow);
  mapper->SetInflowTexture(vtkImplicitFlowVolumeMapper::ALL, image);
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->GetProperty()->SetScalarOpacityUnitDistance(unitDistance);
  return volume;
}

vtkImplicitFlowVolumeMapper* GetInflowMapper(vtkVolume* volume)
{
  return vtkImplicitFlowVolumeMapper::SafeDownCast(volume->GetMapper());
}

vtkSmartPointer<vtkTexture> MakeInflowTexture(vtkImageData* image, const vtkColor3d& ground)
{
  vtkNew<vtkImageData> shown;
  shown->CopyStructure(image);
  shown->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  int size[3];
  image->GetDimensions(size);
  for (int j = 0; j < size[1]; ++j)
  {
    for (int i = 0; i < size[0]; ++i)
    {
      // Increase the opacity: dye that is faint in the volume must be visible on the surface.
      const double alpha = std::min(1.0, 4.0 * image->GetScalarComponentAsDouble(i, j, 0, 3));
      for (int c = 0; c < 3; ++c)
      {
        const double color = image->GetScalarComponentAsDouble(i, j, 0, c);
        shown->SetScalarComponentFromDouble(
          i, j, 0, c, 255.0 * (ground[c] + alpha * (color - ground[c])));
      }
    }
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(shown);
  texture->InterpolateOn();
  return texture;
}
}
