#ifndef vtkExtractionCell_h
#define vtkExtractionCell_h

#include "vtkExtractionValues.h"
#include "vtkIsotable.h"

/**
 * @class   vtkExtractionCell
 * @brief   the slots of one cell that are the same point because a value equals an isovalue
 *
 * A crossing at an end of its edge is the grid point there; in an interval of zero width the upper
 * crossing is the lower one.
 */
class vtkExtractionCell
{
public:
  using Code = vtkExtractionValues::Code;
  using Slot = vtkIsotable::Slot;

  static Slot Identify(
    const vtkIsotable& table, const vtkExtractionValues::Item& item, const Code* codes, Slot slot)
  {
    const int n = table.GetNumberOfVertices();
    const int m = table.GetNumberOfEdges();
    if (slot < n)
    {
      return slot;
    }
    const int kind = (slot - n) / m;
    const auto& edge = table.GetEdge(slot - n - kind * m);
    const int tie = 2 * (kind == 0 ? item.Lower : item.Upper) + 1;
    for (Slot end : edge)
    {
      if (codes[end] == tie)
      {
        return end;
      }
    }
    return kind == 1 && item.IsFlat ? static_cast<Slot>(slot - m) : slot;
  }

  template <typename Id>
  static bool IsCollapsed(const Id* ids, int number)
  {
    for (int i = 0; i < number; ++i)
    {
      for (int j = i + 1; j < number; ++j)
      {
        if (ids[i] == ids[j])
        {
          return true;
        }
      }
    }
    return false;
  }
};

#endif
