// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ShaderFeatures_h
#define interlume_ShaderFeatures_h

#include "InterlumeSceneModule.h"

#include <string>

namespace interlume
{

/**
 * Inserts features into shader source.
 */
namespace ShaderFeatures
{
/// Replaces two lines of \a source. The line `//INTERLUME::FEATURES` becomes one `#define` for each
/// word of \a features, which is a name or name=value. The line `//INTERLUME::CUTS` becomes the
/// functions of InterlumeRayCuts.glsl, which clip rays to the box of a volume, to clipping planes
/// (feature CLIPPING_PLANES=number) and to cropping regions (feature CROPPING).
INTERLUMESCENE_EXPORT std::string Insert(const std::string& source, const std::string& features);
}

}

#endif
