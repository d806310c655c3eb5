// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPVInflowMapping_h
#define vtkPVInflowMapping_h

#include "InterlumeFlowProxiesModule.h" // for the export macro
#include "vtkInflowMapping.h"

#include <map>
#include <string>
#include <vector>

/**
 * @class   vtkPVInflowMapping
 * @brief   an inflow mapping whose image is an input of a pipeline
 *
 * Input port 1, optional: vtkImageData, the mapping of ImageId. Where an id has several mappings
 * the image counts, then the rings, then the formula of the id, then the common formula. Mappings
 * that the base class was given directly are replaced in each execution.
 */
class INTERLUMEFLOWPROXIES_EXPORT vtkPVInflowMapping : public vtkInflowMapping
{
public:
  static vtkPVInflowMapping* New();
  vtkTypeMacro(vtkPVInflowMapping, vtkInflowMapping);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The formula of all ids that have no mapping of their own; empty: none. Default "u".
   */
  void SetCommonFormula(const char* formula);
  const char* GetCommonFormula() const { return this->CommonFormula.c_str(); }
  ///@}

  ///@{
  /**
   * The formulas and the rings of single ids. Default none. Valid: as in the base class.
   */
  void AddFormula(int id, const char* formula);
  void RemoveAllFormulas();
  void AddRingOf(
    int id, double centerU, double centerV, double radius, double width, double amplitude);
  void RemoveAllRings();
  ///@}

  ///@{
  /**
   * The id that the image belongs to. Default ALL.
   */
  vtkSetClampMacro(ImageId, int, ALL, 1000000000);
  vtkGetMacro(ImageId, int);
  ///@}

protected:
  vtkPVInflowMapping();
  ~vtkPVInflowMapping() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPVInflowMapping(const vtkPVInflowMapping&) = delete;
  void operator=(const vtkPVInflowMapping&) = delete;

  struct Ring
  {
    int Id;
    double Center[2];
    double Radius;
    double Width;
    double Amplitude;
  };

  std::string CommonFormula = "u";
  std::map<int, std::string> Formulas;
  std::vector<Ring> Rings;
  int ImageId = ALL;
};

#endif
