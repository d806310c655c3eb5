// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Tables/HypercubeTable.h"

#include "Cases/CasePatch.h"
#include "Hulls/Polytope.h"
#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

using interlume::CasePatch;
using interlume::PointSet;
using interlume::Polytope;

namespace
{
constexpr int Vertices = 16;
constexpr std::uint32_t Cases = 43046721;
using PointList = CasePatch::PointList;

// A symmetry of the cube. Vertex and Edge contain the image of each vertex of the cube and of each
// edge of the lifted cube. Weight contains, for each vertex, the power of 3 by which its digit is
// multiplied in the key of the mapped case.
struct Symmetry
{
  std::array<int, Vertices> Vertex;
  std::vector<int> Edge;
  std::array<std::uint32_t, Vertices> Weight;
};

std::vector<Symmetry> MakeSymmetries(const Polytope& lifted)
{
  std::map<std::array<int, 2>, int> edgeOf;
  for (std::size_t e = 0; e < lifted.Edges.size(); ++e)
  {
    const auto& edge = lifted.Edges[e];
    edgeOf[{ { std::min(edge[0], edge[1]), std::max(edge[0], edge[1]) } }] = static_cast<int>(e);
  }
  std::array<std::uint32_t, Vertices> power;
  power[0] = 1;
  for (int v = 1; v < Vertices; ++v)
  {
    power[v] = 3 * power[v - 1];
  }
  std::vector<Symmetry> symmetries;
  std::array<int, 4> axes{ { 0, 1, 2, 3 } };
  do
  {
    for (int flips = 0; flips < 16; ++flips)
    {
      Symmetry symmetry;
      for (int v = 0; v < Vertices; ++v)
      {
        int image = 0;
        for (int axis = 0; axis < 4; ++axis)
        {
          image |= ((v >> axis) & 1) << axes[axis];
        }
        symmetry.Vertex[v] = image ^ flips;
        symmetry.Weight[v] = power[image ^ flips];
      }
      for (const auto& edge : lifted.Edges)
      {
        const auto move = [&symmetry](int v)
        { return symmetry.Vertex[v % Vertices] + v / Vertices * Vertices; };
        const int a = move(edge[0]);
        const int b = move(edge[1]);
        symmetry.Edge.push_back(edgeOf.at({ { std::min(a, b), std::max(a, b) } }));
      }
      symmetries.push_back(symmetry);
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return symmetries;
}

// A class of symmetric cases: the key of its first case and the number of cases.
struct Kind
{
  std::uint32_t Key;
  std::uint32_t Size;
  // For each facet: the index of its orbit, and of the symmetry that maps the first facet of the
  // orbit to it.
  std::vector<std::array<int, 2>> Facets;
};

std::array<int, Vertices> GetDigits(std::uint32_t key)
{
  std::array<int, Vertices> digits;
  for (int& digit : digits)
  {
    digit = key % 3;
    key /= 3;
  }
  return digits;
}

std::vector<Kind> FindKinds(const std::vector<Symmetry>& symmetries)
{
  std::vector<bool> seen(Cases, false);
  std::vector<Kind> kinds;
  for (std::uint32_t key = 0; key < Cases; ++key)
  {
    if (seen[key])
    {
      continue;
    }
    const auto digits = GetDigits(key);
    Kind kind{ key, 0, {} };
    for (const Symmetry& symmetry : symmetries)
    {
      std::uint32_t image = 0;
      for (int v = 0; v < Vertices; ++v)
      {
        image += digits[v] * symmetry.Weight[v];
      }
      kind.Size += !seen[image];
      seen[image] = true;
    }
    kinds.push_back(kind);
  }
  return kinds;
}

// The face lattice of a facet whose points are numbered from 0. It counts the simplices of pulling
// triangulations without computing them.
class Lattice
{
public:
  Lattice(const CasePatch& patch, const CasePatch::Facet& facet)
    : Points(facet.Points)
  {
    this->Top = this->Add(patch, facet.HullPoints);
  }

  // Returns the number of simplices. \a order contains the local point numbers from first to last.
  int CountPulling(const std::vector<int>& order) const
  {
    std::vector<int> known(this->Faces.size(), 0);
    return this->Count(this->Top, order, known);
  }

private:
  struct Face
  {
    std::uint64_t Points = 0;
    std::vector<int> Sides;
  };

  int Add(const CasePatch& patch, const PointSet& set)
  {
    Face face;
    for (int edge : patch.GetEdges(set))
    {
      const auto at = std::find(this->Points.begin(), this->Points.end(), edge);
      face.Points |= std::uint64_t(1) << (at - this->Points.begin());
    }
    const auto known = this->Index.find(face.Points);
    if (known != this->Index.end())
    {
      return known->second;
    }
    for (const PointSet& side : patch.GetFacetsOfFace(set))
    {
      face.Sides.push_back(this->Add(patch, side));
    }
    this->Faces.push_back(face);
    const int index = static_cast<int>(this->Faces.size()) - 1;
    this->Index[face.Points] = index;
    return index;
  }

  int Count(int index, const std::vector<int>& order, std::vector<int>& known) const
  {
    const Face& face = this->Faces[index];
    if (face.Sides.empty())
    {
      return 1;
    }
    if (known[index] == 0)
    {
      const int first = *std::find_if(
        order.begin(), order.end(), [&face](int p) { return (face.Points >> p) & 1; });
      for (int side : face.Sides)
      {
        if (((this->Faces[side].Points >> first) & 1) == 0)
        {
          known[index] += this->Count(side, order, known);
        }
      }
    }
    return known[index];
  }

  PointList Points;
  std::vector<Face> Faces;
  std::map<std::uint64_t, int> Index;
  int Top = 0;
};

// The images of one facet under all symmetries. Counts contains the number of simplices of each
// image for each rule. Key and Points are the case and the points of the first facet.
struct Orbit
{
  std::uint32_t Key;
  PointList Points;
  std::vector<std::vector<int>> Counts;
};

class Counter
{
public:
  Counter(const std::vector<HypercubeTable::Rule>& rules, int stride)
    : Rules(rules)
    , Lifted(Polytope::Cube(4).Prism())
    , Symmetries(MakeSymmetries(Lifted))
    , Kinds(FindKinds(Symmetries))
  {
    std::vector<Kind> selected;
    for (std::size_t k = 0; k < this->Kinds.size(); k += stride)
    {
      selected.push_back(this->Kinds[k]);
    }
    this->Kinds.swap(selected);
  }

  std::vector<HypercubeTable::Statistics> Count()
  {
    this->FindFacets();
    this->CountOrbits();
    std::vector<HypercubeTable::Statistics> results;
    for (std::size_t rule = 0; rule < this->Rules.size(); ++rule)
    {
      results.push_back(this->Sum(rule));
    }
    return results;
  }

private:
  void FindFacets()
  {
    std::vector<std::vector<PointList>> facets(this->Kinds.size());
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->Kinds.size()),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType k = first; k < last; ++k)
        {
          const CasePatch patch(
            this->Lifted, CasePatch::GetSigns(Vertices, true, this->Kinds[k].Key));
          for (const auto& facet : patch.GetFacets())
          {
            facets[k].push_back(facet.Points);
          }
        }
      });
    std::map<PointList, std::array<int, 2>> orbitOf;
    for (std::size_t k = 0; k < this->Kinds.size(); ++k)
    {
      for (const PointList& facet : facets[k])
      {
        auto known = orbitOf.find(facet);
        if (known == orbitOf.end())
        {
          const int orbit = static_cast<int>(this->Orbits.size());
          this->Orbits.push_back({ this->Kinds[k].Key, facet, {} });
          for (std::size_t g = 0; g < this->Symmetries.size(); ++g)
          {
            PointList image;
            for (int edge : facet)
            {
              image.push_back(this->Symmetries[g].Edge[edge]);
            }
            std::sort(image.begin(), image.end());
            orbitOf.insert({ image, { { orbit, static_cast<int>(g) } } });
          }
          known = orbitOf.find(facet);
        }
        this->Kinds[k].Facets.push_back(known->second);
      }
    }
    this->NumberOfFacets = orbitOf.size();
  }

  void CountOrbits()
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->Orbits.size()),
      [this](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType o = first; o < last; ++o)
        {
          for (const HypercubeTable::Rule& rule : this->Rules)
          {
            this->Orbits[o].Counts.push_back(this->CountImages(this->Orbits[o], rule));
          }
        }
      });
  }

  std::vector<int> CountImages(const Orbit& orbit, const HypercubeTable::Rule& rule) const
  {
    const CasePatch patch(this->Lifted, CasePatch::GetSigns(Vertices, true, orbit.Key));
    const auto facet = std::find_if(patch.GetFacets().begin(), patch.GetFacets().end(),
      [&orbit](const CasePatch::Facet& f) { return f.Points == orbit.Points; });
    const Lattice lattice(patch, *facet);
    std::map<std::vector<int>, int> known;
    std::vector<int> counts;
    std::vector<int> ranks(this->Lifted.Edges.size());
    std::vector<int> order(orbit.Points.size());
    for (const Symmetry& symmetry : this->Symmetries)
    {
      // Triangulating the image of the facet in the fixed order is equivalent to triangulating the
      // facet in the preimage of that order.
      for (std::size_t e = 0; e < ranks.size(); ++e)
      {
        ranks[e] = rule.Ranks[symmetry.Edge[e]];
      }
      std::iota(order.begin(), order.end(), 0);
      std::sort(order.begin(), order.end(),
        [&](int a, int b) { return ranks[orbit.Points[a]] < ranks[orbit.Points[b]]; });
      const auto found = known.insert({ order, 0 });
      if (found.second)
      {
        found.first->second = rule.Method == FacetTriangulation::PULLING
          ? lattice.CountPulling(order)
          : static_cast<int>(
              FacetTriangulation::TriangulateFacet(patch, *facet, rule.Method, ranks).size());
      }
      counts.push_back(found.first->second);
    }
    return counts;
  }

  HypercubeTable::Statistics Sum(std::size_t rule) const
  {
    const int n = static_cast<int>(this->Symmetries.size());
    std::map<std::array<int, Vertices>, int> indexOf;
    for (int g = 0; g < n; ++g)
    {
      indexOf[this->Symmetries[g].Vertex] = g;
    }
    // product[g * n + h] is the index of the symmetry that applies g and then h.
    std::vector<int> product(n * n);
    for (int g = 0; g < n; ++g)
    {
      for (int h = 0; h < n; ++h)
      {
        std::array<int, Vertices> both;
        for (int v = 0; v < Vertices; ++v)
        {
          both[v] = this->Symmetries[h].Vertex[this->Symmetries[g].Vertex[v]];
        }
        product[g * n + h] = indexOf.at(both);
      }
    }
    HypercubeTable::Statistics result;
    result.CasesUpToSymmetry = this->Kinds.size();
    result.FacetOrbits = this->Orbits.size();
    result.Facets = this->NumberOfFacets;
    std::vector<int> totals(n);
    for (const Kind& kind : this->Kinds)
    {
      std::fill(totals.begin(), totals.end(), 0);
      for (const auto& facet : kind.Facets)
      {
        const std::vector<int>& counts = this->Orbits[facet[0]].Counts[rule];
        const int* images = product.data() + facet[1] * n;
        for (int h = 0; h < n; ++h)
        {
          totals[h] += counts[images[h]];
        }
      }
      const std::uint64_t repetitions = n / kind.Size;
      result.Cases += kind.Size;
      result.Sum += std::accumulate(totals.begin(), totals.end(), std::uint64_t(0)) / repetitions;
      const int maximum = *std::max_element(totals.begin(), totals.end());
      if (maximum > result.Maximum)
      {
        result.Maximum = maximum;
        result.CasesAtMaximum = 0;
      }
      if (maximum == result.Maximum)
      {
        result.CasesAtMaximum += std::count(totals.begin(), totals.end(), maximum) / repetitions;
      }
    }
    return result;
  }

  const std::vector<HypercubeTable::Rule>& Rules;
  Polytope Lifted;
  std::vector<Symmetry> Symmetries;
  std::vector<Kind> Kinds;
  std::vector<Orbit> Orbits;
  std::size_t NumberOfFacets = 0;
};
}

std::vector<HypercubeTable::Statistics> HypercubeTable::Count(
  const std::vector<Rule>& rules, int stride)
{
  return Counter(rules, stride).Count();
}
