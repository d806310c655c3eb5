#ifndef vtkIsotableSymmetries_h
#define vtkIsotableSymmetries_h

#include "InterlumeIsotablesModule.h" // for the export macro
#include "vtkIsotablePolytope.h"      // for the cell

#include <array>   // for the edges
#include <cstdint> // for the slots
#include <vector>  // for the lists

/**
 * @class   vtkIsotableSymmetries
 * @brief   the affine maps of a cell onto itself, and what they do to the cases of its interval
 * table
 *
 * They are the automorphisms of the graph of vertices and edges that are affine in the coordinates:
 * 384 for the four-dimensional cube, 48 for the prisms over tetrahedron and wedge, 16 for that over
 * the pyramid. Cases that one of them takes into each other are of one kind, and the smallest of
 * their keys stands for it.
 *
 * For cells with at most 16 vertices. Slots are those of vtkIsotableOrder.
 */
class INTERLUMEISOTABLES_EXPORT vtkIsotableSymmetries
{
public:
  using Slot = std::uint8_t;

  struct Symmetry
  {
    /// Where each slot goes; the first are the vertices.
    std::vector<Slot> Slots;
    /// Whether it is a reflection.
    bool Reverses;
  };

  /// The case of a key is that of the smallest key moved by a symmetry.
  struct Origin
  {
    std::uint32_t Key;
    int Symmetry;
  };

  explicit vtkIsotableSymmetries(const vtkIsotablePolytope& cell);

  /// The identity is the first.
  const std::vector<Symmetry>& Get() const { return this->Symmetries; }

  /// The smallest key of the kind of \a key; of several symmetries the first.
  Origin FindOrigin(std::uint32_t key) const;

private:
  // A key is taken apart into groups of four digits.
  static constexpr int GroupSize = 4;
  static constexpr int GroupCases = 81;

  void FillMovedKeys(int numberOfVertices);

  std::vector<Symmetry> Symmetries;
  int NumberOfGroups = 0;
  /// For each group, each of its values and each symmetry, the group's share in the key that the
  /// symmetry's inverse makes.
  std::vector<std::uint32_t> MovedKeys;
};

#endif
