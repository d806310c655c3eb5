// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays/ArrayInterpolator.h"

#include "Output/Interpolation.h"
#include "Scalars/ExtractionDispatch.h"

#include "vtkDataArray.h"

namespace interlume
{

namespace
{
// Values that lie one after the other in memory.
template <typename T>
struct Contiguous
{
  const T* Values;

  double Get(vtkIdType point, int component, int components) const
  {
    return static_cast<double>(this->Values[point * components + component]);
  }
};

// Any array, value by value.
struct AnyValues
{
  vtkDataArray* Values;

  double Get(vtkIdType point, int component, int) const
  {
    return this->Values->GetComponent(point, component);
  }
};

template <typename Source, typename Out>
class Typed : public ArrayInterpolator
{
public:
  Typed(const Source& in, int components)
    : In(in)
    , Components(components)
  {
  }

  void Interpolate(const ExtractionPoint* points, std::size_t number, void* out) const override
  {
    Out* const values = static_cast<Out*>(out);
    // A known number of components needs no loop.
    switch (this->Components)
    {
      case 1:
        return this->template Run<1>(points, number, values);
      case 3:
        return this->template Run<3>(points, number, values);
      default:
        return this->template Run<0>(points, number, values);
    }
  }

private:
  template <int Known>
  void Run(const ExtractionPoint* points, std::size_t number, Out* value) const
  {
    const int size = Known ? Known : this->Components;
    for (std::size_t p = 0; p < number; ++p)
    {
      const ExtractionPoint& point = points[p];
      for (int c = 0; c < size; ++c)
      {
        *value++ = Interpolation::Between<Out>(
          this->In.Get(point.Near, c, size), this->In.Get(point.Far, c, size), point.Weight);
      }
    }
  }

  Source In;
  int Components;
};
}

std::unique_ptr<ArrayInterpolator> ArrayInterpolator::Make(vtkDataArray* in, int outType)
{
  std::unique_ptr<ArrayInterpolator> made;
  const auto make = [&](const auto& source)
  {
    using Source = std::decay_t<decltype(source)>;
    const int components = in->GetNumberOfComponents();
    if (outType == VTK_FLOAT)
    {
      made = std::make_unique<Typed<Source, float>>(source, components);
    }
    else
    {
      made = std::make_unique<Typed<Source, double>>(source, components);
    }
    return true;
  };
  const bool isContiguous = ExtractionDispatch::Execute(in,
    [&](const auto* values)
    { return make(Contiguous<std::decay_t<decltype(*values)>>{ values }); });
  if (!isContiguous)
  {
    make(AnyValues{ in });
  }
  return made;
}

}
