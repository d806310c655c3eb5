// SPDX-License-Identifier: BSD-3-Clause
#include "Volume/TransferColumns.h"

#include "Volume/TransferMath.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace interlume
{

namespace
{
using Value = TransferNodes::Value;
using TransferMath::GetDistance;
using TransferMath::Mix;

/// Maximum error of linear interpolation between two columns, as a fraction of the largest value.
/// If it is exceeded, the interval needs an edge or a breakpoint list.
constexpr double Straight = 1e-3;
/// Maximum error inside an edge, averaged over the interval, as a fraction of the largest value.
constexpr double Curved = 1e-2;
constexpr double Tolerance = 1e-4;
/// Maximum number of bisections of a linear piece.
constexpr int MaximumDepth = 12;

/// Position as a fraction of the interval between two columns, and the value there.
struct Breakpoint
{
  double Fraction;
  Value Y;
};

/// The function between two columns: a list of breakpoints with mapped values.
class Interval
{
public:
  Interval(const TransferColumns::Mapping& mapping, const std::vector<TransferNodes::Node>& nodes)
    : Mapping(mapping)
  {
    for (const TransferNodes::Node& node : nodes)
    {
      const Value own = Apply(this->Mapping.Invert, this->GetMapped(node.Y));
      this->Largest = std::max(this->Largest, GetDistance(own, Value{}));
    }
  }

  Value GetMapped(const Value& y) const { return Apply(this->Mapping.Map, y); }

  void Begin(const Value& y)
  {
    this->Breakpoints.clear();
    this->Last = { 0.0, y };
    this->Breakpoints.push_back({ 0.0, this->GetMapped(y) });
  }

  /// Adds a node after the last one, and breakpoints in between if the mapping is nonlinear.
  void Add(const Breakpoint& next)
  {
    const Breakpoint mapped{ next.Fraction, this->GetMapped(next.Y) };
    if (next.Fraction > this->Last.Fraction)
    {
      const Breakpoint before = this->Breakpoints.back();
      this->Bisect(this->Last, before, next, mapped, MaximumDepth);
    }
    else
    {
      this->Breakpoints.push_back(mapped);
    }
    this->Last = next;
  }

  bool IsStraight() const
  {
    const Value& first = this->Breakpoints.front().Y;
    const Value& last = this->Breakpoints.back().Y;
    return std::all_of(this->Breakpoints.begin(), this->Breakpoints.end(),
      [&](const Breakpoint& breakpoint)
      { return this->IsClose(breakpoint.Y, Mix(first, last, breakpoint.Fraction), Straight); });
  }

  /// Finds the start and end of an edge, before and after which the function is constant. Returns
  /// false if the function has another shape.
  bool FindEdge(std::array<float, 2>& edge) const
  {
    const Value& first = this->Breakpoints.front().Y;
    const Value& last = this->Breakpoints.back().Y;
    std::size_t begin = 0;
    while (begin + 1 < this->Breakpoints.size() &&
      this->IsClose(this->Breakpoints[begin + 1].Y, first, Straight))
    {
      ++begin;
    }
    std::size_t end = this->Breakpoints.size() - 1;
    while (end > 0 && this->IsClose(this->Breakpoints[end - 1].Y, last, Straight))
    {
      --end;
    }
    const double from = this->Breakpoints[begin].Fraction;
    const double to = this->Breakpoints[end].Fraction;
    // Inside the edge, the tolerance is Curved for the mean error over the interval, and therefore
    // greater for narrow edges. Outside, it is Straight.
    const double tolerance = std::max(Straight, Curved / std::max(to - from, Curved));
    const auto isEdge = [&](const Breakpoint& breakpoint)
    {
      const double fraction = std::clamp((breakpoint.Fraction - from) / (to - from), 0.0, 1.0);
      Value within = breakpoint.Y;
      for (std::size_t i = 0; i < within.size(); ++i)
      {
        within[i] = std::clamp(within[i], std::min(first[i], last[i]), std::max(first[i], last[i]));
      }
      const bool isInside = breakpoint.Fraction > from && breakpoint.Fraction < to;
      return this->IsClose(breakpoint.Y, within, Straight) &&
        this->IsClose(breakpoint.Y, Mix(first, last, fraction), isInside ? tolerance : Straight);
    };
    // A step consists of two breakpoints at the same position.
    const bool isFound = from < to
      ? std::all_of(this->Breakpoints.begin(), this->Breakpoints.end(), isEdge)
      : end == begin + 1;
    edge = { { isFound ? Round(from) : 0.0F, isFound ? Round(to) : 1.0F } };
    return isFound;
  }

  const std::vector<Breakpoint>& GetBreakpoints() const { return this->Breakpoints; }

private:
  /// Rounds to a multiple of 1 / EdgePositions, so that two such fractions fit into one
  /// single-precision number.
  static float Round(double fraction)
  {
    constexpr double steps = TransferColumns::EdgePositions;
    return static_cast<float>(std::round(fraction * steps) / steps);
  }

  /// Maps a value. Equal channels are mapped once.
  static Value Apply(const std::function<double(double)>& map, const Value& y)
  {
    const double first = map(y[0]);
    return y[1] == y[0] && y[2] == y[0] ? Value{ { first, first, first } }
                                        : Value{ { first, map(y[1]), map(y[2]) } };
  }

  bool IsClose(const Value& a, const Value& b, double tolerance) const
  {
    return GetDistance(Apply(this->Mapping.Invert, a), Apply(this->Mapping.Invert, b)) <=
      tolerance * this->Largest;
  }

  void Bisect(const Breakpoint& a, const Breakpoint& mappedA, const Breakpoint& b,
    const Breakpoint& mappedB, int depth)
  {
    const Breakpoint half{ 0.5 * (a.Fraction + b.Fraction), Mix(a.Y, b.Y, 0.5) };
    const Breakpoint mapped{ half.Fraction, this->GetMapped(half.Y) };
    if (depth == 0 || this->IsClose(mapped.Y, Mix(mappedA.Y, mappedB.Y, 0.5), Tolerance))
    {
      this->Breakpoints.push_back(mappedB);
      return;
    }
    this->Bisect(a, mappedA, half, mapped, depth - 1);
    this->Bisect(half, mapped, b, mappedB, depth - 1);
  }

  const TransferColumns::Mapping& Mapping;
  double Largest = 0.0;
  Breakpoint Last{};
  std::vector<Breakpoint> Breakpoints;
};

/// Appends a list of breakpoints to \a bends and returns the index of its first texel.
int Append(const std::vector<Breakpoint>& breakpoints, bool isOne, std::vector<float>& bends)
{
  bends.resize(std::max<std::size_t>(bends.size(), 4), 0.0F);
  const std::size_t first = bends.size();
  const auto add = [&bends](double a, double b, double c, double d)
  {
    bends.insert(bends.end(),
      { static_cast<float>(a), static_cast<float>(b), static_cast<float>(c),
        static_cast<float>(d) });
  };
  add(0.0, 0.0, 0.0, 0.0);
  for (std::size_t i = 0; i < breakpoints.size(); ++i)
  {
    const Breakpoint& breakpoint = breakpoints[i];
    if (!isOne)
    {
      add(breakpoint.Fraction, breakpoint.Y[0], breakpoint.Y[1], breakpoint.Y[2]);
    }
    else if (i > 0 && breakpoint.Fraction > breakpoints[i - 1].Fraction)
    {
      add(
        breakpoints[i - 1].Fraction, breakpoint.Fraction, breakpoints[i - 1].Y[0], breakpoint.Y[0]);
    }
  }
  bends[first] = static_cast<float>((bends.size() - first) / 4 - (isOne ? 1 : 2));
  return static_cast<int>(first / 4);
}
}

TransferColumns::TransferColumns(const TransferNodes& nodes, Channels channels, const Range& range,
  const Mapping& mapping, std::vector<float>& bends)
  : Bends(Columns, 0)
  , Edges(Columns, { { 0.0F, 1.0F } })
{
  const double width = (range[1] - range[0]) / (Columns - 1);
  const auto& all = nodes.GetNodes();
  // The first node to the right of the current column.
  auto next = all.begin();
  Interval interval(mapping, all);
  for (int i = 0; i < Columns; ++i)
  {
    const double x = i + 1 < Columns ? range[0] + width * i : range[1];
    while (next != all.end() && next->X <= x)
    {
      ++next;
    }
    const auto evaluate = [&](double position)
    {
      if (next == all.begin() || next == all.end())
      {
        return next == all.begin() ? next->Y : (next - 1)->Y;
      }
      const TransferNodes::Node& left = *(next - 1);
      return Mix(left.Y, next->Y, (position - left.X) / (next->X - left.X));
    };
    interval.Begin(evaluate(x));
    this->Values.push_back(interval.GetBreakpoints().front().Y);
    if (i + 1 == Columns)
    {
      break;
    }
    const double end = i + 2 < Columns ? range[0] + width * (i + 1) : range[1];
    for (; next != all.end() && next->X <= end; ++next)
    {
      interval.Add({ std::min((next->X - x) / (end - x), 1.0), next->Y });
    }
    interval.Add({ 1.0, evaluate(end) });
    if (!interval.IsStraight() && !interval.FindEdge(this->Edges[static_cast<std::size_t>(i)]))
    {
      this->Bends[static_cast<std::size_t>(i)] =
        Append(interval.GetBreakpoints(), channels == ONE, bends);
    }
  }
}

}
