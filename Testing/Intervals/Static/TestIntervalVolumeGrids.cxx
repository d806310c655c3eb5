// SPDX-License-Identifier: BSD-3-Clause
// A regular grid yields bit-identical simplices whether it is given as an image or as a
// rectilinear, structured or unstructured grid.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceLattice.h"

#include "vtkImageData.h"
#include "vtkUnstructuredGrid.h"

namespace
{

using namespace reference;

void CheckForms(vtkImageData* image, const std::vector<Interval>& intervals,
  const std::vector<double>& values, const std::string& name, Check& check)
{
  std::vector<GeometricSimplex> volume;
  std::vector<GeometricSimplex> surface;
  std::vector<GeometricSimplex> contour;
  for (const DataSetVariant& form : FormsOf(image))
  {
    check.SetContext(form.Name + ", " + name);
    const Extraction extraction = ExtractIntervals(form.Data, intervals);
    const auto tetrahedra = GeometricSet(extraction.Volume, { "IntervalId" });
    const auto triangles = GeometricSet(extraction.Surface, { "IntervalId", "BoundarySide" });
    const auto contours = GeometricSet(ExtractContours(form.Data, values).Surface, { "ContourId" });
    if (form.Name == "image")
    {
      volume = tetrahedra;
      surface = triangles;
      contour = contours;
      check.That(
        !volume.empty() && !surface.empty() && !contour.empty(), "the output is not empty");
    }
    check.That(tetrahedra == volume, "the tetrahedra equal the tetrahedra of the image");
    check.That(triangles == surface, "the boundary triangles equal the triangles of the image");
    check.That(contours == contour, "the contour triangles equal the triangles of the image");
  }
}

}

int TestIntervalVolumeGrids(int, char*[])
{
  Check check;
  auto image = MakeImage({ 6, 5, 7 });
  auto shifted = MakeImage({ 6, 5, 7 });
  shifted->SetExtent(-3, 3, 2, 7, 10, 17);
  auto turned = MakeImage({ 6, 5, 7 });
  turned->SetDirectionMatrix(0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6);
  const DataSetVariant images[] = { { "image", image }, { "shifted", shifted },
    { "turned", turned } };
  for (const DataSetVariant& one : images)
  {
    auto* data = vtkImageData::SafeDownCast(one.Data);
    AddRandomField(data, 1);
    CheckForms(data, { { 0.2, 0.4 }, { 0.4, 0.7 }, { 0.65, 2 } }, { 0.3, 0.8 },
      one.Name + ", random values", check);
    AddIntegerField(data, 4, 1);
    CheckForms(data, { { 0, 1 }, { 1, 2 }, { 2.5, 3 } }, { 1, 1.5, 3 },
      one.Name + ", integer values", check);
    // Tests rows of cells that are all inside an interval.
    const double* center = data->GetCenter();
    AddLinearField(
      data, { 0.55 - 0.01 * center[0] - 0.02 * center[1] - 0.2 * center[2], { 0.01, 0.02, 0.2 } });
    CheckForms(
      data, { { 0.2, 0.5 }, { 0.5, 0.9 } }, { 0.3, 0.8 }, one.Name + ", rows inside", check);
  }
  return check.Result();
}
