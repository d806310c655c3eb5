// SPDX-License-Identifier: BSD-3-Clause
#ifndef PictureCases_h
#define PictureCases_h

#include "Support/Pictures/PictureSettings.h" // for points
#include "Support/Pictures/ReferenceRay.h"    // for lines of sight

#include <array>  // for vectors
#include <string> // for names
#include <vector> // for nodes

class vtkUnstructuredGrid;

/**
 * What pictures of tetrahedra are tested on.
 */
namespace reference
{

/// The unit cube in cells^3 boxes of five tetrahedra, points in double, with the scalars `f` =
/// 0.1 + 0.5 x + 0.3 y + 0.1 z: from 0.1 to 1.
vtkSmartPointer<vtkUnstructuredGrid> MakeCube(int cells);

/// The unit cube in layers of so many boxes, each of six tetrahedra, with `f` as above.
vtkSmartPointer<vtkUnstructuredGrid> MakeBox(const std::array<int, 3>& cells);

/// The unit square in cells^2 boxes of five tetrahedra a layer, the layers between the given z,
/// with `f` as above.
vtkSmartPointer<vtkUnstructuredGrid> MakeLayers(int cells, const std::vector<double>& z);

/// Every point p becomes origin + scale * p * stretch, component by component.
void MovePoints(vtkUnstructuredGrid* grid, const Point3& origin, double scale,
  const Point3& stretch = { { 1.0, 1.0, 1.0 } });

/// Adds the point array: constant + gradient . p of the points as they are now.
void AddLinear(
  vtkUnstructuredGrid* grid, const std::string& name, double constant, const Point3& gradient);

/// Adds a cell array with the number of the slab in which the cell's centre is: slabs across an
/// axis of the bounds.
void AddSlabs(vtkUnstructuredGrid* grid, const std::string& name, int axis, int slabs);

/// The length of a line of sight within the bounds of a grid.
double BoxChord(vtkUnstructuredGrid* grid, const Ray& ray);

}

#endif
