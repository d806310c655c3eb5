// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/FrameFiles.h"

#include "vtkGenericMovieWriter.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#ifdef INTERLUME_HAS_MOVIES
#include "vtkOggTheoraWriter.h"
#endif

#include "vtksys/SystemTools.hxx"

#include <array>
#include <cstdio>
#include <stdexcept>

namespace gallery
{
void WritePng(vtkImageData* image, const std::string& path)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  writer->Write();
  if (writer->GetErrorCode())
  {
    throw std::runtime_error("Cannot write " + path + ".");
  }
}

FrameFiles::FrameFiles(const std::string& folder, const std::string& id)
  : Folder(folder)
  , Id(id)
{
}

FrameFiles::~FrameFiles() = default;

std::string FrameFiles::GetName(const std::string& id, int number)
{
  std::array<char, 16> name;
  std::snprintf(name.data(), name.size(), "/%03d.png", number);
  return id + name.data();
}

void FrameFiles::Add(vtkImageData* frame)
{
  if (this->Number == 0)
  {
    if (!vtksys::SystemTools::MakeDirectory(this->Folder + "/" + this->Id))
    {
      throw std::runtime_error(
        "Cannot create the directory " + this->Folder + "/" + this->Id + ".");
    }
#ifdef INTERLUME_HAS_MOVIES
    vtkNew<vtkOggTheoraWriter> movie;
    movie->SetRate(FramesPerSecond);
    movie->SetFileName((this->Folder + "/" + GetMovieName(this->Id)).c_str());
    movie->SetInputData(frame);
    movie->Start();
    this->Movie = movie;
#endif
  }
  WritePng(frame, this->Folder + "/" + GetName(this->Id, this->Number++));
  if (this->Movie)
  {
    this->Movie->SetInputData(frame);
    this->Movie->Write();
  }
}

bool FrameFiles::Finish()
{
  if (!this->Movie)
  {
    return false;
  }
  this->Movie->End();
  return this->Movie->GetError() == 0;
}
}
