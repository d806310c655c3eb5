// SPDX-License-Identifier: BSD-3-Clause
// A regular grid yields the same 4-simplices, tetrahedra and boundaries whether it is given as an
// image or as a rectilinear, structured or unstructured grid.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

namespace
{

using namespace reference;

/// The cells of each output, in a form that does not depend on the order of points and cells.
struct Sets
{
  std::vector<GeometricSimplex> Tetrahedra;
  std::vector<GeometricSimplex> Boundaries;
  std::vector<GeometricSimplex> Simplices;
};

Sets SetsOf(const TimeVaryingExtraction& found)
{
  return { GeometricSet(found.Tetrahedra, { "IntervalId", "TimeSlab", "SimplexClass" }, "DeltaT"),
    GeometricSet(found.Boundaries, { "IntervalId", "TimeSlab", "BoundaryKind" }, "Time"),
    GeometricSet(found.Simplices, { "IntervalId", "TimeSlab" }, "Time") };
}

void CheckForms(const std::vector<Interval>& intervals, bool integers, Check& check)
{
  Sets expected;
  for (const DataSetVariant& form : FormsOf(MakeImage({ 4, 3, 3 })))
  {
    check.SetContext(form.Name + (integers ? ", integer values" : ", random values"));
    const TimeSteps steps = RepeatGrid(form.Data, { 0, 0.7, 1.9 });
    integers ? AddIntegerTimeField(steps, 4, 1) : AddRandomTimeField(steps, 1);
    const Sets found = SetsOf(ExtractTimeVarying(steps, { intervals }));
    if (form.Name == "image")
    {
      expected = found;
      check.That(
        !expected.Tetrahedra.empty() && !expected.Boundaries.empty() && !expected.Simplices.empty(),
        "the output is not empty");
    }
    check.That(
      found.Tetrahedra == expected.Tetrahedra, "the tetrahedra equal the tetrahedra of the image");
    check.That(
      found.Boundaries == expected.Boundaries, "the boundaries equal the boundaries of the image");
    check.That(
      found.Simplices == expected.Simplices, "the 4-simplices equal the 4-simplices of the image");
  }
}

}

int TestTimeVaryingGrids(int, char*[])
{
  Check check;
  CheckForms({ { 0.2, 0.4 }, { 0.4, 0.7 }, { 0.65, 2 } }, false, check);
  CheckForms({ { 0, 1 }, { 1, 2 }, { 2.5, 3 } }, true, check);
  return check.Result();
}
