// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// Interpolates an image coarser than the viewport, which is composited over the scene. Pixels
// contain color times opacity. Each image pixel contains the volume up to the surface visible at
// its center. Of the four pixels around a fragment, those whose surface is far from the fragment's
// own surface get small weights. Otherwise, at the edges of a surface, the volume behind it would
// blend with the volume in front of it.
in vec2 texCoord;
uniform sampler2D image;
uniform vec2 imageSize;
uniform sampler2D surfaceDepth;
#ifdef FRONT
// Depth of the surfaces at which the image begins. The image contains nothing in front of them.
uniform sampler2D frontDepth;
#endif
uniform mat4 unitFromClip;
// View direction.
uniform vec3 viewRay;
// Depth difference that a slanted surface can have between adjacent pixels.
uniform float slant;

//VTK::Output::Dec

// Returns the distance of a surface along the view direction, clamped to the unit sphere that
// contains the volumes.
float alongSight(sampler2D depths, vec2 place)
{
  float window = texture(depths, place).r;
  vec4 surface = unitFromClip * vec4(vec3(place, window) * 2.0 - 1.0, 1.0);
  return window < 1.0 ? clamp(dot(surface.xyz / surface.w, viewRay), -1.0, 1.0) : 1.0;
}

vec2 endsOfImage(vec2 place)
{
#ifdef FRONT
  return vec2(alongSight(surfaceDepth, place), alongSight(frontDepth, place));
#else
  return vec2(alongSight(surfaceDepth, place), 0.0);
#endif
}

void main()
{
  vec2 ends = endsOfImage(texCoord);
  vec2 texel = texCoord * imageSize - 0.5;
  vec2 lower = floor(texel);
  vec4 sum = vec4(0.0);
  float total = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    vec2 corner = vec2(i % 2, i / 2);
    vec2 share = mix(1.0 - (texel - lower), texel - lower, corner);
    vec2 place = (clamp(lower + corner, vec2(0.0), imageSize - 1.0) + 0.5) / imageSize;
    vec2 separation = (endsOfImage(place) - ends) / slant;
    float difference = dot(separation, separation);
    float weight = share.x * share.y / (1.0 + difference * difference);
    sum += weight * textureLod(image, place, 0.0);
    total += weight;
  }
  gl_FragData[0] = sum / total;
}
