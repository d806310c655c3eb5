// SPDX-License-Identifier: BSD-3-Clause
// vtkAreaLight: settings, errors, clones, and the emitter's position in world coordinates.
#include "Support/Checks/ReferenceCheck.h"

#include "vtkAreaLight.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "Common/Vectors.h"

#include <limits>
#include <sstream>

namespace
{

using namespace reference;

const double NotANumber = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

// Collects the error messages that an object reports.
class Errors
{
public:
  explicit Errors(vtkObject* object)
  {
    this->Observer->SetClientData(this);
    this->Observer->SetCallback([](vtkObject*, unsigned long, void* self, void* text)
      { static_cast<Errors*>(self)->Texts += static_cast<const char*>(text); });
    object->AddObserver(vtkCommand::ErrorEvent, this->Observer);
  }
  // Returns true if an error since the last call contains \a text.
  bool Consume(const std::string& text)
  {
    const bool isFound = this->Texts.find(text) != std::string::npos;
    this->Texts.clear();
    return isFound;
  }
  bool IsEmpty() const { return this->Texts.empty(); }

private:
  vtkNew<vtkCallbackCommand> Observer;
  std::string Texts;
};

void CheckSetters(Check& check)
{
  vtkNew<vtkAreaLight> light;
  check.That(light->GetShape() == vtkAreaLight::ROUND && light->GetSize()[0] == 0.25 &&
      light->GetSize()[1] == 0.25 && !light->GetEmitter(),
    "defaults");
  light->SetShapeToSquare();
  light->SetSize(3.0, 0.0);
  light->SetViewUp(0.0, 0.0, 2.0);

  Errors errors(light);
  const vtkMTimeType time = light->GetMTime();
  light->SetSize(-1.0, 1.0);
  check.That(errors.Consume("Size (-1, 1) is out of range"), "a width below 0 is an error");
  light->SetSize(1.0, NotANumber);
  check.That(errors.Consume("is out of range"), "a height of NaN is an error");
  light->SetSize(Infinity, 1.0);
  check.That(errors.Consume("Size (inf"), "an infinite width is an error");
  light->SetViewUp(0.0, NotANumber, 0.0);
  check.That(errors.Consume("ViewUp"), "a ViewUp of NaN is an error");
  light->SetShape(2);
  check.That(errors.Consume("Shape 2"), "an invalid shape is an error");
  light->SetShape(vtkAreaLight::SQUARE);
  light->SetSize(3.0, 0.0);
  light->SetViewUp(0.0, 0.0, 2.0);
  light->SetEmitter(nullptr);
  check.That(light->GetMTime() == time && errors.IsEmpty(), "invalid values change nothing");
  check.That(light->GetShape() == vtkAreaLight::SQUARE && light->GetSize()[0] == 3.0 &&
      light->GetSize()[1] == 0.0 && light->GetViewUp()[2] == 2.0,
    "values are retained");

  vtkNew<vtkImageData> image;
  light->SetEmitter(image);
  const vtkMTimeType withImage = light->GetMTime();
  check.That(withImage > time, "setting an image modifies the light");
  image->Modified();
  check.That(light->GetMTime() > withImage, "modifying the image modifies the light");

  std::ostringstream text;
  light->Print(text);
  for (const char* line : { "Shape: Square", "Size: 3 0", "Emitter: ", "ViewUp: 0 0 2" })
  {
    check.That(text.str().find(line) != std::string::npos, std::string(line) + " is printed");
  }
}

void CheckClones(Check& check)
{
  vtkNew<vtkAreaLight> light;
  vtkNew<vtkImageData> image;
  vtkNew<vtkMatrix4x4> matrix;
  light->SetShapeToSquare();
  light->SetSize(3.0, 4.0);
  light->SetViewUp(1.0, 0.0, 0.0);
  light->SetEmitter(image);
  light->SetPositional(true);
  light->SetPosition(1.0, 2.0, 3.0);
  light->SetIntensity(2.5);
  light->SetShadowAttenuation(0.3f);
  light->SetTransformMatrix(matrix);
  const auto isSame = [&](vtkLight* other)
  {
    auto* area = vtkAreaLight::SafeDownCast(other);
    return area && area->GetShape() == vtkAreaLight::SQUARE && area->GetSize()[0] == 3.0 &&
      area->GetSize()[1] == 4.0 && area->GetViewUp()[0] == 1.0 && area->GetEmitter() == image &&
      area->GetPositional() && area->GetPosition()[2] == 3.0 && area->GetIntensity() == 2.5 &&
      area->GetShadowAttenuation() == 0.3f && area->GetTransformMatrix() == matrix;
  };
  vtkSmartPointer<vtkLight> clone;
  clone.TakeReference(light->ShallowClone());
  check.That(isSame(clone), "a clone has the same values");
  vtkNew<vtkAreaLight> copy;
  copy->DeepCopy(light);
  check.That(isSame(copy), "a copy has the same values");
  vtkNew<vtkLight> plain;
  plain->SetIntensity(7.0);
  copy->DeepCopy(plain);
  check.That(copy->GetIntensity() == 7.0 && copy->GetSize()[0] == 3.0,
    "a copy of a vtkLight retains the emitter");
}

void CheckNear(Check& check, const double* found, const glm::dvec3& expected, const char* what)
{
  check.Near(glm::length(glm::make_vec3(found) - expected), 0.0, 1e-12, what,
    std::max(glm::length(expected), 1.0));
}

// Checks the emitter of a light that points along -z, and after a transform rotates it to -x.
void CheckPositions(Check& check)
{
  vtkNew<vtkAreaLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(1.0, 2.0, 7.0);
  light->SetFocalPoint(1.0, 2.0, -1.0);
  light->SetSize(2.0, 0.5);
  vtkNew<vtkMatrix4x4> rotation;
  const double elements[16] = { 0, 0, 1, 10, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1 };
  rotation->DeepCopy(elements);
  for (const bool isRotated : { false, true })
  {
    check.SetContext(isRotated ? "rotated" : "without transform");
    light->SetTransformMatrix(isRotated ? rotation.GetPointer() : nullptr);
    const glm::dvec3 center = isRotated ? glm::dvec3(17.0, 1.0, 2.0) : glm::dvec3(1.0, 2.0, 7.0);
    const glm::dvec3 normal = isRotated ? glm::dvec3(-1.0, 0.0, 0.0) : glm::dvec3(0.0, 0.0, -1.0);
    const glm::dvec3 right = isRotated ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 up = isRotated ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0);
    double found[3];
    check.That(light->GetCenter(found), "there is a center");
    CheckNear(check, found, center, "center");
    check.That(light->GetNormal(found), "there is a normal");
    CheckNear(check, found, normal, "normal");
    vtkNew<vtkMatrix4x4> matrix;
    check.That(light->GetEmitterMatrix(matrix), "there is a matrix");
    check.Near(matrix->Determinant(), 1.0, 1e-12, "the matrix is a rotation");
    const glm::dvec3 columns[4] = { right, up, -normal, center };
    for (int column = 0; column < 4; ++column)
    {
      const double stored[3] = { matrix->GetElement(0, column), matrix->GetElement(1, column),
        matrix->GetElement(2, column) };
      CheckNear(check, stored, columns[column], "column");
    }
    for (const int shape : { vtkAreaLight::ROUND, vtkAreaLight::SQUARE })
    {
      light->SetShape(shape);
      const std::vector<vtkAreaLight::Sample> samples = light->GetSamples(64);
      check.Equal(static_cast<long long>(samples.size()), 64, "samples");
      double squares[3] = { 0.0, 0.0, 0.0 };
      double weight = 0.0;
      for (const vtkAreaLight::Sample& sample : samples)
      {
        const glm::dvec3 offset = glm::make_vec3(sample.Position) - center;
        squares[0] += glm::dot(offset, right) * glm::dot(offset, right) / 64.0;
        squares[1] += glm::dot(offset, up) * glm::dot(offset, up) / 64.0;
        squares[2] += std::abs(glm::dot(offset, normal));
        weight += sample.Weight[1];
      }
      const double variance = shape == vtkAreaLight::ROUND ? 1.0 / 16.0 : 1.0 / 12.0;
      check.Near(squares[0], 4.0 * variance, 0.01, "variance of the width");
      check.Near(squares[1], 0.25 * variance, 0.01, "variance of the height");
      check.Near(squares[2], 0.0, 1e-12, "the emitter is planar", 1.0);
      check.That(weight == 1.0, "the weights add up to 1");
    }
    const std::vector<vtkAreaLight::Sample> one = light->GetSamples(1);
    check.Equal(static_cast<long long>(one.size()), 1, "one sample");
    CheckNear(check, one[0].Position, center, "the center");
  }
}

void CheckErrors(Check& check)
{
  check.SetContext("errors");
  vtkNew<vtkAreaLight> light;
  vtkNew<vtkMatrix4x4> matrix;
  double point[3];
  light->SetFocalPoint(light->GetPosition());
  check.That(!light->GetEmitterMatrix(matrix) && !light->GetNormal(point) &&
      !light->GetCenter(point) && light->GetSamples(4).empty(),
    "a light without direction has no emitter");
  light->SetFocalPoint(NotANumber, 0.0, 0.0);
  check.That(!light->GetEmitterMatrix(matrix), "a light with a NaN focal point has no emitter");
  light->SetFocalPoint(0.0, 0.0, 0.0);
  check.That(light->GetEmitterError().empty(), "there is no error without an image");
  const auto hasError = [&](vtkImageData* image, const std::string& text)
  {
    light->SetEmitter(image);
    double color[3];
    light->GetEmitterColor(color);
    return light->GetEmitterError().find("the image of its emitter has " + text) == 0 &&
      light->GetSamples(4).empty() && color[0] == 1.0;
  };
  vtkNew<vtkImageData> image;
  check.That(hasError(image, "no samples"), "an image without samples is an error");
  image->SetDimensions(2, 2, 2);
  image->AllocateScalars(VTK_FLOAT, 1);
  check.That(hasError(image, "2 samples along z"), "a three-dimensional image is an error");
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_FLOAT, 5);
  check.That(hasError(image, "5 components"), "an image with five components is an error");
}
}

int TestAreaLight(int, char*[])
{
  Check check;
  CheckSetters(check);
  CheckClones(check);
  CheckPositions(check);
  CheckErrors(check);
  return check.Result();
}
