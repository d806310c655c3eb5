// SPDX-License-Identifier: BSD-3-Clause
#ifndef PictureStage_h
#define PictureStage_h

#include <nlohmann/json.hpp>

#include <array>
#include <functional>
#include <string>
#include <vector>

class vtkLight;
class vtkRenderer;
class vtkVolumeProperty;

/// What the programs share that write pictures for ParaView to repeat, described in JSON.

/// Three numbers.
std::array<double, 3> Triple(const nlohmann::json& numbers);

/**
 * `colors` and `opacities` are rows of value, red, green, blue and of value, opacity; `unit` is the
 * unit distance of the opacity.
 */
void SetUpProperty(vtkVolumeProperty* property, const nlohmann::json& picture);

/// A light of the scene: `position`, `focus`, `color` and `intensity`.
void SetUpLight(vtkLight* light, const nlohmann::json& values);

/**
 * Draws the renderer with the picture's `background`, `camera` and `size`, and writes it as
 * `<name>.png`.
 * @throw std::runtime_error if the file cannot be written.
 */
void SavePicture(const nlohmann::json& picture, vtkRenderer* renderer, const std::string& folder);

/**
 * The body of such a program, whose argument is the folder: draws each picture into it, and then
 * writes the list of pictures to a file there. Returns the exit status.
 */
int WritePictures(int argc, char* argv[], const std::string& listName,
  const std::vector<nlohmann::json>& pictures,
  const std::function<void(const nlohmann::json&, const std::string&)>& draw);

#endif
