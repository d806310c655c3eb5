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
 * Data at several times, made without the code under test.
 */
namespace reference
{

struct TimeStep
{
  double Time;
  vtkSmartPointer<vtkDataObject> Data;
};

using TimeSteps = std::vector<TimeStep>;

/// The data set of a step; null where the step is composite.
vtkDataSet* GetDataSet(const TimeStep& step);

/// \a grid at every time: cells are shared, points and arrays are copies.
TimeSteps RepeatGrid(vtkDataSet* grid, const std::vector<double>& times);

/// A function of place, time and point.
using SpaceTimeFunction =
  std::function<double(const std::array<double, 3>& x, double time, vtkIdType point)>;

/// Adds a point array to every step and makes it the active scalars.
void AddSpaceTimeField(
  const TimeSteps& steps, const SpaceTimeFunction& function, const char* name = "f");

/// The same with independent random numbers, uniform in [0,1), at every point and time.
void AddRandomTimeField(const TimeSteps& steps, unsigned int seed, const char* name = "f");

/// The same with random integers in [0, values).
void AddIntegerTimeField(
  const TimeSteps& steps, int values, unsigned int seed, const char* name = "f");

/// The same with one random number a point, in [0,1), plus \a rate times the time: on tetrahedra
/// that do not move it is linear in space and time in each.
void AddDriftingField(
  const TimeSteps& steps, double rate, unsigned int seed, const char* name = "f");

/// Moves every point of a step of vtkPointSet.
using Motion = std::function<void(std::array<double, 3>& x, double time)>;
void MovePoints(const TimeSteps& steps, const Motion& motion);

/// A motion under which planes across an axis stay planes, in space and time as well: each
/// coordinate is scaled and shifted by amounts linear in time.
void Stretch(std::array<double, 3>& x, double time);

/// Moves the points that are not on the boundary of the box that holds them by up to \a reach along
/// each axis, at random and differently in each step. std::invalid_argument where there are none.
void MoveInside(const TimeSteps& steps, double reach, unsigned int seed);

struct SpaceTimeGrid
{
  std::string Name;
  vtkSmartPointer<vtkDataSet> Data;
};

/// A grid of every type and, of unstructured ones, of every kind of AllMeshKinds() with its cells
/// turned and its points renumbered. All but the image and the rectilinear grid may be moved. The
/// domain of each but honeycomb and Kelvin is a box.
std::vector<SpaceTimeGrid> AllSpaceTimeGrids(const std::array<int, 3>& cells, unsigned int seed);

/// Whether the grid is of tetrahedra only.
bool IsTetrahedral(vtkDataSet* data);

/// Whether the cells fill the box that holds them.
bool HasBoxDomain(vtkDataSet* data);

}

#endif
