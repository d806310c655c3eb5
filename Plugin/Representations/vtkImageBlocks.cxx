// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImageBlocks.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using Images = std::vector<vtkImageData*>;

/// The distance, in spacings, by which samples may be off the lattice of the first image.
constexpr double TOLERANCE = 1e-3;
constexpr double FARTHEST = 1e9;

/// The first and last sample of a box along each axis, and how its samples or cells are counted.
class Box
{
public:
  std::array<int, 6> Extent;

  int First(std::size_t axis) const { return this->Extent[2 * axis]; }
  /// Returns a number of samples or cells; as in VTK, a flat image has a layer of cells.
  int Count(std::size_t axis, bool ofPoints) const
  {
    const int cells = this->Extent[2 * axis + 1] - this->Extent[2 * axis];
    return ofPoints ? cells + 1 : std::max(cells, 1);
  }
  vtkIdType Count(bool ofPoints) const
  {
    return static_cast<vtkIdType>(this->Count(0, ofPoints)) * this->Count(1, ofPoints) *
      this->Count(2, ofPoints);
  }
  void Add(const Box& other)
  {
    for (std::size_t i = 0; i < 6; i += 2)
    {
      this->Extent[i] = std::min(this->Extent[i], other.Extent[i]);
      this->Extent[i + 1] = std::max(this->Extent[i + 1], other.Extent[i + 1]);
    }
  }

  /// Calls \a visit with each row along x of \a part, with where it begins here and where in the
  /// part.
  template <typename Visit>
  void VisitRows(const Box& part, bool ofPoints, const Visit& visit) const
  {
    vtkIdType row = 0;
    for (int k = 0; k < part.Count(2, ofPoints); ++k)
    {
      for (int j = 0; j < part.Count(1, ofPoints); ++j)
      {
        const vtkIdType z = part.First(2) - this->First(2) + k;
        const vtkIdType y = part.First(1) - this->First(1) + j;
        const vtkIdType x = part.First(0) - this->First(0);
        visit(x + this->Count(0, ofPoints) * (y + this->Count(1, ofPoints) * z), row);
        row += part.Count(0, ofPoints);
      }
    }
  }
};

/// Finds where the image lies on the lattice of \a first. Returns false if it is on another one.
bool FindBox(vtkImageData* image, vtkImageData* first, Box& box)
{
  const double* directions = image->GetDirectionMatrix()->GetData();
  if (!std::equal(directions, directions + 9, first->GetDirectionMatrix()->GetData()))
  {
    return false;
  }
  const int* extent = image->GetExtent();
  double corner[3];
  image->TransformIndexToPhysicalPoint(extent[0], extent[2], extent[4], corner);
  double index[3];
  first->TransformPhysicalPointToContinuousIndex(corner, index);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int cells = extent[2 * axis + 1] - extent[2 * axis];
    const double ratio = image->GetSpacing()[axis] / first->GetSpacing()[axis];
    const double place = std::round(index[axis]);
    if (!(std::abs(place - index[axis]) <= TOLERANCE) || !(std::abs(place) < FARTHEST) ||
      !(std::abs(ratio - 1.0) * std::max(cells, 1) <= TOLERANCE))
    {
      return false;
    }
    box.Extent[2 * axis] = static_cast<int>(place);
    box.Extent[2 * axis + 1] = static_cast<int>(place) + cells;
  }
  return true;
}

/// Returns whether each cell of the whole is in one of the parts, and in one alone.
bool FillOnce(const Box& whole, const std::vector<Box>& parts)
{
  vtkIdType cells = 0;
  for (const Box& part : parts)
  {
    cells += part.Count(false);
  }
  if (cells != whole.Count(false))
  {
    return false;
  }
  std::vector<bool> isFilled(static_cast<std::size_t>(cells), false);
  for (const Box& part : parts)
  {
    whole.VisitRows(part, false,
      [&](vtkIdType begin, vtkIdType)
      { std::fill_n(isFilled.begin() + begin, part.Count(0, false), true); });
  }
  return std::find(isFilled.begin(), isFilled.end(), false) == isFilled.end();
}

vtkDataSetAttributes* GetAttributes(vtkImageData* image, bool ofPoints)
{
  return ofPoints ? static_cast<vtkDataSetAttributes*>(image->GetPointData())
                  : image->GetCellData();
}

/// Returns the arrays of \a name, one for each image; empty where one image has none, or one of
/// another kind.
std::vector<vtkDataArray*> FindArrays(const Images& images, const char* name, bool ofPoints)
{
  std::vector<vtkDataArray*> arrays;
  for (vtkImageData* image : images)
  {
    vtkDataArray* array = name ? GetAttributes(image, ofPoints)->GetArray(name) : nullptr;
    if (!array ||
      (!arrays.empty() &&
        (array->GetDataType() != arrays[0]->GetDataType() ||
          array->GetNumberOfComponents() != arrays[0]->GetNumberOfComponents())))
    {
      return {};
    }
    arrays.push_back(array);
  }
  return arrays;
}

void JoinArrays(const Images& images, const std::vector<Box>& parts, const Box& whole,
  vtkImageData* joined, bool ofPoints)
{
  vtkDataSetAttributes* first = GetAttributes(images[0], ofPoints);
  for (int a = 0; a < first->GetNumberOfArrays(); ++a)
  {
    const std::vector<vtkDataArray*> arrays = FindArrays(images, first->GetArrayName(a), ofPoints);
    if (arrays.empty())
    {
      continue;
    }
    const auto values = vtkSmartPointer<vtkDataArray>::Take(arrays[0]->NewInstance());
    values->SetName(arrays[0]->GetName());
    values->SetNumberOfComponents(arrays[0]->GetNumberOfComponents());
    values->SetNumberOfTuples(whole.Count(ofPoints));
    for (std::size_t i = 0; i < images.size(); ++i)
    {
      whole.VisitRows(parts[i], ofPoints,
        [&](vtkIdType begin, vtkIdType row)
        { values->InsertTuples(begin, parts[i].Count(0, ofPoints), row, arrays[i]); });
    }
    GetAttributes(joined, ofPoints)->AddArray(values);
  }
}

/// Returns the images as one; null if they do not fill a box.
vtkSmartPointer<vtkImageData> Join(const Images& images)
{
  std::vector<Box> parts(images.size());
  for (std::size_t i = 0; i < images.size(); ++i)
  {
    if (!FindBox(images[i], images[0], parts[i]))
    {
      return nullptr;
    }
  }
  Box whole = parts[0];
  for (const Box& part : parts)
  {
    whole.Add(part);
  }
  if (!FillOnce(whole, parts))
  {
    return nullptr;
  }
  const auto joined = vtkSmartPointer<vtkImageData>::New();
  joined->SetOrigin(images[0]->GetOrigin());
  joined->SetSpacing(images[0]->GetSpacing());
  joined->SetDirectionMatrix(images[0]->GetDirectionMatrix());
  joined->SetExtent(whole.Extent.data());
  JoinArrays(images, parts, whole, joined, true);
  JoinArrays(images, parts, whole, joined, false);
  return joined;
}
}

vtkImageBlocks::vtkImageBlocks(const std::vector<vtkDataSet*>& parts)
{
  Images images;
  for (vtkDataSet* part : parts)
  {
    auto* image = vtkImageData::SafeDownCast(part);
    if (image && image->GetNumberOfPoints() > 0)
    {
      images.push_back(image);
    }
  }
  if (images.empty())
  {
    return;
  }
  this->LeftOut = parts.size() - images.size();
  this->Image = images.size() > 1 ? Join(images) : vtkSmartPointer<vtkImageData>(images[0]);
  if (!this->Image)
  {
    this->Image = *std::max_element(images.begin(), images.end(),
      [](vtkImageData* a, vtkImageData* b)
      { return a->GetNumberOfPoints() < b->GetNumberOfPoints(); });
    this->LeftOut += images.size() - 1;
  }
}

vtkImageBlocks::~vtkImageBlocks() = default;
