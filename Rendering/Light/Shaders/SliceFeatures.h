// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceFeatures_h
#define interlume_SliceFeatures_h

#include <string>
#include <vector>

namespace interlume
{

/**
 * @class   SliceFeatures
 * @brief   the macros and the source of a slice shader
 *
 * Disabled features are removed from the source. A table lists all macros and their valid
 * combinations. TestSliceShaders compiles each choice and each valid pair of choices.
 */
class SliceFeatures
{
public:
  /// Types of programs, as bit flags: for fragments of the image, for fragments of a light buffer,
  /// and for surfaces of a scene that receive shadows.
  enum Programs
  {
    IMAGE = 1,
    LIGHT = 2,
    RECEIVER = 4,
    EVERY = 7
  };

  /// One choice for an aspect of a program. The macros of lights are listed for light 0 only.
  struct Choice
  {
    /// Choices of the same aspect are mutually exclusive.
    const char* Aspect;
    /// Macros, with values or example values.
    const char* Macros;
    /// Programs that support the choice.
    int Programs;
    /// Macros that must be defined, and macros that must not be defined.
    const char* Needs = "";
    const char* Excludes = "";
    /// If true, each program that supports the choice needs a choice for this aspect.
    bool IsRequired = false;
  };
  static const std::vector<Choice>& GetTable();

  /// Source code that depends on more than macros.
  struct Sources
  {
    /// GLSL functions of vtkSliceMedium.
    std::string Medium;
    /// GLSL functions that evaluate the shadows cast by surfaces.
    std::string Surfaces;
    /// For each light, a GLSL call that evaluates the shadows of translucent surfaces, or an empty
    /// string.
    std::vector<std::string> Lights;
    /// If true, light that is scattered multiple times in all directions is added.
    bool HasFluence = false;
    /// If true, light buffers have a second render target, for batches of slabs.
    bool HasBatches = false;
  };

  explicit SliceFeatures(Programs program)
    : Program(program)
  {
  }

  ///@{
  /// Add a macro without a value if \a isOn, or with a value.
  void Add(const std::string& name, bool isOn = true);
  void AddValue(const std::string& name, const std::string& value);
  void AddValue(const std::string& name, int value) { this->AddValue(name, std::to_string(value)); }
  ///@}
  /// Adds macros of other classes, separated by spaces. They are not in the table.
  void AddOther(const std::string& macros) { this->Macros += " " + macros; }

  /// Returns the source of the fragment shader. If a macro is not in the table, the source has an
  /// #error line.
  std::string MakeSource(const Sources& sources) const;

private:
  Programs Program;
  std::string Macros;
  std::string Unknown;
};

}

#endif
