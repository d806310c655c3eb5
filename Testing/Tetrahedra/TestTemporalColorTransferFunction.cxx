// SPDX-License-Identifier: BSD-3-Clause
// Tests the nodes for two, three and n steps, errors, and the colors in an image.
#include "Support/Pages/StabilityCase.h"
#include "Support/Drawing/ImageCases.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Tetrahedra/MapperImage.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkTemporalColorTransferFunction.h"
#include "vtkTestErrorObserver.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using namespace reference;

/// A node of the function: time, red, green, blue.
using Node = std::array<double, 4>;

void ExpectNodes(
  Check& check, vtkTemporalColorTransferFunction* function, const std::vector<Node>& expected)
{
  check.Equal(function->GetSize(), static_cast<int>(expected.size()), "number of nodes");
  for (int i = 0; i < std::min(function->GetSize(), static_cast<int>(expected.size())); ++i)
  {
    double node[6];
    function->GetNodeValue(i, node);
    for (int k = 0; k < 4; ++k)
    {
      check.That(node[k] == expected[i][k],
        "value " + std::to_string(k) + " of node " + std::to_string(i) + " is " +
          std::to_string(expected[i][k]) + ", not " + std::to_string(node[k]));
    }
    check.That(node[4] == 0.5 && node[5] == 0.0, "linear interpolation after the node");
  }
}

void TestNodes(Check& check)
{
  vtkNew<vtkTemporalColorTransferFunction> function;
  check.SetContext("two steps");
  function->SetTimes(3.0, 7.0);
  ExpectNodes(check, function,
    { { { 3.0, 0.0, 1.0, 0.0 } }, { { 5.0, 1.0, 1.0, 0.0 } }, { { 7.0, 1.0, 0.0, 0.0 } } });
  check.Equal(function->GetColorSpace(), VTK_CTF_RGB, "color space");

  check.SetContext("three steps");
  const std::array<double, 3> three = { { -2.0, 0.0, 8.0 } };
  function->SetTimes(3, three.data());
  ExpectNodes(check, function,
    { { { -2.0, 0.0, 0.0, 1.0 } }, { { -1.0, 0.0, 1.0, 1.0 } }, { { 0.0, 0.0, 1.0, 0.0 } },
      { { 4.0, 1.0, 1.0, 0.0 } }, { { 8.0, 1.0, 0.0, 0.0 } } });

  // The function's parameter u is 0, 1/3, 2/3 and 1 at the four steps. Therefore, u = 1/4 is at
  // three quarters of the first interval.
  check.SetContext("four steps");
  const std::array<double, 4> four = { { 0.0, 4.0, 6.0, 14.0 } };
  function->SetTimes(4, four.data());
  const double part = 4.0 / 3.0; // 4 u at step 1
  ExpectNodes(check, function,
    { { { 0.0, 0.0, 0.0, 1.0 } }, { { 3.0, 0.0, 1.0, 1.0 } }, { { 4.0, 0.0, 1.0, 2.0 - part } },
      { { 5.0, 0.0, 1.0, 0.0 } }, { { 6.0, 2.0 * part - 2.0, 1.0, 0.0 } },
      { { 8.0, 1.0, 1.0, 0.0 } }, { { 14.0, 1.0, 0.0, 0.0 } } });

  check.SetContext("five steps");
  const std::array<double, 5> five = { { 0.0, 1.0, 10.0, 11.0, 100.0 } };
  function->SetTimes(5, five.data());
  ExpectNodes(check, function,
    { { { 0.0, 0.0, 0.0, 1.0 } }, { { 1.0, 0.0, 1.0, 1.0 } }, { { 10.0, 0.0, 1.0, 0.0 } },
      { { 11.0, 1.0, 1.0, 0.0 } }, { { 100.0, 1.0, 0.0, 0.0 } } });
}

/// Checks that the color depends only on the parameter u, which increases by the same
/// amount in each step, regardless of the times.
void TestManySteps(Check& check)
{
  check.SetContext("many steps");
  for (int n = 3; n <= 40; ++n)
  {
    std::vector<double> times(n);
    for (int i = 0; i < n; ++i)
    {
      times[i] = i * i + std::sin(i);
    }
    vtkNew<vtkTemporalColorTransferFunction> function;
    function->SetTimes(n, times.data());
    for (int sample = 0; sample <= 100 * (n - 1); ++sample)
    {
      const int step = std::min(sample / 100, n - 2);
      const double fraction = sample / 100.0 - step;
      const double u = (step + fraction) / (n - 1);
      double rgb[3];
      function->GetColor(times[step] + fraction * (times[step + 1] - times[step]), rgb);
      const double red = u < 0.5 ? 0.0 : (u > 0.75 ? 1.0 : 4.0 * u - 2.0);
      const double blue = u > 0.5 ? 0.0 : (u < 0.25 ? 1.0 : 2.0 - 4.0 * u);
      const double green = u < 0.25 ? 4.0 * u : (u > 0.75 ? 4.0 - 4.0 * u : 1.0);
      check.Near(rgb[0], red, 1e-12, "red", 1.0);
      check.Near(rgb[1], green, 1e-12, "green", 1.0);
      check.Near(rgb[2], blue, 1e-12, "blue", 1.0);
    }
  }
}

/// Tests extremely short and extremely long intervals between steps.
void TestScales(StabilityCatalogue& catalogue)
{
  for (const double step : { 1e-300, 1e-12, 1e12, 1e307 })
  {
    vtkNew<vtkTemporalColorTransferFunction> function;
    const std::array<double, 3> times = { { -step, 0.0, 8.0 * step } };
    function->SetTimes(3, times.data());
    double rgb[3];
    function->GetColor(6.0 * step, rgb);
    std::ostringstream text;
    text << step;
    catalogue.Measure("steps-" + text.str(), "steps " + text.str() + " apart",
      "error of the color at time 6 of 8",
      std::abs(rgb[0] - 1.0) + std::abs(rgb[1] - 0.5) + std::abs(rgb[2]), 1e-12);
  }
}

void TestErrors(StabilityCatalogue& catalogue)
{
  vtkNew<vtkTemporalColorTransferFunction> function;
  function->SetTimes(0.0, 2.0);
  vtkNew<vtkTest::ErrorObserver> observer;
  function->AddObserver(vtkCommand::ErrorEvent, observer);
  const auto expectError =
    [&](const std::string& name, int number, const double* times, const std::string& reason)
  {
    observer->Clear();
    const vtkMTimeType before = function->GetMTime();
    function->SetTimes(number, times);
    const std::string message = observer->GetErrorMessage();
    catalogue.Check("times-" + name, "times " + name,
      "an error with \"" + reason + "\", and unchanged nodes", message,
      message.find(reason) != std::string::npos && function->GetMTime() == before &&
        function->GetSize() == 3);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const struct
  {
    const char* Name;
    std::vector<double> Times;
    const char* Reason;
  } cases[] = { { "none", {}, "at least two times" }, { "one", { 1.0 }, "at least two times" },
    { "nan", { 1.0, nan }, "not finite" },
    { "minus-infinity", { -infinity, 0.0, 1.0 }, "not finite" },
    { "infinity", { 0.0, 1.0, infinity }, "not finite" },
    { "equal", { 1.0, 1.0 }, "is not greater" }, { "falling", { 0.0, 2.0, 1.0 }, "is not greater" },
    { "equal-within", { 0.0, 1.0, 2.0, 2.0, 3.0 }, "is not greater" },
    { "neighbors", { 1.0, std::nextafter(1.0, 2.0) }, "is not greater" } };
  for (const auto& one : cases)
  {
    expectError(one.Name, static_cast<int>(one.Times.size()), one.Times.data(), one.Reason);
  }
  expectError("null", 2, nullptr, "");
  catalogue.Check("times-null-error", "times null", "an error", observer->GetErrorMessage(),
    observer->GetError());
}

/// Tests that each pixel has the color of its time. The time is constant along each view ray.
void TestVolumeImage(Check& check)
{
  const double extinction = 1.5;
  const std::array<double, 3> times = { { 2.0, 2.5, 4.0 } };
  vtkNew<vtkTemporalColorTransferFunction> function;
  function->SetTimes(3, times.data());
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(times[0], extinction);
  ImageCase what;
  what.Grid = MakeCube(5);
  AddLinearArray(what.Grid, "Time", times[0], { { times[2] - times[0], 0.0, 0.0 } });
  what.Property = MakeProperty({});
  what.Property->SetColor(function);
  what.Property->SetScalarOpacity(opacity);
  what.Camera = LookAt(what.Grid, { { 0.0, 0.0, 1.0 } }, true);
  what.Settings.Size = { { 96, 96 } };
  what.Settings.Arrays.Scalars = "Time";
  const PixelRays rays(what.Camera, what.Settings.Size);
  for (const int path : AllRenderPaths())
  {
    check.SetContext(GetPathName(path));
    const RgbaImage image = DrawByPath(path, what);
    for (int i = 0; i < image.Width; ++i)
    {
      const Ray ray = rays.Get(i, image.Height / 2);
      const auto x = static_cast<double>(ray.Origin[0]);
      if (x < 0.0 || x > 1.0)
      {
        continue;
      }
      const double* pixel = image.At(i, image.Height / 2);
      double rgb[3];
      function->GetColor(times[0] + x * (times[2] - times[0]), rgb);
      for (int k = 0; k < 3; ++k)
      {
        check.Near(
          pixel[k], -std::expm1(-extinction) * rgb[k], 1e-4, "color at the pixel's time", 1.0);
      }
    }
  }
}

}

int TestTemporalColorTransferFunction(int argc, char* argv[])
{
  Check check;
  TestNodes(check);
  TestManySteps(check);
  TestVolumeImage(check);
  StabilityCatalogue catalogue("TestTemporalColorTransferFunction", argc, argv);
  catalogue.SetClass("vtkTemporalColorTransferFunction");
  TestScales(catalogue);
  TestErrors(catalogue);
  return std::max(check.Result(), catalogue.GetExitCode());
}
