// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkSpatialOperation_h
#define vtkSpatialOperation_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkSpatialObject.h"

#include <vector> // for the operands

/**
 * @class   vtkSpatialOperation
 * @brief   union, intersection, difference, blend, cap or trim of spatial objects
 *
 * Combines operands as in constructive volume geometry (M. Chen and J. V. Tucker, Computer Graphics
 * Forum 19(4), 2000). For the operands' densities a, b and colours A, B the density and the colour
 * are
 * - UNION: max(a, b); A if a >= b, else B;
 * - INTERSECTION: min(a, b); A if a >= b, else B;
 * - DIFFERENCE: max(0, a - b); A;
 * - BLEND: min(1, a + b); (a A + b B) / (a + b);
 * - CAP: a where b < a, else 0; A. A solid b cuts a away inside it;
 * - TRIM: a where b >= a, else 0; A. A solid b cuts a away outside it.
 *
 * So cap and trim share a between them, and leave its density as it is. More than two operands are
 * taken from left to right; a single operand stays as it is.
 *
 * Errors (vtkErrorMacro): null, or an operand that has this object among its parts, which is not
 * added; no operand (density 0).
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

  /// Returns the operation's name in small letters; null for a number that is not an operation.
  static const char* GetOperationName(int operation);

  ///@{
  /**
   * The operation that combines the operands. Default UNION. Valid: see Operations; clamped.
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
   * The operands, in order. GetOperand returns null for an index without an operand.
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

  /// Makes \a a the combination of both.
  void Combine(Sample& a, const Sample& b) const;

  std::vector<vtkSmartPointer<vtkSpatialObject>> Operands;

  int Operation = UNION;
};

#endif
