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

/// Maximum distance of a sample from the grid of the first image, in units of the spacing.
constexpr double TOLERANCE = 1e-3;
/// Upper limit for the absolute values of sample indices, which must fit in an int.
constexpr double MAXIMUM_INDEX = 1e9;

/// Extent of an image: the indices of its first and last sample along each axis.
class Box
{
public:
  std::array<int, 6> Extent;

  int First(std::size_t axis) const { return this->Extent[2 * axis]; }
  /// Returns the number of samples or cells along an axis. As in VTK, an axis with a single sample
  /// has one layer of cells.
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
  /// Extends this box so that it contains \a other.
  void Add(const Box& other)
  {
    for (std::size_t i = 0; i < 6; i += 2)
    {
      this->Extent[i] = std::min(this->Extent[i], other.Extent[i]);
      this->Extent[i + 1] = std::max(this->Extent[i + 1], other.Extent[i + 1]);
    }
  }

  /// For each row of \a box along x, calls \a visit with two indices of its first element: that in
  /// this box and that in \a box.
  template <typename Visit>
  void VisitRows(const Box& box, bool ofPoints, const Visit& visit) const
  {
    vtkIdType row = 0;
    for (int k = 0; k < box.Count(2, ofPoints); ++k)
    {
      for (int j = 0; j < box.Count(1, ofPoints); ++j)
      {
        const vtkIdType z = box.First(2) - this->First(2) + k;
        const vtkIdType y = box.First(1) - this->First(1) + j;
        const vtkIdType x = box.First(0) - this->First(0);
        visit(x + this->Count(0, ofPoints) * (y + this->Count(1, ofPoints) * z), row);
        row += box.Count(0, ofPoints);
      }
    }
  }
};

/// Computes the extent of \a image on the grid of \a first. Returns false if its samples are not on
/// that grid.
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
    const double position = std::round(index[axis]);
    if (!(std::abs(position - index[axis]) <= TOLERANCE) || !(std::abs(position) < MAXIMUM_INDEX) ||
      !(std::abs(ratio - 1.0) * std::max(cells, 1) <= TOLERANCE))
    {
      return false;
    }
    box.Extent[2 * axis] = static_cast<int>(position);
    box.Extent[2 * axis + 1] = static_cast<int>(position) + cells;
  }
  return true;
}

/// Returns true if each cell of \a joinedBox is in exactly one of \a boxes.
bool FillExactlyOnce(const Box& joinedBox, const std::vector<Box>& boxes)
{
  vtkIdType cells = 0;
  for (const Box& box : boxes)
  {
    cells += box.Count(false);
  }
  if (cells != joinedBox.Count(false))
  {
    return false;
  }
  std::vector<bool> isFilled(static_cast<std::size_t>(cells), false);
  for (const Box& box : boxes)
  {
    joinedBox.VisitRows(box, false,
      [&](vtkIdType begin, vtkIdType)
      { std::fill_n(isFilled.begin() + begin, box.Count(0, false), true); });
  }
  return std::find(isFilled.begin(), isFilled.end(), false) == isFilled.end();
}

vtkDataSetAttributes* GetAttributes(vtkImageData* image, bool ofPoints)
{
  return ofPoints ? static_cast<vtkDataSetAttributes*>(image->GetPointData())
                  : image->GetCellData();
}

/// Returns the array \a name of each image. Returns an empty list if an image lacks this array, or
/// if the types or numbers of components differ.
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

/// Joins each array that all images have, and adds it to \a joined.
void JoinArrays(const Images& images, const std::vector<Box>& boxes, const Box& joinedBox,
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
    values->SetNumberOfTuples(joinedBox.Count(ofPoints));
    for (std::size_t i = 0; i < images.size(); ++i)
    {
      joinedBox.VisitRows(boxes[i], ofPoints,
        [&](vtkIdType begin, vtkIdType row)
        { values->InsertTuples(begin, boxes[i].Count(0, ofPoints), row, arrays[i]); });
    }
    GetAttributes(joined, ofPoints)->AddArray(values);
  }
}

/// Returns the joined image, or null if the images do not fill a box.
vtkSmartPointer<vtkImageData> Join(const Images& images)
{
  std::vector<Box> boxes(images.size());
  for (std::size_t i = 0; i < images.size(); ++i)
  {
    if (!FindBox(images[i], images[0], boxes[i]))
    {
      return nullptr;
    }
  }
  Box joinedBox = boxes[0];
  for (const Box& box : boxes)
  {
    joinedBox.Add(box);
  }
  if (!FillExactlyOnce(joinedBox, boxes))
  {
    return nullptr;
  }
  const auto joined = vtkSmartPointer<vtkImageData>::New();
  joined->SetOrigin(images[0]->GetOrigin());
  joined->SetSpacing(images[0]->GetSpacing());
  joined->SetDirectionMatrix(images[0]->GetDirectionMatrix());
  joined->SetExtent(joinedBox.Extent.data());
  JoinArrays(images, boxes, joinedBox, joined, true);
  JoinArrays(images, boxes, joinedBox, joined, false);
  return joined;
}
}

vtkImageBlocks::vtkImageBlocks(const std::vector<vtkDataSet*>& datasets)
{
  Images images;
  for (vtkDataSet* dataset : datasets)
  {
    auto* image = vtkImageData::SafeDownCast(dataset);
    if (image && image->GetNumberOfPoints() > 0)
    {
      images.push_back(image);
    }
  }
  if (images.empty())
  {
    return;
  }
  this->Skipped = datasets.size() - images.size();
  this->Image = images.size() > 1 ? Join(images) : vtkSmartPointer<vtkImageData>(images[0]);
  if (!this->Image)
  {
    this->Image = *std::max_element(images.begin(), images.end(),
      [](vtkImageData* a, vtkImageData* b)
      { return a->GetNumberOfPoints() < b->GetNumberOfPoints(); });
    this->Skipped += images.size() - 1;
  }
}

vtkImageBlocks::~vtkImageBlocks() = default;
