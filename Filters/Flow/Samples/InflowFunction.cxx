// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/InflowFunction.h"

#include "Common/ArrayCheck.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkExprTkFunctionParser.h"
#include "vtkInflowKind.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace interlume
{

namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

// Indices of the variables of a parser, in the order in which MakeParser() defines them.
enum Variables
{
  VARIABLE_U,
  VARIABLE_V,
  VARIABLE_F,
  VARIABLE_T,
  FIRST_ARRAY_VARIABLE
};

// Returns the variable that replaces array \a i, since the names of arrays may contain spaces or be
// keywords of the parser. A number that follows the last letter does not select another array.
std::string GetVariable(std::size_t i)
{
  return "interlume_array_" + std::to_string(i) + "_x";
}

bool IsLetter(char c)
{
  return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}

// Returns the end of the word, number or quoted text that starts at \a begin, or of any other
// character. A quote without a partner is a character.
std::size_t FindWordEnd(const std::string& text, std::size_t begin)
{
  const auto isDigit = [&text](std::size_t i)
  { return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])); };
  std::size_t end = begin + 1;
  if (text[begin] == '"')
  {
    const std::size_t partner = text.find('"', end);
    return partner == std::string::npos ? end : partner + 1;
  }
  if (IsLetter(text[begin]))
  {
    while (end < text.size() && (IsLetter(text[end]) || isDigit(end)))
    {
      ++end;
    }
  }
  else if (isDigit(begin) || text[begin] == '.')
  {
    while (isDigit(end) || (end < text.size() && text[end] == '.'))
    {
      ++end;
    }
    // An exponent, as in 1e-3.
    const bool hasExponent = end < text.size() && (text[end] == 'e' || text[end] == 'E');
    const std::size_t digits =
      end + 1 + (end + 1 < text.size() && (text[end + 1] == '-' || text[end + 1] == '+') ? 1 : 0);
    if (hasExponent && isDigit(digits))
    {
      end = digits;
      while (isDigit(end))
      {
        ++end;
      }
    }
  }
  return end;
}

// Returns true if a name is a function or a keyword of the parser.
bool IsReserved(const std::string& name)
{
  vtkNew<vtkExprTkFunctionParser> parser;
  vtkNew<vtkCallbackCommand> ignore;
  parser->AddObserver(vtkCommand::ErrorEvent, ignore);
  parser->SetScalarVariableValue(name, 0.0);
  return parser->GetNumberOfScalarVariables() == 0;
}

// Stores the first error message of a parser, without the source location that VTK prepends.
void StoreError(vtkObject*, unsigned long, void* client, void* data)
{
  auto& error = *static_cast<Error*>(client);
  if (error)
  {
    return;
  }
  std::string text = static_cast<const char*>(data);
  const std::size_t start = text.find("Msg: ");
  text.erase(0, start == std::string::npos ? 0 : start + 5);
  error = text.substr(0, text.find_first_of("\t\n"));
}

vtkSmartPointer<vtkExprTkFunctionParser> MakeParser(const std::string& formula, std::size_t arrays)
{
  auto parser = vtkSmartPointer<vtkExprTkFunctionParser>::New();
  parser->SetScalarVariableValue("u", 0.0);
  parser->SetScalarVariableValue("v", 0.0);
  parser->SetScalarVariableValue("f", 0.0);
  parser->SetScalarVariableValue("t", NotANumber);
  for (std::size_t i = 0; i < arrays; ++i)
  {
    parser->SetScalarVariableValue(GetVariable(i), NotANumber);
  }
  parser->ReplaceInvalidValuesOn();
  parser->SetReplacementValue(NotANumber);
  parser->SetFunction(formula.c_str());
  return parser;
}
}

Error InflowFunction::Prepare(const std::set<std::string>& arrays)
{
  Error error;
  switch (this->Kind)
  {
    case vtkInflowKind::FORMULA:
      error = this->ReplaceArrays(arrays);
      error = error ? error : this->CheckFormula();
      break;
    case vtkInflowKind::IMAGE:
      error = this->ReadImage();
      break;
    default:
      break;
  }
  this->CanBeUsed = !error;
  return error;
}

Error InflowFunction::ReplaceArrays(const std::set<std::string>& arrays)
{
  static const std::set<std::string> parameters = { "u", "v", "f", "t" };
  this->Expression.clear();
  this->ContainsTime = false;
  this->Arrays.clear();
  const std::string& text = this->Formula;
  std::size_t at = 0;
  while (at < text.size())
  {
    const std::size_t end = FindWordEnd(text, at);
    const bool isQuoted = text[at] == '"' && end > at + 1;
    const std::string word = text.substr(at, end - at);
    const std::string name = isQuoted ? word.substr(1, word.size() - 2) : word;
    at = end;
    if (isQuoted && arrays.count(name) == 0)
    {
      return "The formula \"" + text + "\" contains \"" + name +
        "\", but the input has no point array with this name and one component.";
    }
    const bool isArray =
      isQuoted || (arrays.count(name) > 0 && parameters.count(name) == 0 && !IsReserved(name));
    if (isArray)
    {
      this->UseArray(name);
    }
    else
    {
      this->ContainsTime = this->ContainsTime || name == "t";
      this->Expression += word;
    }
  }
  return {};
}

void InflowFunction::UseArray(const std::string& name)
{
  const auto found = std::find(this->Arrays.begin(), this->Arrays.end(), name);
  this->Expression += GetVariable(static_cast<std::size_t>(found - this->Arrays.begin()));
  if (found == this->Arrays.end())
  {
    this->Arrays.push_back(name);
  }
}

std::string InflowFunction::RestoreNames(std::string text) const
{
  for (std::size_t i = 0; i < this->Arrays.size(); ++i)
  {
    const std::string variable = GetVariable(i);
    for (std::size_t at = text.find(variable); at != std::string::npos; at = text.find(variable))
    {
      text.replace(at, variable.size(), "\"" + this->Arrays[i] + "\"");
    }
  }
  return text;
}

Error InflowFunction::CheckFormula() const
{
  if (std::all_of(this->Formula.begin(), this->Formula.end(),
        [](unsigned char c) { return std::isspace(c) != 0; }))
  {
    return "The formula is empty. Call SetFormula.";
  }
  const auto parser = MakeParser(this->Expression, this->Arrays.size());
  Error error;
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(StoreError);
  command->SetClientData(&error);
  parser->AddObserver(vtkCommand::ErrorEvent, command);
  const bool isScalar = parser->IsScalarResult();
  const std::string start = "The formula \"" + this->Formula + "\" ";
  if (error)
  {
    return start + "cannot be read: " + this->RestoreNames(error.GetMessage());
  }
  return isScalar ? Error() : start + "is a vector. Use a scalar formula.";
}

Error InflowFunction::ReadImage()
{
  int dimensions[3];
  this->Image->GetDimensions(dimensions);
  vtkDataArray* array = this->Image->GetPointData()->GetScalars();
  if (this->Image->GetNumberOfPoints() < 1)
  {
    return "The image has no points. Pass an image with active point scalars.";
  }
  if (std::count_if(dimensions, dimensions + 3, [](int size) { return size > 1; }) > 2)
  {
    return "The image has " + std::to_string(dimensions[0]) + " x " +
      std::to_string(dimensions[1]) + " x " + std::to_string(dimensions[2]) +
      " points. Use a two-dimensional image.";
  }
  if (Error error = array ? ArrayCheck::FindPointError(this->Image, array, 0)
                          : "the image has no active point scalars")
  {
    return ArrayCheck::MakeSentence(error);
  }
  // The image may lie in any plane; axes with one point are skipped.
  this->Size[0] = dimensions[0] > 1 || dimensions[2] == 1 ? dimensions[0] : dimensions[1];
  this->Size[1] = static_cast<int>(this->Image->GetNumberOfPoints() / this->Size[0]);
  const vtkIdType number = array->GetNumberOfTuples();
  const bool isColor =
    array->GetDataType() == VTK_UNSIGNED_CHAR && array->GetNumberOfComponents() >= 3;
  this->Values.resize(number);
  for (vtkIdType i = 0; i < number; ++i)
  {
    this->Values[i] = isColor ? 0.30 * array->GetComponent(i, 0) +
        0.59 * array->GetComponent(i, 1) + 0.11 * array->GetComponent(i, 2)
                              : array->GetComponent(i, 0);
  }
  return {};
}

InflowEvaluator::InflowEvaluator(const InflowFunction* function)
  : Function(function)
{
  if (function && function->Kind == vtkInflowKind::FORMULA)
  {
    this->Parser = MakeParser(function->Expression, function->Arrays.size());
  }
}

InflowEvaluator::~InflowEvaluator() = default;

void InflowEvaluator::SetSurface(int id, bool isPeriodicU, bool isPeriodicV)
{
  this->IsPeriodic[0] = isPeriodicU;
  this->IsPeriodic[1] = isPeriodicV;
  if (this->Parser)
  {
    this->Parser->SetScalarVariableValue(VARIABLE_F, id);
  }
}

void InflowEvaluator::SetTime(double time)
{
  if (this->Parser)
  {
    this->Parser->SetScalarVariableValue(VARIABLE_T, time);
  }
}

void InflowEvaluator::SetArrayValue(std::size_t i, double value)
{
  this->Parser->SetScalarVariableValue(FIRST_ARRAY_VARIABLE + static_cast<int>(i), value);
}

double InflowEvaluator::Evaluate(double u, double v)
{
  double uv[2] = { u, v };
  for (int direction = 0; direction < 2; ++direction)
  {
    // A parameter of 1 is not wrapped: the mapping may be discontinuous at the seam.
    if (this->IsPeriodic[direction] && !(uv[direction] >= 0.0 && uv[direction] <= 1.0))
    {
      uv[direction] -= std::floor(uv[direction]);
    }
  }
  double value = NotANumber;
  switch (this->Function ? this->Function->Kind : vtkInflowKind::NONE)
  {
    case vtkInflowKind::FORMULA:
      value = this->EvaluateFormula(uv);
      break;
    case vtkInflowKind::RINGS:
      value = this->EvaluateRings(uv);
      break;
    case vtkInflowKind::IMAGE:
      value = this->EvaluateImage(uv);
      break;
    default:
      break;
  }
  return std::isfinite(value) ? value : NotANumber;
}

double InflowEvaluator::EvaluateFormula(const double uv[2])
{
  this->Parser->SetScalarVariableValue(VARIABLE_U, uv[0]);
  this->Parser->SetScalarVariableValue(VARIABLE_V, uv[1]);
  return this->Parser->GetScalarResult();
}

double InflowEvaluator::EvaluateRings(const double uv[2]) const
{
  double sum = 0.0;
  for (const InflowFunction::Ring& ring : this->Function->Rings)
  {
    double offset[2];
    for (int direction = 0; direction < 2; ++direction)
    {
      offset[direction] = uv[direction] - ring.Center[direction];
      offset[direction] -= this->IsPeriodic[direction] ? std::round(offset[direction]) : 0.0;
    }
    const double distance = (std::hypot(offset[0], offset[1]) - ring.Radius) / ring.Width;
    sum += ring.Amplitude * std::exp(-distance * distance);
  }
  return sum;
}

double InflowEvaluator::EvaluateImage(const double uv[2]) const
{
  const int* size = this->Function->Size;
  int first[2];
  int second[2];
  double weight[2];
  for (int direction = 0; direction < 2; ++direction)
  {
    if (!std::isfinite(uv[direction]))
    {
      return NotANumber;
    }
    const double position = std::max(0.0, std::min(uv[direction], 1.0)) * (size[direction] - 1);
    first[direction] = static_cast<int>(position);
    second[direction] = std::min(first[direction] + 1, size[direction] - 1);
    weight[direction] = position - first[direction];
  }
  const auto row = [&](int j)
  {
    const double* values = this->Function->Values.data() + static_cast<std::size_t>(j) * size[0];
    return values[first[0]] + weight[0] * (values[second[0]] - values[first[0]]);
  };
  const double lower = row(first[1]);
  return lower + weight[1] * (row(second[1]) - lower);
}

}
