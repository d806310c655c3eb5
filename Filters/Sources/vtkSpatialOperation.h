// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSpatialOperation_h
#define vtkSpatialOperation_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkSpatialObject.h"

#include <vector> // for the operands

/**
 * @class   vtkSpatialOperation
 * @brief   combine spatial objects: union, intersection, difference, blend, cap or trim
 *
 * The operations are from constructive volume geometry (M. Chen and J. V. Tucker, Computer Graphics
 * Forum 19(4), 2000). Operands with densities a, b and colors A, B have the following density and
 * color:
 * - UNION: max(a, b); A if a >= b, otherwise B;
 * - INTERSECTION: min(a, b); A if a >= b, otherwise B;
 * - DIFFERENCE: max(0, a - b); A;
 * - BLEND: min(1, a + b); (a A + b B) / (a + b);
 * - CAP: a if b < a, otherwise 0; A. A solid b removes its interior from a;
 * - TRIM: a if b >= a, otherwise 0; A. A solid b removes its exterior from a.
 *
 * Cap and trim divide a into two parts without changing its density. More than two operands are
 * combined from left to right. A single operand is unchanged.
 *
 * Errors (vtkErrorMacro): an added operand is null or contains this object (it is ignored); there
 * is no operand when the object is evaluated (density 0).
 */
class INTERLUMESOURCES_EXPORT vtkSpatialOperation : public vtkSpatialObject
{
public:
  static vtkSpatialOperation* New();
  vtkTypeMacro(vtkSpatialOperation, vtkSpatialObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Operations
  {
    UNION = 0,
    INTERSECTION = 1,
    DIFFERENCE = 2,
    BLEND = 3,
    CAP = 4,
    TRIM = 5,
    NUMBER_OF_OPERATIONS = 6
  };

  /// Returns the lowercase name of an operation, or null if there is no such operation.
  static const char* GetOperationName(int operation);

  ///@{
  /**
   * Set/Get the operation. Default UNION. Valid: see Operations; clamped.
   */
  vtkSetClampMacro(Operation, int, UNION, TRIM);
  vtkGetMacro(Operation, int);
  void SetOperationToUnion() { this->SetOperation(UNION); }
  void SetOperationToIntersection() { this->SetOperation(INTERSECTION); }
  void SetOperationToDifference() { this->SetOperation(DIFFERENCE); }
  void SetOperationToBlend() { this->SetOperation(BLEND); }
  void SetOperationToCap() { this->SetOperation(CAP); }
  void SetOperationToTrim() { this->SetOperation(TRIM); }
  ///@}

  ///@{
  /**
   * Manage the ordered operands. GetOperand returns null if the index is invalid.
   */
  void AddOperand(vtkSpatialObject* operand);
  void RemoveAllOperands();
  int GetNumberOfOperands() const { return static_cast<int>(this->Operands.size()); }
  vtkSpatialObject* GetOperand(int index) const;
  ///@}

  bool Contains(const vtkSpatialObject* object) const override;
  vtkMTimeType GetMTime() override;

protected:
  vtkSpatialOperation() = default;
  ~vtkSpatialOperation() override = default;

  std::string Prepare(double bounds[6]) override;
  bool EvaluateLocally(const double (*points)[3], int number, Sample* samples) const override;

private:
  vtkSpatialOperation(const vtkSpatialOperation&) = delete;
  void operator=(const vtkSpatialOperation&) = delete;

  /// Replaces \a a with the combination of \a a and \a b.
  void Combine(Sample& a, const Sample& b) const;

  std::vector<vtkSmartPointer<vtkSpatialObject>> Operands;

  int Operation = UNION;
};

#endif
