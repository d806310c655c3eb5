// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/SampleOrder.h"

#include "vtkDataSet.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace interlume
{

namespace
{
constexpr int MaximumBits = 7;
constexpr double SamplesInBlock = 8.0;

int GetNumberOfBits(vtkIdType samples)
{
  int bits = 0;
  while (bits<MaximumBits&& static_cast<double>(samples)> SamplesInBlock * (1 << (3 * bits)))
  {
    ++bits;
  }
  return bits;
}

std::vector<vtkIdType> MakeIds(vtkIdType first, vtkIdType end)
{
  std::vector<vtkIdType> ids(static_cast<std::size_t>(std::max<vtkIdType>(0, end - first)));
  std::iota(ids.begin(), ids.end(), first);
  return ids;
}

/// Computes the Morton code of the block that contains a position.
class Blocks
{
public:
  Blocks(const double* lower, const double* upper, int bits)
    : Last((1U << bits) - 1U)
  {
    for (int i = 0; i < 3; ++i)
    {
      const double width = upper[i] - lower[i];
      this->Lower[i] = lower[i];
      this->Scale[i] = width > 0.0 ? (this->Last + 1.0) / width : 0.0;
    }
  }

  unsigned int GetCode(const double x[3]) const
  {
    unsigned int index[3];
    for (int i = 0; i < 3; ++i)
    {
      const double block = this->Scale[i] * (x[i] - this->Lower[i]);
      // The comparison is false for NaN, which therefore gets index 0.
      index[i] = block >= 1.0 ? static_cast<unsigned int>(std::min<double>(block, this->Last)) : 0U;
    }
    return SampleOrder::GetCode(index);
  }

private:
  unsigned int Last;
  double Lower[3];
  double Scale[3];
};
}

unsigned int SampleOrder::GetCode(const unsigned int index[3])
{
  unsigned int code = 0;
  for (int i = 0; i < 3; ++i)
  {
    for (int bit = 0; bit < 10; ++bit)
    {
      code |= (index[i] >> bit & 1U) << (3 * bit + i);
    }
  }
  return code;
}

SampleOrder::SampleOrder(vtkDataSet* samples, vtkIdType first)
  : SampleOrder(samples, MakeIds(first, samples->GetNumberOfPoints()))
{
}

SampleOrder::SampleOrder(vtkDataSet* samples, const std::vector<vtkIdType>& ids)
{
  if (ids.empty())
  {
    return;
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double lower[3] = { infinity, infinity, infinity };
  double upper[3] = { -infinity, -infinity, -infinity };
  double x[3];
  for (const vtkIdType id : ids)
  {
    samples->GetPoint(id, x);
    for (int axis = 0; axis < 3; ++axis)
    {
      lower[axis] = std::min(lower[axis], x[axis]);
      upper[axis] = std::max(upper[axis], x[axis]);
    }
  }
  const int bits = GetNumberOfBits(static_cast<vtkIdType>(ids.size()));
  const Blocks blocks(lower, upper, bits);
  std::vector<unsigned int> codes(ids.size());
  std::vector<std::size_t> starts((std::size_t(1) << (3 * bits)) + 1, 0);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    samples->GetPoint(ids[i], x);
    codes[i] = blocks.GetCode(x);
    ++starts[codes[i] + 1];
  }
  for (std::size_t block = 1; block < starts.size(); ++block)
  {
    starts[block] += starts[block - 1];
  }
  this->Ids.resize(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    this->Ids[starts[codes[i]]++] = ids[i];
  }
}

}
