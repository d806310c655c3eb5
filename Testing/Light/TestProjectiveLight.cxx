// SPDX-License-Identifier: BSD-3-Clause
// A projective light: settings, the mapping to its screen, and the screen's colors.
#include "Support/Checks/ReferenceCheck.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkProjectiveLight.h"
#include "Space/UnitVector.h"

#include <limits>
#include <sstream>

namespace
{

using namespace reference;
using namespace interlume::UnitVector;

const double NotANumber = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

void CheckSetters(Check& check)
{
  vtkNew<vtkProjectiveLight> light;
  light->SetScreenSize(-1.0, Infinity);
  check.Near(light->GetScreenSize()[0], 1e-30, 1e-12, "a width below 0");
  check.Near(light->GetScreenSize()[1], 1e30, 1e-12, "an infinite height");
  light->SetScreenSize(3.0, 4.0);
  light->SetEdgeWidth(2.0);
  check.Near(light->GetEdgeWidth(), 1.0, 0.0, "an edge above 1");
  light->SetEdgeWidth(-1.0);
  check.Near(light->GetEdgeWidth(), 0.0, 0.0, "an edge below 0");
  light->SetEdgeWidth(0.25);
  light->SetScreenOpacity(-Infinity);
  check.Near(light->GetScreenOpacity(), 0.0, 0.0, "an opacity below 0");
  light->SetScreenOpacity(7.0);
  check.Near(light->GetScreenOpacity(), 1.0, 0.0, "an opacity above 1");
  light->SetScreenOpacity(0.5);
  light->SetViewUp(0.0, 0.0, 2.0);

  const vtkMTimeType time = light->GetMTime();
  light->SetScreenSize(NotANumber, 1.0);
  light->SetScreenSize(1.0, NotANumber);
  light->SetEdgeWidth(NotANumber);
  light->SetScreenOpacity(NotANumber);
  light->SetViewUp(NotANumber, 0.0, 0.0);
  light->SetScreenSize(3.0, 4.0);
  light->SetEdgeWidth(0.25);
  light->SetScreenOpacity(0.5);
  light->SetViewUp(0.0, 0.0, 2.0);
  light->SetImage(nullptr);
  check.That(light->GetMTime() == time, "NaN and the same values change nothing");
  check.That(light->GetScreenSize()[0] == 3.0 && light->GetScreenSize()[1] == 4.0 &&
      light->GetEdgeWidth() == 0.25 && light->GetScreenOpacity() == 0.5 &&
      light->GetViewUp()[2] == 2.0,
    "values are retained");

  vtkNew<vtkImageData> image;
  light->SetImage(image);
  const vtkMTimeType withImage = light->GetMTime();
  check.That(withImage > time, "setting an image modifies the light");
  image->Modified();
  check.That(light->GetMTime() > withImage, "modifying the image modifies the light");

  light->SetPositional(true);
  light->SetPosition(1.0, 2.0, 3.0);
  light->SetInterpolate(false);
  light->SetShadowAttenuation(0.3f);
  vtkNew<vtkMatrix4x4> matrix;
  light->SetTransformMatrix(matrix);
  vtkSmartPointer<vtkLight> copy;
  copy.TakeReference(light->ShallowClone());
  auto* clone = vtkProjectiveLight::SafeDownCast(copy);
  check.That(clone && clone->GetImage() == image && !clone->GetInterpolate() &&
      clone->GetScreenSize()[1] == 4.0 && clone->GetViewUp()[2] == 2.0 &&
      clone->GetEdgeWidth() == 0.25 && clone->GetScreenOpacity() == 0.5 && clone->GetPositional() &&
      clone->GetPosition()[2] == 3.0 && clone->GetShadowAttenuation() == 0.3f &&
      clone->GetTransformMatrix(),
    "a clone has the same values");
  std::ostringstream text;
  light->Print(text);
  for (const char* name :
    { "Image", "Interpolate", "ScreenSize", "ViewUp", "EdgeWidth", "ScreenOpacity" })
  {
    check.That(text.str().find(name) != std::string::npos, std::string(name) + " is printed");
  }
}

std::array<double, 4> Project(vtkMatrix4x4* matrix, const glm::dvec3& point)
{
  const double from[4] = { point[0], point[1], point[2], 1.0 };
  std::array<double, 4> to;
  matrix->MultiplyPoint(from, to.data());
  return to;
}

// Checks that all points on a ray of the light are projected to the same position on the screen.
// Rays start at the light's position or are parallel to its axis.
void CheckMatrix(Check& check, vtkProjectiveLight* light, const glm::dvec3& position,
  const glm::dvec3& focalPoint, const glm::dvec3& up, double scale)
{
  vtkNew<vtkMatrix4x4> matrix;
  check.That(light->GetScreenMatrix(matrix), "there is a matrix");
  check.That(std::abs(matrix->Determinant()) > 0.0, "the matrix is regular");
  const glm::dvec3 axis = Normalize(focalPoint - position, {});
  const glm::dvec3 right = glm::cross(axis, up);
  for (const double u : { 0.0, 0.5, 0.8, 1.3 })
  {
    for (const double v : { 0.0, 0.5, 0.9, -0.2 })
    {
      const glm::dvec3 across = (scale * light->GetScreenSize()[0] * (u - 0.5)) * right +
        (scale * light->GetScreenSize()[1] * (v - 0.5)) * up;
      for (const double depth : { 0.1, 1.0, 5.0 })
      {
        const glm::dvec3 center = (1.0 - depth) * position + depth * focalPoint;
        const glm::dvec3 point = center + (light->GetPositional() ? depth : 1.0) * across;
        const std::array<double, 4> to = Project(matrix, point);
        check.That(to[3] > 0.0, "w is positive in front");
        check.Near(to[0] / to[3], u, 1e-11, "u", 1.0);
        check.Near(to[1] / to[3], v, 1e-11, "v", 1.0);
      }
    }
  }
  const glm::dvec3 behind = 2.0 * position - focalPoint;
  const double w = Project(matrix, behind)[3];
  check.That(light->GetPositional() ? w < 0.0 : w == 1.0, "w behind the light");
}

void CheckMatrices(Check& check)
{
  for (const bool isPositional : { false, true })
  {
    check.SetContext(isPositional ? "positional" : "parallel");
    vtkNew<vtkProjectiveLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPositional(isPositional);
    light->SetScreenSize(2.0, 0.5);
    const glm::dvec3 position{ 1.0, 2.0, 3.0 };
    light->SetPosition(1.0, 2.0, 3.0);
    light->SetFocalPoint(1.0, 2.0, -1.0);
    const glm::dvec3 focalPoint{ 1.0, 2.0, -1.0 };
    CheckMatrix(check, light, position, focalPoint, glm::dvec3(0.0, 1.0, 0.0), 1.0);
    light->SetViewUp(1.0, 1.0, 5.0);
    const double half = std::sqrt(0.5);
    CheckMatrix(check, light, position, focalPoint, glm::dvec3(half, half, 0.0), 1.0);
    light->SetViewUp(0.0, 0.0, 3.0);
    CheckMatrix(check, light, position, focalPoint, glm::dvec3(1.0, 0.0, 0.0), 1.0);
    light->SetViewUp(0.0, 0.0, 0.0);
    CheckMatrix(check, light, position, focalPoint, glm::dvec3(0.0, 1.0, 0.0), 1.0);

    // The transform rotates the z-axis to the x-axis, and the up direction with it.
    vtkNew<vtkMatrix4x4> rotation;
    const double elements[16] = { 0, 0, 1, 10, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1 };
    rotation->DeepCopy(elements);
    light->SetTransformMatrix(rotation);
    light->SetViewUp(0.0, 1.0, 0.0);
    CheckMatrix(check, light, glm::dvec3(13.0, 1.0, 2.0), glm::dvec3(9.0, 1.0, 2.0),
      glm::dvec3(0.0, 0.0, 1.0), 1.0);
    light->SetTransformMatrix(nullptr);

    for (const double scale : { 1e-9, 1e9 })
    {
      light->SetScreenSize(2.0 * scale, 0.5 * scale);
      light->SetPosition(scale, 2.0 * scale, 3.0 * scale);
      light->SetFocalPoint(scale, 2.0 * scale, -1.0 * scale);
      CheckMatrix(
        check, light, scale * position, scale * focalPoint, glm::dvec3(0.0, 1.0, 0.0), 1.0);
    }

    vtkNew<vtkMatrix4x4> matrix;
    light->SetFocalPoint(light->GetPosition());
    check.That(!light->GetScreenMatrix(matrix), "a light without direction has no matrix");
    light->SetFocalPoint(NotANumber, 0.0, 0.0);
    check.That(!light->GetScreenMatrix(matrix), "a light with a NaN focal point has no matrix");
  }
}

vtkSmartPointer<vtkImageData> MakeImage(int type, int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(4, 6, -1, 0, 7, 7);
  image->AllocateScalars(type, components);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const double largest = type == VTK_UNSIGNED_CHAR ? 255.0 : 1.0;
  for (vtkIdType i = 0; i < 6; ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      scalars->SetComponent(i, c, largest * static_cast<double>((5 * i + 3 * c) % 6) / 5.0);
    }
  }
  return image;
}

// Returns sample (i,j) of the image, clamped to the edge and multiplied by the opacity.
double GetSample(int i, int j, int channel, int components)
{
  const int index = 3 * std::min(std::max(j, 0), 1) + std::min(std::max(i, 0), 2);
  const auto value = [&](int c) { return ((5 * index + 3 * c) % 6) / 5.0; };
  const double opacity = components == 2 || components == 4 ? value(components - 1) : 1.0;
  return opacity * value(components > 2 ? channel : 0);
}

double Smooth(double position, double width)
{
  const double distance = std::min(position, 1.0 - position) / (0.5 * width);
  return distance < 1.0 ? 3.0 * distance * distance - 2.0 * std::pow(distance, 3) : 1.0;
}

void CheckColors(Check& check)
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_FLOAT, VTK_DOUBLE })
  {
    for (int components = 1; components <= 4; ++components)
    {
      check.SetContext(
        "type " + std::to_string(type) + ", components " + std::to_string(components));
      vtkNew<vtkProjectiveLight> light;
      const vtkSmartPointer<vtkImageData> image = MakeImage(type, components);
      light->SetImage(image);
      light->SetScreenOpacity(0.75);
      light->SetEdgeWidth(0.4);
      check.That(light->GetImageError().empty(), "no error");
      const std::vector<float> texels = light->GetTexels();
      check.Equal(static_cast<long long>(texels.size()), 18, "texels");
      for (int i = 0; i < 18 && texels.size() == 18; ++i)
      {
        check.Near(texels[static_cast<std::size_t>(i)],
          GetSample(i / 3 % 3, i / 9, i % 3, components), 1e-6, "texel", 1.0);
      }
      for (int sample = 0; sample < 441; ++sample)
      {
        const int row = sample / 21;
        const double u = sample % 21 / 20.0;
        const double v = row / 20.0;
        for (const bool isNearest : { false, true })
        {
          light->SetInterpolate(!isNearest);
          double color[3];
          light->GetScreenColor(u, v, color);
          const double x = 3.0 * u - 0.5;
          const double y = 2.0 * v - 0.5;
          const int i = static_cast<int>(std::floor(x));
          const int j = static_cast<int>(std::floor(y));
          for (int c = 0; c < 3; ++c)
          {
            const auto get = [&](int a, int b) { return GetSample(a, b, c, components); };
            const double bottom = (i + 1 - x) * get(i, j) + (x - i) * get(i + 1, j);
            const double top = (i + 1 - x) * get(i, j + 1) + (x - i) * get(i + 1, j + 1);
            const double nearest =
              get(static_cast<int>(std::floor(3.0 * u)), static_cast<int>(std::floor(2.0 * v)));
            const double expected = isNearest ? nearest : (j + 1 - y) * bottom + (y - j) * top;
            check.Near(
              color[c], 0.75 * Smooth(u, 0.4) * Smooth(v, 0.4) * expected, 1e-6, "color", 1.0);
          }
        }
      }
    }
  }
}

void CheckWindow(Check& check)
{
  check.SetContext("");
  vtkNew<vtkProjectiveLight> light;
  double color[3];
  const auto get = [&](double u, double v)
  {
    light->GetScreenColor(u, v, color);
    return color[0];
  };
  check.Near(get(0.0, 1.0), 1.0, 0.0, "a screen without image, including its edge");
  check.Near(get(0.3, 0.2), 1.0, 0.0, "a screen without image");
  check.That(
    get(-1e-9, 0.5) == 0.0 && get(0.5, 1.1) == 0.0 && get(NotANumber, 0.5) == 0.0, "black outside");
  light->SetEdgeWidth(1.0);
  check.Near(get(0.25, 0.5), 0.5, 1e-15, "a quarter of the screen");
  check.Near(get(0.25, 0.75), 0.25, 1e-15, "a quarter along both axes");
  check.Near(get(0.5, 0.5), 1.0, 1e-15, "the center");
  light->SetEdgeWidth(0.5);
  check.Near(get(0.0625, 0.5), 10.0 / 64.0, 1e-15, "a quarter of the edge");
  check.That(light->GetTexels().empty() && light->GetImageError().empty(),
    "a screen without image has no texels");
}

void CheckErrors(Check& check)
{
  vtkNew<vtkProjectiveLight> light;
  const auto hasError = [&](vtkImageData* image)
  {
    light->SetImage(image);
    double color[3];
    light->GetScreenColor(0.5, 0.5, color);
    const bool isBlack = color[0] == 0.0 && light->GetTexels().empty();
    return !light->GetImageError().empty() && isBlack;
  };
  vtkNew<vtkImageData> image;
  check.That(hasError(image), "an image without samples is an error");
  image->SetDimensions(2, 2, 1);
  check.That(hasError(image), "an image without scalars is an error");
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 5);
  check.That(hasError(image), "five components are an error");
  image->SetDimensions(2, 2, 2);
  image->AllocateScalars(VTK_FLOAT, 1);
  check.That(hasError(image), "a three-dimensional image is an error");
  image->SetDimensions(1, 1, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  image->GetPointData()->GetScalars()->SetComponent(0, 0, NotANumber);
  light->SetImage(image);
  double color[3];
  light->GetScreenColor(0.5, 0.5, color);
  check.That(light->GetImageError().empty() && color[0] == 0.0, "NaN is black");
  image->GetPointData()->GetScalars()->SetComponent(0, 0, 7.0);
  light->GetScreenColor(0.1, 0.9, color);
  check.That(color[2] == 1.0, "one sample is clamped");
}

void CheckTypes(Check& check)
{
  struct Case
  {
    int Type;
    double Value;
    double Expected;
  };
  const Case cases[] = { { VTK_UNSIGNED_CHAR, 51.0, 0.2 }, { VTK_CHAR, 127.0, 1.0 },
    { VTK_SIGNED_CHAR, -5.0, 0.0 }, { VTK_UNSIGNED_SHORT, 13107.0, 0.2 },
    { VTK_SHORT, -100.0, 0.0 }, { VTK_SHORT, 16383.5 * 2.0, 1.0 },
    { VTK_UNSIGNED_INT, 4294967295.0 / 5.0, 0.2 }, { VTK_LONG_LONG, 0.0, 0.0 },
    { VTK_FLOAT, 0.25, 0.25 }, { VTK_FLOAT, 300.0, 1.0 }, { VTK_DOUBLE, -1.0, 0.0 } };
  for (const Case& one : cases)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(1, 1, 1);
    image->AllocateScalars(one.Type, 1);
    image->GetPointData()->GetScalars()->SetComponent(0, 0, one.Value);
    vtkNew<vtkProjectiveLight> light;
    light->SetImage(image);
    double color[3];
    light->GetScreenColor(0.5, 0.5, color);
    const std::string name =
      std::string(image->GetScalarTypeAsString()) + " " + std::to_string(one.Value);
    check.Near(color[1], one.Expected, 1e-12, name);
    check.That(light->GetImageError().empty(), name + " is no error");
  }
  vtkNew<vtkImageData> bits;
  bits->SetDimensions(1, 1, 1);
  bits->AllocateScalars(VTK_BIT, 1);
  vtkNew<vtkProjectiveLight> light;
  light->SetImage(bits);
  check.That(light->GetImageError().find("of type bit") != std::string::npos, "bits are an error");
}
}

int TestProjectiveLight(int, char*[])
{
  Check check;
  CheckSetters(check);
  CheckMatrices(check);
  CheckColors(check);
  CheckWindow(check);
  CheckErrors(check);
  CheckTypes(check);
  return check.Result();
}
