// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/IndexPage.h"

#include "Gallery/FrameFiles.h"
#include "Gallery/Scene.h"
#include "Support/Inputs/DataManifest.h"
#include "Support/Pages/HtmlText.h"

#include "vtkVersion.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace gallery
{
namespace
{
const char* const STYLE = R"css(
:root { --ink: #21262e; --soft: #5d6673; --line: #d4d8dc; --paper: #f6f7f8; --card: #ecedee; }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink);
  font: 16px/1.55 system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; }
header, main, footer { max-width: 1180px; margin: 0 auto; padding: 0 24px; }
header { padding-top: 56px; padding-bottom: 12px; }
h1 { font-size: 40px; line-height: 1.1; margin: 0 0 10px; letter-spacing: -0.02em; }
header p { max-width: 760px; margin: 0; color: var(--soft); font-size: 18px; }
nav { display: grid; grid-template-columns: repeat(auto-fill, minmax(150px, 1fr)); gap: 12px;
  margin: 28px 0 8px; }
nav a { color: var(--soft); font-size: 13px; text-decoration: none; }
nav img { width: 100%; display: block; border-radius: 6px; border: 1px solid var(--line);
  margin-bottom: 4px; }
nav a:hover { color: var(--ink); }
article { margin: 44px 0; }
article > a img, article .frames { width: 100%; display: block; border-radius: 10px; border: 1px solid var(--line);
  background: var(--card); }
h2 { font-size: 24px; margin: 18px 0 4px; letter-spacing: -0.01em; }
h2 span { color: var(--soft); font-weight: normal; font-size: 15px; margin-left: 10px;
  letter-spacing: 0; white-space: nowrap; }
article p { margin: 0 0 12px; max-width: 860px; }
dl { display: grid; grid-template-columns: repeat(auto-fit, minmax(120px, 1fr)); gap: 10px 22px;
  margin: 0; padding: 14px 0; border-top: 1px solid var(--line); }
dt { color: var(--soft); font-size: 12px; }
dd { margin: 0; font-variant-numeric: tabular-nums; }
dl .features { grid-column: 1 / -1; }
.source { color: var(--soft); font-size: 13px; margin: 0; max-width: none; }
footer { color: var(--soft); font-size: 13px; padding-bottom: 56px; }
)css";

/// JavaScript that plays the frames of animations. It skips frames that are not loaded yet.
const char* const SCRIPT = R"js(
document.querySelectorAll('img[data-frames]').forEach(image => {
  const frames = JSON.parse(image.dataset.frames).map(name => {
    const frame = new Image();
    frame.src = name;
    return frame;
  });
  let next = 0;
  setInterval(() => {
    next = (next + 1) % frames.length;
    if (frames[next].complete) image.src = frames[next].src;
  }, 1000 / image.dataset.rate);
});
)js";

using html::Escaped;

/// Formats a number with thin spaces between groups of digits: 1234567 as "1 234 567".
std::string Grouped(vtkIdType number)
{
  std::string digits = std::to_string(number);
  for (int position = static_cast<int>(digits.size()) - 3; position > 0; position -= 3)
  {
    digits.insert(static_cast<std::size_t>(position), "&#8201;");
  }
  return digits;
}

std::string Seconds(double seconds)
{
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.2f s", seconds);
  return text.data();
}

std::string Joined(const nlohmann::json& names)
{
  std::string joined;
  for (const std::string name : names)
  {
    joined += (joined.empty() ? "" : ", ") + name;
  }
  return joined.empty() ? "none" : joined;
}

void WriteFact(std::ostream& page, const std::string& name, const std::string& value)
{
  page << "<div><dt>" << name << "</dt><dd>" << value << "</dd></div>\n";
}

/// Writes the number of slices, lights and light buffers of all sliced volumes.
void WriteSlices(std::ostream& page, const nlohmann::json& volumes)
{
  if (volumes.empty())
  {
    return;
  }
  int slices = 0;
  int lights = 0;
  int lightBuffers = 0;
  for (const nlohmann::json& volume : volumes)
  {
    slices += volume.at("slices_drawn").get<int>();
    lights = std::max(lights, volume.at("lights").get<int>());
    lightBuffers += volume.at("light_buffers").get<int>();
  }
  WriteFact(page, "Slices", Grouped(slices));
  WriteFact(page, "Lights", std::to_string(lights));
  WriteFact(page, "Light buffers", std::to_string(lightBuffers));
}

/// Writes the animation of a scene: frames that a script plays, and a link to the movie if there is
/// one.
void WriteFrames(std::ostream& page, const Scene& scene, const nlohmann::json& report)
{
  const int frames = report.at("frames");
  if (frames == 0)
  {
    return;
  }
  page << "<img class=\"frames\" src=\"" << FrameFiles::GetName(scene.Id, 0) << "\" alt=\""
       << Escaped(scene.Title) << ", animated\" data-rate=\"" << FrameFiles::FramesPerSecond
       << "\" data-frames='[";
  for (int i = 0; i < frames; ++i)
  {
    page << (i > 0 ? "," : "") << '"' << FrameFiles::GetName(scene.Id, i) << '"';
  }
  page << "]'>\n";
  if (report.at("movie").get<bool>())
  {
    page << "<p class=\"source\"><a href=\"" << FrameFiles::GetMovieName(scene.Id)
         << "\">The animation as a movie</a> (Ogg Theora).</p>\n";
  }
}

void WriteScene(std::ostream& page, const Scene& scene, const nlohmann::json& report,
  const std::vector<interlume::DataRow>& manifest)
{
  page << "<article id=\"" << scene.Id << "\">\n<a href=\"" << scene.Id << ".png\"><img src=\""
       << scene.Id << ".png\" width=\"" << report.at("size")[0] << "\" height=\""
       << report.at("size")[1] << "\" alt=\"" << Escaped(scene.Title) << "\"></a>\n<h2>"
       << Escaped(scene.Title) << "<span>" << scene.Id << " &middot; figure " << scene.Figure
       << "</span></h2>\n<p>" << Escaped(scene.Caption) << "</p>\n";
  WriteFrames(page, scene, report);
  page << "<dl>\n";
  if (report.at("filters") > 0)
  {
    WriteFact(page, "Cells in", Grouped(report.at("extraction").at("cells")));
    WriteFact(page, "Tetrahedra out", Grouped(report.at("tetrahedra")));
    WriteFact(page, "Intervals", std::to_string(report.at("intervals").get<int>()));
    WriteFact(page, "Extraction", Seconds(report.at("extract_seconds")));
  }
  if (report.at("boundary_triangles") > 0)
  {
    WriteFact(page, "Boundary triangles", Grouped(report.at("boundary_triangles")));
  }
  if (report.at("simplices") > 0)
  {
    WriteFact(page, "4-simplices", Grouped(report.at("simplices")));
  }
  if (report.at("criteria") > 0)
  {
    WriteFact(page, "Further criteria", std::to_string(report.at("criteria").get<int>()));
  }
  WriteSlices(page, report.at("sliced_volumes"));
  WriteFact(page, "Drawing", Seconds(report.at("render_seconds")));
  WriteFact(page, "Passes", std::to_string(report.at("passes").get<int>()));
  std::array<char, 48> buffers;
  std::snprintf(buffers.data(), buffers.size(), "%d, %.0f MB", report.at("buffers").get<int>(),
    report.at("bytes").get<double>() / 1e6);
  WriteFact(page, "Buffers", buffers.data());
  page << "<div class=\"features\"><dt>Features on</dt><dd>" << Joined(report.at("features"))
       << "</dd></div>\n</dl>\n";
  for (const std::string& file : scene.Data)
  {
    const interlume::DataRow& row = interlume::FindDataRow(manifest, file);
    page << "<p class=\"source\">Data: " << Escaped(row.Content) << " (" << Escaped(row.File)
         << ", from " << Escaped(row.Source) << "). License: " << Escaped(row.License) << ".</p>\n";
  }
  page << "</article>\n";
}
}

void WriteIndexPage(const std::string& folder, const std::vector<nlohmann::json>& reports)
{
  const std::vector<interlume::DataRow> manifest = interlume::ReadDataManifest();
  std::ostringstream page;
  page << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
       << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
       << "<title>Interlume gallery</title>\n<style>" << STYLE << "</style>\n</head>\n<body>\n"
       << "<header>\n<h1>Interlume</h1>\n<p>Volumes with shadows, and interval volumes: the region "
          "where a "
          "field lies between two values, as tetrahedra. Each image is a short pipeline of public "
          "classes. Figure numbers refer to the dissertation on which the methods are based "
          "(C.&nbsp;Zhang, Ohio State University, 2006).</p>\n<nav>\n";
  for (const nlohmann::json& report : reports)
  {
    const Scene& scene = *FindScene(report.at("id"));
    page << "<a href=\"#" << scene.Id << "\"><img src=\"" << scene.Id << ".png\" alt=\"\">"
         << Escaped(scene.Title) << "</a>\n";
  }
  page << "</nav>\n</header>\n<main>\n";
  for (const nlohmann::json& report : reports)
  {
    WriteScene(page, *FindScene(report.at("id")), report, manifest);
  }
  page
    << "</main>\n<footer>Rendered off-screen with VTK " << vtkVersion::GetVTKVersion()
    << ". Times are wall-clock times on the machine that created this page. Passes are passes over "
       "the geometry and the screen. Buffers are off-screen textures.</footer>\n<script>"
    << SCRIPT << "</script>\n</body>\n</html>\n";
  const std::string path = folder + "/index.html";
  std::ofstream file(path);
  file << page.str();
  if (!file)
  {
    throw std::runtime_error("Cannot write " + path + ".");
  }
}
}
