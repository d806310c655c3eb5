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

/// The error that needs no list, and of lists, as a share of the largest value.
constexpr double Straight = 1e-3;
/// The error within an edge, over the whole way, as a share of the largest value.
constexpr double Curved = 1e-2;
constexpr double Tolerance = 1e-4;
/// Straight pieces are halved this often at most.
constexpr int Depth = 12;

/// The share of the way between two columns, and the value there.
struct Place
{
  double Share;
  Value Y;
};

/// One way from column to column, as mapped nodes.
class Way
{
public:
  Way(const TransferColumns::Mapping& mapping, const std::vector<TransferNodes::Node>& nodes)
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
    this->Places.clear();
    this->Last = { 0.0, y };
    this->Places.push_back({ 0.0, this->GetMapped(y) });
  }

  /// Adds a node after the last one, as far as a further one.
  void Add(const Place& next)
  {
    const Place mapped{ next.Share, this->GetMapped(next.Y) };
    if (next.Share > this->Last.Share)
    {
      const Place before = this->Places.back();
      this->Halve(this->Last, before, next, mapped, Depth);
    }
    else
    {
      this->Places.push_back(mapped);
    }
    this->Last = next;
  }

  bool IsStraight() const
  {
    const Value& first = this->Places.front().Y;
    const Value& last = this->Places.back().Y;
    return std::all_of(this->Places.begin(), this->Places.end(),
      [&](const Place& place)
      { return this->IsClose(place.Y, Mix(first, last, place.Share), Straight); });
  }

  /// Finds where an edge begins and ends, before and after which the values are those of the ends.
  /// Returns false where there is more than an edge.
  bool FindEdge(std::array<float, 2>& edge) const
  {
    const Value& first = this->Places.front().Y;
    const Value& last = this->Places.back().Y;
    std::size_t begin = 0;
    while (
      begin + 1 < this->Places.size() && this->IsClose(this->Places[begin + 1].Y, first, Straight))
    {
      ++begin;
    }
    std::size_t end = this->Places.size() - 1;
    while (end > 0 && this->IsClose(this->Places[end - 1].Y, last, Straight))
    {
      --end;
    }
    const double from = this->Places[begin].Share;
    const double to = this->Places[end].Share;
    // An error within the edge counts by its part of the way; none is allowed beyond its ends.
    const double tolerance = std::max(Straight, Curved / std::max(to - from, Curved));
    const auto isEdge = [&](const Place& place)
    {
      const double share = std::clamp((place.Share - from) / (to - from), 0.0, 1.0);
      Value within = place.Y;
      for (std::size_t i = 0; i < within.size(); ++i)
      {
        within[i] = std::clamp(within[i], std::min(first[i], last[i]), std::max(first[i], last[i]));
      }
      const bool isInside = place.Share > from && place.Share < to;
      return this->IsClose(place.Y, within, Straight) &&
        this->IsClose(place.Y, Mix(first, last, share), isInside ? tolerance : Straight);
    };
    // A step has two values at one place.
    const bool isFound =
      from < to ? std::all_of(this->Places.begin(), this->Places.end(), isEdge) : end == begin + 1;
    edge = { { isFound ? Round(from) : 0.0F, isFound ? Round(to) : 1.0F } };
    return isFound;
  }

  const std::vector<Place>& GetPlaces() const { return this->Places; }

private:
  /// Rounds to a place of which two fit into a number of single precision.
  static float Round(double share)
  {
    constexpr double places = TransferColumns::EdgePlaces;
    return static_cast<float>(std::round(share * places) / places);
  }

  /// Maps a value; channels of one value are mapped once.
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

  void Halve(const Place& a, const Place& mappedA, const Place& b, const Place& mappedB, int depth)
  {
    const Place half{ 0.5 * (a.Share + b.Share), Mix(a.Y, b.Y, 0.5) };
    const Place mapped{ half.Share, this->GetMapped(half.Y) };
    if (depth == 0 || this->IsClose(mapped.Y, Mix(mappedA.Y, mappedB.Y, 0.5), Tolerance))
    {
      this->Places.push_back(mappedB);
      return;
    }
    this->Halve(a, mappedA, half, mapped, depth - 1);
    this->Halve(half, mapped, b, mappedB, depth - 1);
  }

  const TransferColumns::Mapping& Mapping;
  double Largest = 0.0;
  Place Last{};
  std::vector<Place> Places;
};

/// Appends a list, and returns its first texel.
int Append(const std::vector<Place>& places, bool isOne, std::vector<float>& bends)
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
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const Place& place = places[i];
    if (!isOne)
    {
      add(place.Share, place.Y[0], place.Y[1], place.Y[2]);
    }
    else if (i > 0 && place.Share > places[i - 1].Share)
    {
      add(places[i - 1].Share, place.Share, places[i - 1].Y[0], place.Y[0]);
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
  // The first node to the right of the column.
  auto next = all.begin();
  Way way(mapping, all);
  for (int i = 0; i < Columns; ++i)
  {
    const double x = i + 1 < Columns ? range[0] + width * i : range[1];
    while (next != all.end() && next->X <= x)
    {
      ++next;
    }
    const auto evaluate = [&](double place)
    {
      if (next == all.begin() || next == all.end())
      {
        return next == all.begin() ? next->Y : (next - 1)->Y;
      }
      const TransferNodes::Node& left = *(next - 1);
      return Mix(left.Y, next->Y, (place - left.X) / (next->X - left.X));
    };
    way.Begin(evaluate(x));
    this->Values.push_back(way.GetPlaces().front().Y);
    if (i + 1 == Columns)
    {
      break;
    }
    const double end = i + 2 < Columns ? range[0] + width * (i + 1) : range[1];
    for (; next != all.end() && next->X <= end; ++next)
    {
      way.Add({ std::min((next->X - x) / (end - x), 1.0), next->Y });
    }
    way.Add({ 1.0, evaluate(end) });
    if (!way.IsStraight() && !way.FindEdge(this->Edges[static_cast<std::size_t>(i)]))
    {
      this->Bends[static_cast<std::size_t>(i)] = Append(way.GetPlaces(), channels == ONE, bends);
    }
  }
}

}
