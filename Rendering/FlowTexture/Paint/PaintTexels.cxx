// SPDX-License-Identifier: BSD-3-Clause
#include "Paint/PaintTexels.h"

#include "Common/ArrayCheck.h"

#include "vtkImageData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
// Returns the value that represents 1 in a scalar type, or 0 if the type is not supported.
double GetWhite(int type)
{
  switch (type)
  {
    case VTK_UNSIGNED_CHAR:
      return 255.0;
    case VTK_UNSIGNED_SHORT:
      return 65535.0;
    case VTK_FLOAT:
    case VTK_DOUBLE:
      return 1.0;
    default:
      return 0.0;
  }
}
}

Error PaintTexels::Build(vtkImageData* image, int dimensions)
{
  vtkDataArray* colors = image->GetPointData()->GetScalars();
  if (!colors || image->GetNumberOfPoints() < 1)
  {
    return "has no active point scalars. Set the active scalars of its point data.";
  }
  if (Error error = ArrayCheck::FindPointError(image, colors, 0))
  {
    return error.Within("cannot be read: ", ".");
  }
  int size[3];
  image->GetDimensions(size);
  this->Size = { { 1, 1, 1 } };
  int axes = 0;
  for (const int length : size)
  {
    if (length > 1)
    {
      this->Size[axes++] = length;
    }
  }
  if (axes > dimensions)
  {
    return "has " + std::to_string(axes) + " dimensions (" + std::to_string(size[0]) + " x " +
      std::to_string(size[1]) + " x " + std::to_string(size[2]) + " points), but at most " +
      std::to_string(dimensions) + " are supported.";
  }
  const double white = GetWhite(colors->GetDataType());
  const int components = colors->GetNumberOfComponents();
  if (white == 0.0 || components > 4)
  {
    return "has " + ArrayCheck::Count(components, "component") + " of type " +
      colors->GetDataTypeAsString() +
      ". Use one to four components of unsigned char, unsigned short, float or double.";
  }
  this->Texels.resize(4 * static_cast<std::size_t>(colors->GetNumberOfTuples()));
  vtkSMPTools::For(0, colors->GetNumberOfTuples(),
    [&](vtkIdType first, vtkIdType last)
    {
      const bool isGray = components < 3;
      double color[4];
      for (vtkIdType i = first; i < last; ++i)
      {
        colors->GetTuple(i, color);
        for (int c = 0; c < components; ++c)
        {
          const double normalized = color[c] / white;
          color[c] = std::isfinite(normalized) ? std::min(std::max(normalized, 0.0), 1.0) : 0.0;
        }
        const double alpha = components % 2 == 0 ? color[components - 1] : 1.0;
        unsigned short* texel = &this->Texels[4 * static_cast<std::size_t>(i)];
        for (int c = 0; c < 3; ++c)
        {
          texel[c] =
            static_cast<unsigned short>(std::lround(65535.0 * alpha * color[isGray ? 0 : c]));
        }
        texel[3] = static_cast<unsigned short>(std::lround(65535.0 * alpha));
      }
    });
  return {};
}

}
