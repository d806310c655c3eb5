// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceTimeSteps_h
#define ReferenceTimeSteps_h

#include "vtkSmartPointer.h" // for the data

#include <array>      // for positions
#include <functional> // for fields
#include <string>     // for names
#include <vector>     // for the steps

class vtkDataObject;
class vtkDataSet;

/**
 * Time-varying data for tests, built without the code under test.
 */
namespace reference
{

struct TimeStep
{
  double Time;
  vtkSmartPointer<vtkDataObject> Data;
};

using TimeSteps = std::vector<TimeStep>;

/// Returns the dataset of a step, or null if its data is composite.
vtkDataSet* GetDataSet(const TimeStep& step);

/// Returns one step with a copy of \a grid for each time. The copies share cells but have their own
/// points and arrays.
TimeSteps RepeatGrid(vtkDataSet* grid, const std::vector<double>& times);

/// A function of position, time and point id.
using SpaceTimeFunction =
  std::function<double(const std::array<double, 3>& x, double time, vtkIdType point)>;

/// Adds a point array with the values of \a function to every step, as the active scalars.
void AddSpaceTimeField(
  const TimeSteps& steps, const SpaceTimeFunction& function, const char* name = "f");

/// Adds independent random numbers, uniform in [0,1), for every point and time.
void AddRandomTimeField(const TimeSteps& steps, unsigned int seed, const char* name = "f");

/// Adds independent random integers in [0, \a values) for every point and time.
void AddIntegerTimeField(
  const TimeSteps& steps, int values, unsigned int seed, const char* name = "f");

/// Adds a field that is a random number in [0,1) for each point, plus \a rate * time. On static
/// tetrahedra, it is linear in space and time in each tetrahedron.
void AddDriftingField(
  const TimeSteps& steps, double rate, unsigned int seed, const char* name = "f");

/// A motion of points. MovePoints() applies it to all steps, whose data must be vtkPointSet.
using Motion = std::function<void(std::array<double, 3>& x, double time)>;
void MovePoints(const TimeSteps& steps, const Motion& motion);

/// Scales and shifts each coordinate by amounts that are linear in time. Therefore, planes
/// perpendicular to an axis remain planes, also in space-time.
void Stretch(std::array<double, 3>& x, double time);

/// In each step, moves the points that are not on the bounding box by independent random amounts of
/// up to \a reach along each axis. Throws std::invalid_argument if there are no such points.
void PerturbInteriorPoints(const TimeSteps& steps, double reach, unsigned int seed);

struct NamedGrid
{
  std::string Name;
  vtkSmartPointer<vtkDataSet> Data;
};

/// Returns a grid of each structured dataset type, and an unstructured grid of each kind in
/// AllMeshKinds(), with a randomly rotated point order in each cell and random point ids.
/// MovePoints() supports all grids except the image and the rectilinear grid. Every domain is a
/// box, except those of MeshKind::Honeycomb and MeshKind::Kelvin.
std::vector<NamedGrid> MakeAllGridTypes(const std::array<int, 3>& cells, unsigned int seed);

bool IsTetrahedral(vtkDataSet* data);

/// Returns whether the cells fill their bounding box.
bool HasBoxDomain(vtkDataSet* data);

}

#endif
