// SPDX-License-Identifier: BSD-3-Clause
//INTERLUME::FEATURES
// Computes the fraction of each light that reaches a fragment of a surface drawn by VTK. This code
// is inserted into VTK's shaders. Positions are in view coordinates.
//INTERLUME::OCCLUDERS
uniform float sceneStrengths[SCENE_LIGHTS];
#ifdef TRANSMITTANCE
// Transmittance of the volumes between each light and the surface visible in each pixel, with one
// tile per light, and the depth of that surface.
uniform sampler2D sceneTransmittance;
uniform sampler2D sceneDepth;
// Lower left pixel and size of the viewport.
uniform vec4 sceneViewport;
uniform int sceneIsOpaque;

// Returns the pixel that shows the fragment's surface. At edges with multisampling, the fragment's
// own pixel can show a different surface. Then the neighbor with the closest depth is used.
ivec2 scenePixel()
{
  ivec2 here = ivec2(gl_FragCoord.xy - sceneViewport.xy);
  ivec2 best = here;
  float least = abs(texelFetch(sceneDepth, here, 0).r - gl_FragCoord.z);
  if (least > 1e-6)
  {
    for (int i = 0; i < 9; ++i)
    {
      ivec2 pixel = clamp(here + ivec2(i % 3, i / 3) - 1, ivec2(0), ivec2(sceneViewport.zw) - 1);
      float difference = abs(texelFetch(sceneDepth, pixel, 0).r - gl_FragCoord.z);
      best = difference < least ? pixel : best;
      least = min(difference, least);
    }
  }
  return best;
}

vec3 sceneLightOfVolumes(ivec2 pixel)
{
  return sceneIsOpaque == 1 ? texelFetch(sceneTransmittance, pixel, 0).SCENE_CHANNELS : vec3(1.0);
}
#endif

vec3 sceneLightOf(int number, vec3 share)
{
  return 1.0 - sceneStrengths[number] * (1.0 - share);
}

// Returns the plane of the fragment's triangle.
vec4 scenePlane(vec3 place)
{
  vec3 normal = cross(dFdx(place), dFdy(place));
  float size = length(normal);
  normal = size > 0.0 ? normal / size : vec3(0.0);
  return vec4(normal, -dot(normal, place));
}
