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
 * @brief   map inflow values with formulas, rings and an image from the pipeline
 *
 * Input port 1, optional: a vtkImageData, which is the mapping of the id ImageId. If an id has
 * several mappings, the image has precedence, then the rings, the formula of the id, and the common
 * formula. Each execution replaces mappings that were set directly in the superclass.
 */
class INTERLUMEFLOWPROXIES_EXPORT vtkPVInflowMapping : public vtkInflowMapping
{
public:
  static vtkPVInflowMapping* New();
  vtkTypeMacro(vtkPVInflowMapping, vtkInflowMapping);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the formula for all ids without a mapping of their own. An empty string sets no
   * formula. Default: "u".
   */
  void SetCommonFormula(const char* formula);
  const char* GetCommonFormula() const { return this->CommonFormula.c_str(); }
  ///@}

  ///@{
  /**
   * Add or remove formulas and Gaussian rings for single ids. Default: none. Valid: see
   * vtkInflowMapping.
   */
  void AddFormula(int id, const char* formula);
  void RemoveAllFormulas();
  void AddRingOf(
    int id, double centerU, double centerV, double radius, double width, double amplitude);
  void RemoveAllRings();
  ///@}

  ///@{
  /**
   * Set/Get the id to which the image applies. Default: ALL. Valid: ALL, or 0 to 1000000000;
   * clamped.
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
