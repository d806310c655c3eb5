// One light, INDEX its number.

uniform vec3 diffuse_INDEX;
#ifdef SHADE
uniform vec3 specular_INDEX;
#endif
#ifdef POSITIONAL_INDEX
uniform vec3 position_INDEX;
uniform vec3 attenuation_INDEX;
#endif
#if defined(CONE_INDEX) || !defined(POSITIONAL_INDEX)
uniform vec3 direction_INDEX;
#endif
#ifdef CONE_INDEX
uniform vec2 cone_INDEX;
#endif
#ifdef SCREEN_INDEX
uniform mat4 screenFromUnit_INDEX;
uniform float edgeWidth_INDEX;
uniform float screenOpacity_INDEX;
#ifdef IMAGE_INDEX
uniform sampler2D image_INDEX;
#endif
#endif
#ifdef SHADOW_INDEX
uniform sampler2D buffer_INDEX;
uniform float strength_INDEX;
#ifdef WIDE_INDEX
uniform mat3 frame_INDEX;
#else
uniform mat4 bufferFromUnit_INDEX;
#endif
#endif

// The direction in which light goes at the sample.
vec3 getDirection_INDEX()
{
#ifdef POSITIONAL_INDEX
  return normalize(sampleAt - position_INDEX);
#else
  return direction_INDEX;
#endif
}

// The share of its colours that reaches the sample without the matter.
vec3 getColor_INDEX(vec3 l)
{
  vec3 color = vec3(1.0);
#ifdef POSITIONAL_INDEX
  float d = distance(sampleAt, position_INDEX);
  color /= attenuation_INDEX.x + d * (attenuation_INDEX.y + d * attenuation_INDEX.z);
#endif
#ifdef CONE_INDEX
  float cosine = dot(l, direction_INDEX);
  color *= cosine < cone_INDEX.x ? 0.0 : pow(cosine, cone_INDEX.y);
#endif
#ifdef SCREEN_INDEX
  vec4 s = screenFromUnit_INDEX * vec4(sampleAt, 1.0);
  vec2 uv = s.xy / s.w;
  vec2 inside = min(uv, 1.0 - uv);
  if (!(s.w > 0.0 && min(inside.x, inside.y) >= 0.0))
  {
    return vec3(0.0);
  }
  if (edgeWidth_INDEX > 0.0)
  {
    vec2 edge = clamp(inside * (2.0 / edgeWidth_INDEX), 0.0, 1.0);
    edge *= edge * (3.0 - 2.0 * edge);
    color *= edge.x * edge.y;
  }
  color *= screenOpacity_INDEX;
#ifdef IMAGE_INDEX
  color *= textureLod(image_INDEX, uv, 0.0).rgb;
#endif
#endif
  return color;
}

#ifdef SHADOW_INDEX
// How far light that goes along l, inverse in the texture, goes through the slab's matter before it
// is at x, p in the texture.
float getPath_INDEX(vec3 x, vec3 p, vec3 l, vec3 inverse)
{
  float path = (dot(x, sliceNormal) - sliceEntrance) / max(dot(l, sliceNormal), 1e-6);
#ifdef WIDE_INDEX
  path = min(path, distance(x, position_INDEX));
#endif
  float lower = -max(path, 0.0);
  float upper = 0.0;
  cutToMatter(x, l, p, inverse, lower, upper);
  return max(-lower, 0.0);
}

// The transmittance from the light: up to the slab from the buffer, within it the mean over what the
// eye sees of the segment.
LIGHT getTransmittance_INDEX(vec3 l)
{
#ifdef WIDE_INDEX
  if (!(dot(sampleAt - position_INDEX, sliceNormal) > 0.0))
  {
    return LIGHT(0.0);
  }
  vec3 p = l * frame_INDEX;
  p.xy /= abs(p.x) + abs(p.y) + max(p.z, 0.0);
  vec2 uv = vec2(p.x + p.y, p.x - p.y) * 0.5 + 0.5;
#else
  vec4 b = bufferFromUnit_INDEX * vec4(sampleAt, 1.0);
  vec2 uv = b.xy / b.w * 0.5 + 0.5;
#endif
  vec3 inverse = inverseOf(mat3(textureFromUnit) * l);
  LIGHT outside = textureLod(buffer_INDEX, uv, 0.0).CHANNELS;
#ifdef WIDE_INDEX
  outside = exp(-outside / max(dot(l, sliceNormal), 1e-6));
  float path = getPath_INDEX(sampleAt, placeInTexture(sampleAt), l, inverse);
  if (path > 1.5 * sliceSpacing)
  {
    int steps = clamp(int(ceil(path / (1.5 * sliceSpacing))), 1, 256);
    float size = path / float(steps);
    LIGHT depth = LIGHT(0.0);
    for (int i = 0; i < steps; ++i)
    {
      vec4 texel;
      vec4 parts;
      vec3 x = sampleAt - l * ((float(i) + 0.5) * size);
      float extinction = extinctionsAt(x, placeInTexture(x), texel, parts);
      depth += extinction * size * PART(texel);
    }
    return outside * exp(-depth);
  }
#endif
  LIGHT first = sampleExtinction * getPath_INDEX(segmentStart, startInTexture, l, inverse) * samplePart;
  LIGHT last = sampleExtinction * getPath_INDEX(segmentEnd, endInTexture, l, inverse) * samplePart;
  return outside * meanOfProduct(first, last);
}
#endif

void shine_INDEX(inout vec3 sum)
{
  vec3 l = getDirection_INDEX();
  vec3 color = getColor_INDEX(l);
  if (!(max(max(color.r, color.g), color.b) > 0.0))
  {
    return;
  }
#ifdef SHADOW_INDEX
  color *= 1.0 - strength_INDEX * (1.0 - getTransmittance_INDEX(l));
#ifdef WIDE_INDEX
  color *= dot(sampleAt - position_INDEX, sliceNormal) > 0.0 ? 1.0 : 0.0;
#endif
#endif
  addReflection(sum, l, color * diffuse_INDEX,
#ifdef SHADE
    color * specular_INDEX
#else
    vec3(0.0)
#endif
  );
}
