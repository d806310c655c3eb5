// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInflowMapping.h"

#include "Common/AbortCheck.h"
#include "Common/ArrayCheck.h"
#include "Common/Batches.h"
#include "Common/Error.h"
#include "Common/ReportValue.h"
#include "Samples/FarSideSamples.h"
#include "Samples/ImplicitFlowArrays.h"
#include "Samples/InflowFunction.h"
#include "Samples/OutputPiece.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFlowStatus.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

vtkStandardNewMacro(vtkInflowMapping);

namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

// Evaluators of one thread, by mapping.
using EvaluatorMap =
  std::map<const interlume::InflowFunction*, std::shared_ptr<interlume::InflowEvaluator>>;

interlume::InflowEvaluator& GetEvaluator(
  EvaluatorMap& evaluators, const interlume::InflowFunction* function)
{
  auto& evaluator = evaluators[function];
  if (!evaluator)
  {
    evaluator = std::make_shared<interlume::InflowEvaluator>(function);
  }
  return *evaluator;
}

/// Returns the one-component point arrays by name, the first one if several have the same name.
std::map<std::string, vtkDataArray*> FindVariables(vtkDataSet* data)
{
  std::map<std::string, vtkDataArray*> variables;
  vtkPointData* arrays = data->GetPointData();
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    const char* name = arrays->GetArrayName(i);
    vtkDataArray* array = arrays->GetArray(i);
    if (name && array && array->GetNumberOfComponents() == 1)
    {
      variables.emplace(name, array);
    }
  }
  return variables;
}

/// Returns the arrays that a mapping uses.
std::vector<vtkDataArray*> GetVariables(
  const interlume::InflowFunction* function, const std::map<std::string, vtkDataArray*>& variables)
{
  std::vector<vtkDataArray*> used;
  for (std::size_t i = 0; function && i < function->GetArrays().size(); ++i)
  {
    used.push_back(variables.at(function->GetArrays()[i]));
  }
  return used;
}

/// Returns the smallest, the middle and the largest finite value of samples that reached a surface;
/// 0 if there is none.
template <typename GetValue>
std::array<double, 3> GetLevels(
  vtkIdType number, const interlume::ImplicitFlowArrays& arrays, GetValue&& getValue)
{
  double lowest = VTK_DOUBLE_MAX;
  double highest = -VTK_DOUBLE_MAX;
  for (vtkIdType p = 0; p < number; ++p)
  {
    const double value = arrays.IsReached(p) ? getValue(p) : NotANumber;
    if (std::isfinite(value))
    {
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
  }
  return lowest <= highest
    ? std::array<double, 3>{ { lowest, 0.5 * lowest + 0.5 * highest, highest } }
    : std::array<double, 3>{};
}

void SetMappingReport(
  vtkInterlumeReport* report, vtkIdType samples = 0, vtkIdType ids = 0, vtkIdType seams = 0)
{
  interlume::ReportValue::Set(
    report, { { "Samples", samples }, { "Ids", ids }, { "ContinuedSeams", seams } });
}
}

vtkInflowMapping::vtkInflowMapping()
{
  SetMappingReport(this->Report);
  this->SetFormula(ALL, "u");
}

vtkInflowMapping::~vtkInflowMapping() = default;

int vtkInflowMapping::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

interlume::InflowFunction* vtkInflowMapping::GetOrCreate(int id, int kind)
{
  if (id < ALL)
  {
    vtkErrorMacro("Mapping id " << id << " is invalid. Use ALL or a nonnegative id.");
    return nullptr;
  }
  std::shared_ptr<interlume::InflowFunction>& mapping = this->Mappings[id];
  if (!mapping || mapping->Kind != kind)
  {
    mapping = std::make_shared<interlume::InflowFunction>();
    mapping->Kind = kind;
  }
  this->Modified();
  return mapping.get();
}

void vtkInflowMapping::SetFormula(int id, const char* formula)
{
  if (!formula)
  {
    this->RemoveMapping(id);
    return;
  }
  const char* before = this->GetFormula(id);
  if (before && std::string(before) == formula)
  {
    return;
  }
  if (interlume::InflowFunction* mapping = this->GetOrCreate(id, FORMULA))
  {
    mapping->Formula = formula;
  }
}

void vtkInflowMapping::AddRing(
  int id, double centerU, double centerV, double radius, double width, double amplitude)
{
  if (!(width > 0.0) || !std::isfinite(centerU + centerV + radius + width + amplitude))
  {
    vtkErrorMacro("The ring for id "
      << id << " is ignored: center (" << centerU << ", " << centerV << "), radius " << radius
      << ", width " << width << ", amplitude " << amplitude
      << ". All values must be finite, and the width must be greater than 0.");
    return;
  }
  if (interlume::InflowFunction* mapping = this->GetOrCreate(id, RINGS))
  {
    mapping->Rings.push_back({ { centerU, centerV }, radius, width, amplitude });
  }
}

void vtkInflowMapping::SetImage(int id, vtkImageData* image)
{
  if (!image)
  {
    this->RemoveMapping(id);
  }
  else if (this->GetImage(id) != image)
  {
    if (interlume::InflowFunction* mapping = this->GetOrCreate(id, IMAGE))
    {
      mapping->Image = image;
    }
  }
}

void vtkInflowMapping::RemoveMapping(int id)
{
  if (this->Mappings.erase(id) > 0)
  {
    this->Modified();
  }
}

void vtkInflowMapping::RemoveAllMappings()
{
  if (!this->Mappings.empty())
  {
    this->Mappings.clear();
    this->Modified();
  }
}

int vtkInflowMapping::GetKind(int id) const
{
  const auto found = this->Mappings.find(id);
  return found == this->Mappings.end() ? static_cast<int>(NONE) : found->second->Kind;
}

const char* vtkInflowMapping::GetFormula(int id) const
{
  return this->GetKind(id) == FORMULA ? this->Mappings.at(id)->Formula.c_str() : nullptr;
}

int vtkInflowMapping::GetNumberOfRings(int id) const
{
  return this->GetKind(id) == RINGS ? static_cast<int>(this->Mappings.at(id)->Rings.size()) : 0;
}

vtkImageData* vtkInflowMapping::GetImage(int id) const
{
  return this->GetKind(id) == IMAGE ? this->Mappings.at(id)->Image.GetPointer() : nullptr;
}

vtkMTimeType vtkInflowMapping::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (const auto& mapping : this->Mappings)
  {
    if (mapping.second->Image)
    {
      time = std::max(time, mapping.second->Image->GetMTime());
    }
  }
  return time;
}

const interlume::InflowFunction* vtkInflowMapping::Find(int id) const
{
  auto found = this->Mappings.find(id);
  found = found == this->Mappings.end() ? this->Mappings.find(ALL) : found;
  return found == this->Mappings.end() ? nullptr : found->second.get();
}

interlume::Error vtkInflowMapping::Prepare()
{
  if (this->PreparedTime != this->GetMTime())
  {
    this->Evaluators.clear();
    this->PreparedError.clear();
    for (const auto& mapping : this->Mappings)
    {
      const interlume::Error error = mapping.second->Prepare(this->ArrayNames);
      if (error && this->PreparedError.empty())
      {
        this->PreparedError = "The mapping of " +
          (mapping.first == ALL ? std::string("all ids") : "id " + std::to_string(mapping.first)) +
          " cannot be used. " + error.GetMessage();
      }
    }
    this->PreparedTime = this->GetMTime();
  }
  return this->PreparedError;
}

double vtkInflowMapping::Evaluate(
  int id, double u, double v, bool isPeriodicU, bool isPeriodicV, double time)
{
  // An error of another id does not matter.
  static_cast<void>(this->Prepare());
  const interlume::InflowFunction* function = this->Find(id);
  if (function && !function->IsUsable())
  {
    return NotANumber;
  }
  interlume::InflowEvaluator& evaluator = GetEvaluator(this->Evaluators, function);
  evaluator.SetSurface(id, isPeriodicU, isPeriodicV);
  evaluator.SetTime(time);
  return evaluator.Evaluate(u, v);
}

bool vtkInflowMapping::IsContinued(int id, int direction, bool isPeriodicU, bool isPeriodicV)
{
  constexpr int positions = 33;
  constexpr double tolerance = 1e-6;
  // An error of another id does not matter.
  static_cast<void>(this->Prepare());
  const interlume::InflowFunction* function = this->Find(id);
  if (!(direction == 0 ? isPeriodicU : isPeriodicV) || (function && !function->IsUsable()))
  {
    return false;
  }
  interlume::InflowEvaluator evaluator(function);
  evaluator.SetSurface(id, isPeriodicU, isPeriodicV);
  const bool isOfPosition = !function || (!function->HasTime() && function->GetArrays().empty());
  const int levels = isOfPosition ? 1 : 3;
  // The first and the last value of each row are at the same point, on opposite sides of the seam.
  double lowest = VTK_DOUBLE_MAX;
  double highest = -VTK_DOUBLE_MAX;
  double largestJump = 0.0;
  for (int i = 0; i < positions * levels; ++i)
  {
    this->SetLevel(evaluator, function, static_cast<std::size_t>(i / positions));
    const double along = static_cast<double>(i % positions) / (positions - 1);
    double values[positions];
    for (int j = 0; j < positions; ++j)
    {
      const double across = static_cast<double>(j) / (positions - 1);
      values[j] =
        direction == 0 ? evaluator.Evaluate(across, along) : evaluator.Evaluate(along, across);
      if (std::isfinite(values[j]))
      {
        lowest = std::min(lowest, values[j]);
        highest = std::max(highest, values[j]);
      }
    }
    const bool isFinite = std::isfinite(values[0]);
    if (isFinite != std::isfinite(values[positions - 1]))
    {
      return false;
    }
    largestJump =
      isFinite ? std::max(largestJump, std::abs(values[positions - 1] - values[0])) : largestJump;
  }
  return largestJump <= tolerance * std::max(highest - lowest, 0.0);
}

void vtkInflowMapping::SetLevel(interlume::InflowEvaluator& evaluator,
  const interlume::InflowFunction* function, std::size_t level) const
{
  const double unknown = 0.5 * static_cast<double>(level);
  evaluator.SetTime(this->Times ? (*this->Times)[level] : unknown);
  for (std::size_t i = 0; function && i < function->GetArrays().size(); ++i)
  {
    const auto found = this->ArrayLevels.find(function->GetArrays()[i]);
    evaluator.SetArrayValue(i, found == this->ArrayLevels.end() ? unknown : found->second[level]);
  }
}

interlume::Error vtkInflowMapping::UseArrays(
  const interlume::ImplicitFlowArrays& arrays, vtkDataSet* input)
{
  const std::map<std::string, vtkDataArray*> variables = FindVariables(input);
  std::set<std::string> names;
  for (const auto& variable : variables)
  {
    names.insert(variable.first);
  }
  if (names != this->ArrayNames)
  {
    this->ArrayNames = names;
    this->PreparedTime = 0;
  }
  if (interlume::Error error = this->Prepare())
  {
    return error;
  }
  this->Times.reset();
  this->ArrayLevels.clear();
  const vtkIdType number = input->GetNumberOfPoints();
  for (const auto& mapping : this->Mappings)
  {
    if (mapping.second->HasTime())
    {
      if (!arrays.HasTimes())
      {
        return "The formula \"" + mapping.second->Formula +
          "\" contains t, but the input has no point array \"" + vtkFlowStatus::TimeArray() +
          "\". Pass the output of vtkImplicitFlowField.";
      }
      this->Times = GetLevels(number, arrays, [&](vtkIdType p) { return arrays.GetTime(p); });
    }
    for (const std::string& name : mapping.second->GetArrays())
    {
      vtkDataArray* array = variables.at(name);
      if (const interlume::Error error = interlume::ArrayCheck::FindPointError(input, array, 1))
      {
        return interlume::ArrayCheck::MakeSentence(error);
      }
      this->ArrayLevels[name] =
        GetLevels(number, arrays, [array](vtkIdType p) { return array->GetComponent(p, 0); });
    }
  }
  return {};
}

bool vtkInflowMapping::MapSamples(
  const interlume::ImplicitFlowArrays& arrays, vtkDataSet* input, double* values)
{
  const std::map<std::string, vtkDataArray*> arraysByName = FindVariables(input);
  vtkSMPThreadLocal<EvaluatorMap> threads;
  const auto map = [&](vtkIdType first, vtkIdType last)
  {
    EvaluatorMap& evaluators = threads.Local();
    interlume::InflowEvaluator* evaluator = nullptr;
    std::vector<vtkDataArray*> variables;
    bool hasTime = false;
    int id = ALL;
    for (vtkIdType p = first; p < last; ++p)
    {
      if (!arrays.IsReached(p))
      {
        values[p] = NotANumber;
        continue;
      }
      if (!evaluator || id != arrays.GetId(p))
      {
        id = arrays.GetId(p);
        const interlume::InflowFunction* function = this->Find(id);
        evaluator = &GetEvaluator(evaluators, function);
        variables = GetVariables(function, arraysByName);
        hasTime = function && function->HasTime();
        const std::array<bool, 2> periodicity = arrays.GetPeriodicity(id);
        evaluator->SetSurface(id, periodicity[0], periodicity[1]);
      }
      if (hasTime)
      {
        evaluator->SetTime(arrays.GetTime(p));
      }
      for (std::size_t i = 0; i < variables.size(); ++i)
      {
        evaluator->SetArrayValue(i, variables[i]->GetComponent(p, 0));
      }
      const double* uv = arrays.GetParameters(p);
      values[p] = evaluator->Evaluate(uv[0], uv[1]);
    }
  };
  return interlume::Batches::Run(input->GetNumberOfPoints(), this, 0.0, 1.0, map);
}

int vtkInflowMapping::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataSet* input = vtkDataSet::GetData(inputs[0]);
  vtkDataSet* output = vtkDataSet::GetData(outputs);
  // Otherwise, image data would keep the active scalars of the previous execution.
  output->Initialize();
  SetMappingReport(this->Report);
  interlume::ImplicitFlowArrays arrays;
  if (const interlume::Error error =
        arrays.Find(input).Then([&] { return this->UseArrays(arrays, input); }))
  {
    vtkErrorMacro(<< error);
    return 1;
  }
  const vtkIdType number = input->GetNumberOfPoints();
  this->SetProgressText("Mapping samples to the inflow");
  vtkNew<vtkDoubleArray> inflow;
  inflow->SetName(vtkFlowStatus::InflowArray());
  inflow->SetNumberOfValues(number);
  if (!this->MapSamples(arrays, input, inflow->GetPointer(0)))
  {
    return interlume::AbortCheck::Leave(outputs);
  }
  vtkNew<vtkIntArray> periodic;
  periodic->SetName(vtkFlowStatus::InflowPeriodicArray());
  periodic->SetNumberOfComponents(3);
  vtkIdType continuedSeams = 0;
  for (const auto& surface : arrays.GetSurfaces())
  {
    const bool isU = surface.second[0];
    const bool isV = surface.second[1];
    const int tuple[3] = { surface.first, this->IsContinued(surface.first, 0, isU, isV),
      this->IsContinued(surface.first, 1, isU, isV) };
    periodic->InsertNextTypedTuple(tuple);
    continuedSeams += tuple[1] + tuple[2];
  }
  SetMappingReport(this->Report, number, periodic->GetNumberOfTuples(), continuedSeams);
  output->ShallowCopy(input);
  output->GetPointData()->AddArray(inflow);
  output->GetPointData()->SetActiveScalars(vtkFlowStatus::InflowArray());
  output->GetFieldData()->AddArray(periodic);
  this->MapFarSide(arrays, output);
  if (interlume::OutputPiece::IsEntireOutput(outputs->GetInformationObject(0)))
  {
    this->WarnIfUndefined(arrays, number, inflow->GetPointer(0));
  }
  return 1;
}

void vtkInflowMapping::WarnIfUndefined(
  const interlume::ImplicitFlowArrays& arrays, vtkIdType number, const double* values)
{
  if (number == 0 || std::any_of(values, values + number, [](double v) { return !std::isnan(v); }))
  {
    return;
  }
  vtkIdType reached = 0;
  for (vtkIdType p = 0; p < number; ++p)
  {
    reached += arrays.IsReached(p) ? 1 : 0;
  }
  vtkWarningMacro("Inflow is NaN at all "
    << number << " samples: " << reached << " of them reached a termination surface"
    << (reached > 0 ? ", but the mapping has no finite value there." : "."));
}

void vtkInflowMapping::MapFarSide(const interlume::ImplicitFlowArrays& arrays, vtkDataSet* output)
{
  vtkFieldData* data = output->GetFieldData();
  const auto get = [data](const char* name)
  { return data->GetArray(interlume::FarSideSamples::GetName(name).c_str()); };
  vtkDataArray* ids = get(vtkFlowStatus::IdArray());
  vtkDataArray* parameters = get(vtkFlowStatus::ParametersArray());
  vtkDataArray* times = get(vtkFlowStatus::TimeArray());
  const interlume::FarSideSamples samples(output);
  if (samples.IsEmpty())
  {
    return;
  }
  vtkNew<vtkDoubleArray> inflow;
  inflow->SetName(interlume::FarSideSamples::GetName(vtkFlowStatus::InflowArray()).c_str());
  inflow->SetNumberOfValues(ids->GetNumberOfTuples());
  const std::map<std::string, vtkDataArray*> arraysByName = FindVariables(output);
  EvaluatorMap evaluators;
  for (vtkIdType row = 0; row < ids->GetNumberOfTuples(); ++row)
  {
    const int id = static_cast<int>(ids->GetComponent(row, 0));
    const interlume::InflowFunction* function = this->Find(id);
    interlume::InflowEvaluator& evaluator = GetEvaluator(evaluators, function);
    const std::array<bool, 2> periodicity = arrays.GetPeriodicity(id);
    evaluator.SetSurface(id, periodicity[0], periodicity[1]);
    evaluator.SetTime(times->GetComponent(row, 0));
    const std::vector<vtkDataArray*> variables = GetVariables(function, arraysByName);
    for (std::size_t i = 0; i < variables.size(); ++i)
    {
      // Quantities along the path have far-side values, all others are the sample's own.
      vtkDataArray* farSide = get(variables[i]->GetName());
      const bool isComplete = farSide && farSide->GetNumberOfComponents() == 1 &&
        farSide->GetNumberOfTuples() == ids->GetNumberOfTuples();
      evaluator.SetArrayValue(i,
        isComplete ? farSide->GetComponent(row, 0)
                   : variables[i]->GetComponent(samples.GetPoint(row), 0));
    }
    inflow->SetValue(row,
      id < 0
        ? NotANumber
        : evaluator.Evaluate(parameters->GetComponent(row, 0), parameters->GetComponent(row, 1)));
  }
  data->AddArray(inflow);
}

void vtkInflowMapping::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mappings: " << this->Mappings.size() << "\n";
  for (const auto& mapping : this->Mappings)
  {
    os << indent.GetNextIndent();
    if (mapping.first == ALL)
    {
      os << "all";
    }
    else
    {
      os << mapping.first;
    }
    switch (mapping.second->Kind)
    {
      case FORMULA:
        os << ": formula " << mapping.second->Formula << "\n";
        break;
      case RINGS:
        os << ": rings " << mapping.second->Rings.size() << "\n";
        break;
      default:
        os << ": image\n";
    }
  }
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}
