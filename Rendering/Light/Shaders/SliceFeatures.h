// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceFeatures_h
#define interlume_SliceFeatures_h

#include <string>
#include <vector>

namespace interlume
{

/**
 * @class   SliceFeatures
 * @brief   the macros of a slice program, and the program's source
 *
 * A feature that is off is not in the source. One table lists all macros with their valid
 * combinations; TestSliceShaders compiles each of them, and each pair.
 */
class SliceFeatures
{
public:
  /// The programs, as bits: fragments of the image, of a light's buffer, and the surfaces of a
  /// scene that a light shines on.
  enum Programs
  {
    IMAGE = 1,
    LIGHT = 2,
    RECEIVER = 4,
    EVERY = 7
  };

  /// A choice for one aspect of a program. Macros of lights are those of light 0.
  struct Choice
  {
    /// Choices of one aspect exclude each other.
    const char* Aspect;
    /// Macros, with their values, or examples of them.
    const char* Macros;
    /// The programs that it is for.
    int Programs;
    /// Macros that must be defined too, and those that must not.
    const char* Needs = "";
    const char* Excludes = "";
    /// If true, each of the programs has a choice for the aspect.
    bool IsRequired = false;
  };
  static const std::vector<Choice>& GetTable();

  /// Parts of a source that depend on more than macros.
  struct Sources
  {
    /// The functions of vtkSliceMedium.
    std::string Medium;
    /// What lights call to find the shadows of surfaces.
    std::string Surfaces;
    /// For each light the shadows of translucent surfaces, a call, or an empty string.
    std::vector<std::string> Lights;
    /// If true, light that was scattered in all directions is added.
    bool HasFluence = false;
    /// If true, a light's buffer has a second target for batches of slabs.
    bool HasBatches = false;
  };

  explicit SliceFeatures(Programs program)
    : Program(program)
  {
  }

  ///@{
  /// Adds a macro, if \a isOn, or a macro with a value.
  void Add(const std::string& name, bool isOn = true);
  void AddValue(const std::string& name, const std::string& value);
  void AddValue(const std::string& name, int value) { this->AddValue(name, std::to_string(value)); }
  ///@}
  /// Adds macros that the table does not list, separated by spaces: those of other sources.
  void AddOther(const std::string& macros) { this->Macros += " " + macros; }

  /// Returns the source of the fragment shader; an invalid one if a macro is not in the table.
  std::string MakeSource(const Sources& sources) const;

private:
  Programs Program;
  std::string Macros;
  std::string Unknown;
};

}

#endif
