// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Meshes/ReferenceMesh.h"

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Meshes/ReferenceMeshBuilder.h"
#include "Support/Meshes/ReferenceTiling.h"

#include <random>

namespace reference
{

namespace
{

using Ids = std::vector<vtkIdType>;

/// Corners of the six faces of a box, ordered so that normals point outward.
constexpr int BoxFaces[6][4] = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 },
  { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };
constexpr int LowerFace = 4;

/// Corners of the two wedges of a box that is cut along the diagonal 0-2. The first and the last
/// three corners of a wedge are its triangles.
constexpr int WedgesOfBox[2][6] = { { 0, 2, 1, 4, 6, 5 }, { 0, 3, 2, 4, 7, 6 } };

constexpr int TetrahedraAroundDiagonal[6][4] = { { 0, 1, 2, 6 }, { 0, 2, 3, 6 }, { 0, 3, 7, 6 },
  { 0, 7, 4, 6 }, { 0, 4, 5, 6 }, { 0, 5, 1, 6 } };

constexpr int FiveTetrahedra[2][5][4] = { { { 0, 1, 2, 5 }, { 0, 2, 3, 7 }, { 0, 5, 7, 4 },
                                            { 2, 7, 5, 6 }, { 0, 2, 7, 5 } },
  { { 1, 3, 0, 4 }, { 1, 2, 3, 6 }, { 1, 6, 4, 5 }, { 3, 4, 6, 7 }, { 1, 3, 4, 6 } } };

class BoxFiller
{
public:
  BoxFiller(MeshKind kind, const std::array<int, 3>& cells, unsigned int seed)
    : Kind(kind)
    , Cells(cells)
    , Random(seed)
  {
    for (int k = 0; k <= cells[2]; ++k)
    {
      for (int j = 0; j <= cells[1]; ++j)
      {
        for (int i = 0; i <= cells[0]; ++i)
        {
          this->Builder.AddPoint(i, j, k);
        }
      }
    }
    // In each column of a mixed mesh, the lower and upper faces of the boxes are either all
    // quadrilaterals or all split into triangles.
    this->CutColumns.resize(static_cast<size_t>(cells[0]) * cells[1]);
    for (size_t c = 0; c < this->CutColumns.size(); ++c)
    {
      this->CutColumns[c] = this->Random() % 2 == 0;
    }
  }

  vtkSmartPointer<vtkUnstructuredGrid> Fill()
  {
    for (const auto& [k, j, i] : AllIndices(this->Cells[2], this->Cells[1], this->Cells[0]))
    {
      this->FillBox(i, j, k);
    }
    return this->Builder.GetMesh();
  }

private:
  template <size_t N>
  Ids Pick(const int (&corners)[N]) const
  {
    Ids ids;
    for (int corner : corners)
    {
      ids.push_back(this->Box[corner]);
    }
    return ids;
  }

  vtkIdType AddCenter(int i, int j, int k)
  {
    return this->Builder.AddPoint(i + 0.5, j + 0.5, k + 0.5);
  }

  void AddPyramid(int face, vtkIdType apex)
  {
    // In VTK, the normal of a pyramid's base points to the apex, so the base is reversed.
    Ids base = this->Pick(BoxFaces[face]);
    this->Builder.AddCell(VTK_PYRAMID, { base[3], base[2], base[1], base[0], apex });
  }

  void AddHalvedPyramid(int face, vtkIdType apex)
  {
    // Splits the base along the same diagonal as the wedges and Tetrahedra6. The diagonal starts at
    // corner 0 or 6 of the box.
    Ids base = this->Pick(BoxFaces[face]);
    int first = 0;
    while (BoxFaces[face][first] != 0 && BoxFaces[face][first] != 6)
    {
      ++first;
    }
    const vtkIdType a = base[first];
    const vtkIdType b = base[(first + 1) % 4];
    const vtkIdType c = base[(first + 2) % 4];
    const vtkIdType d = base[(first + 3) % 4];
    this->Builder.AddCell(VTK_TETRA, { a, c, b, apex });
    this->Builder.AddCell(VTK_TETRA, { a, d, c, apex });
  }

  void AddBoxPolyhedron()
  {
    std::vector<Ids> faces;
    for (const auto& face : BoxFaces)
    {
      faces.push_back(this->Pick(face));
    }
    this->Builder.AddPolyhedron(faces);
  }

  void AddWedgePolyhedron(const int (&w)[6])
  {
    const Ids v = this->Pick(w);
    this->Builder.AddPolyhedron({ { v[0], v[1], v[2] }, { v[3], v[5], v[4] },
      { v[0], v[3], v[4], v[1] }, { v[1], v[4], v[5], v[2] }, { v[2], v[5], v[3], v[0] } });
  }

  void FillMixed(int i, int j, int k)
  {
    const bool cut = this->CutColumns[static_cast<size_t>(j) * this->Cells[0] + i];
    const unsigned int choice = this->Random() % 3;
    if (choice == 0)
    {
      const vtkIdType apex = this->AddCenter(i, j, k);
      for (int face = 0; face < 6; ++face)
      {
        cut&& face >= LowerFace ? this->AddHalvedPyramid(face, apex) : this->AddPyramid(face, apex);
      }
    }
    else if (cut)
    {
      this->Builder.AddCell(VTK_WEDGE, this->Pick(WedgesOfBox[0]));
      choice == 1 ? this->Builder.AddCell(VTK_WEDGE, this->Pick(WedgesOfBox[1]))
                  : this->AddWedgePolyhedron(WedgesOfBox[1]);
    }
    else if (choice == 1)
    {
      this->AddBoxPolyhedron();
    }
    else
    {
      this->Builder.AddCell(VTK_HEXAHEDRON, Ids(this->Box.begin(), this->Box.end()));
    }
  }

  void FillBox(int i, int j, int k)
  {
    this->Box = BoxCorners(this->Cells, i, j, k);
    switch (this->Kind)
    {
      case MeshKind::Hexahedra:
        this->Builder.AddCell(VTK_HEXAHEDRON, Ids(this->Box.begin(), this->Box.end()));
        break;
      case MeshKind::Voxels:
        this->Builder.AddCell(VTK_VOXEL, this->Pick({ 0, 1, 3, 2, 4, 5, 7, 6 }));
        break;
      case MeshKind::Wedges:
        this->Builder.AddCell(VTK_WEDGE, this->Pick(WedgesOfBox[0]));
        this->Builder.AddCell(VTK_WEDGE, this->Pick(WedgesOfBox[1]));
        break;
      case MeshKind::Pyramids:
      case MeshKind::Tetrahedra12:
      {
        const vtkIdType apex = this->AddCenter(i, j, k);
        for (int face = 0; face < 6; ++face)
        {
          this->Kind == MeshKind::Pyramids ? this->AddPyramid(face, apex)
                                           : this->AddHalvedPyramid(face, apex);
        }
        break;
      }
      case MeshKind::Tetrahedra5:
        for (const auto& tetrahedron : FiveTetrahedra[(i + j + k) % 2])
        {
          this->Builder.AddCell(VTK_TETRA, this->Pick(tetrahedron));
        }
        break;
      case MeshKind::Tetrahedra6:
        for (const auto& tetrahedron : TetrahedraAroundDiagonal)
        {
          this->Builder.AddCell(VTK_TETRA, this->Pick(tetrahedron));
        }
        break;
      case MeshKind::Boxes:
        this->AddBoxPolyhedron();
        break;
      default:
        this->FillMixed(i, j, k);
    }
  }

  MeshKind Kind;
  std::array<int, 3> Cells;
  std::mt19937 Random;
  MeshBuilder Builder;
  std::array<vtkIdType, 8> Box{};
  std::vector<bool> CutColumns;
};

}

std::array<vtkIdType, 8> BoxCorners(const std::array<int, 3>& cells, int i, int j, int k)
{
  const vtkIdType row = cells[0] + 1;
  const vtkIdType slice = row * (cells[1] + 1);
  const vtkIdType first = i + j * row + k * slice;
  return { first, first + 1, first + row + 1, first + row, first + slice, first + slice + 1,
    first + slice + row + 1, first + slice + row };
}

const std::vector<MeshKind>& AllMeshKinds()
{
  static const std::vector<MeshKind> kinds = { MeshKind::Hexahedra, MeshKind::Voxels,
    MeshKind::Wedges, MeshKind::Pyramids, MeshKind::Tetrahedra5, MeshKind::Tetrahedra6,
    MeshKind::Tetrahedra12, MeshKind::Boxes, MeshKind::Mixed, MeshKind::Honeycomb,
    MeshKind::Kelvin };
  return kinds;
}

const std::vector<MeshKind>& TetrahedralMeshKinds()
{
  static const std::vector<MeshKind> kinds = { MeshKind::Tetrahedra5, MeshKind::Tetrahedra6,
    MeshKind::Tetrahedra12 };
  return kinds;
}

std::string GetName(MeshKind kind)
{
  static const char* const names[] = { "hexahedra", "voxels", "wedges", "pyramids", "tetrahedra-5",
    "tetrahedra-6", "tetrahedra-12", "boxes", "mixed", "honeycomb", "kelvin" };
  return names[static_cast<int>(kind)];
}

vtkSmartPointer<vtkUnstructuredGrid> MakeMesh(
  MeshKind kind, const std::array<int, 3>& cells, unsigned int seed)
{
  switch (kind)
  {
    case MeshKind::Honeycomb:
      return MakeHoneycomb(cells);
    case MeshKind::Kelvin:
      return MakeKelvinTiling(cells);
    default:
      return BoxFiller(kind, cells, seed).Fill();
  }
}

}
