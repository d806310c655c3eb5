// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_UnstructuredPartField_h
#define interlume_UnstructuredPartField_h

#include "Fields/BoundaryPatches.h"
#include "Fields/FieldPart.h"
#include "Fields/UnstructuredFlowField.h"
#include "Fields/UnstructuredWalker.h"
#include "Streams/PartInterfaces.h"
#include "Streams/RankBoxes.h"
#include "Streams/RankField.h"

#include <memory>
#include <vector>

namespace interlume
{

/**
 * @class   UnstructuredPartField
 * @brief   a field on an unstructured grid of which a process holds a part
 *
 * The process holds its own cells and no others. Cells have their numbers in the whole: those of
 * process 0 come first, then those of process 1. Links of faces to cells of other processes are
 * found by the corners of faces on the outside (OutsideFaces), and with them is known all of a cell
 * that crossing to it needs: its number, its shape, how the faces lie. Cells are searched as on
 * structured grids (PartSearch).
 */
class UnstructuredPartField : public UnstructuredFlowField
{
public:
  static constexpr bool IsSearched = true;

  /// Builds the field of the own cells; speeds, links and tree are not known before Join and
  /// SetSpeeds.
  Error BuildPart(vtkUnstructuredGrid* grid, vtkDataArray* vectors,
    const std::vector<vtkDataArray*>& arrays, const FieldPart& part);

  /// Makes the tree and finds the links, once BuildPart has succeeded in all processes. Collective.
  /// Returns an error if the whole field cannot be used.
  Error Join(RankExchange& exchange);

  /// Counts the speeds in points such that all processes together count each once.
  SpeedCount CountOwnSpeeds() const;
  using FlowField::SetSpeeds;

  /// Makes the patches of the whole's boundary, as domain faces. Collective.
  void FindPatches(RankExchange& exchange);
  /// Returns them; null before.
  const BoundaryPatches* GetPatches() const { return this->Patches.get(); }

  /// Returns what is so of the whole, and whether faces do not fit between processes.
  const PartInterfaces& GetInterfaces() const { return this->Interfaces; }
  /// Returns the joins of which this process has the first face.
  const FaceLinks::Joins& GetJoins() const { return this->Joins; }

  /// Calls visit(rank) for the processes whose cells may hold x.
  template <typename Visit>
  void ForEachRankAt(const double x[3], Visit&& visit) const
  {
    this->Boxes.ForEachAt(x, 0.0, visit);
  }
  int FindRank(const RankField& ranks, vtkIdType cell) const { return ranks.FindRank(cell); }

  ///@{
  /// Those of UnstructuredFlowField, for cells by their numbers in the whole.
  Place GetPlace(vtkIdType cell) const { return this->GetHeldPlace(cell - this->First); }
  Place GetHeldPlace(vtkIdType cell) const
  {
    Place place = UnstructuredFlowField::GetPlace(cell);
    place.Cell += this->First;
    return place;
  }
  bool IsHere(const Place& place) const
  {
    return place.Cell >= this->First && place.Cell < this->End;
  }
  void Prefetch(const Place& place, int face, int round) const
  {
    const vtkIdType link = this->GetLink(place.Cell - this->First, face);
    if (link >= 0)
    {
      this->PrefetchCell(UnstructuredFlowField::GetPlace(link >> 6), round);
    }
  }
  bool Cross(Place& place, int face, double p[3]) const
  {
    const vtkIdType link = this->GetLink(place.Cell - this->First, face);
    if (link >= 0)
    {
      this->CrossTo(this->GetHeldPlace(link >> 6), link, place, face, p);
    }
    else if (link < -1)
    {
      const Elsewhere& beyond = this->Beyond[static_cast<std::size_t>(-2 - link)];
      this->CrossTo(beyond.Cell, beyond.Link, place, face, p);
    }
    return link != -1;
  }
  ///@}

private:
  /// A cell of another process, of which only number and type are known, and the link to it.
  struct Elsewhere
  {
    Place Cell;
    vtkIdType Link;
  };

  std::vector<vtkIdType> GetOutside() const;
  std::vector<vtkIdType> GetPointsOf(const std::vector<vtkIdType>& faces) const;
  void FindLinksToOthers(
    const std::vector<vtkIdType>& faces, MeshLinks& mesh, RankExchange& exchange);

  vtkIdType First = 0;
  vtkIdType End = 0;
  RankBoxes Boxes;
  // Links below -1 lead to what has the index -2 - link.
  std::vector<Elsewhere> Beyond;
  FaceLinks::Joins Joins;
  PartInterfaces Interfaces;
  // The points that processes before this one have too.
  std::vector<vtkIdType> Repeated;
  std::unique_ptr<BoundaryPatches> Patches;
};

/**
 * @class   UnstructuredPartWalker
 * @brief   the walker of parts of unstructured grids; it knows the field's patches
 */
class UnstructuredPartWalker : public UnstructuredWalkerOf<UnstructuredPartField>
{
public:
  explicit UnstructuredPartWalker(const UnstructuredPartField* field)
    : UnstructuredWalkerOf(field)
  {
    this->SetPatches(field->GetPatches());
  }
};

}

#endif
