// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES
#if defined(PAINT_FILTER) || defined(SPLITS) || defined(SEAMS)
#define PLAIN_CELLS
#endif

// Walks a line of sight through an implicit flow field. Places are in voxels, 0 at the first one;
// ways along the line in world units, 0 where the plane through the volume's middle is.
in vec2 texCoord;

uniform vec3 rayOrigin;
uniform vec3 rayOriginX;
uniform vec3 rayOriginY;
uniform vec3 rayDirection;
uniform vec3 rayDirectionX;
uniform vec3 rayDirectionY;
uniform mat3 worldFromVoxels;
// The ways to the near and the far plane, in lengths of the direction from the eye, and the way
// from there to 0.
uniform vec2 nearFar;
uniform float middle;
uniform vec3 lastCell;
uniform float sampleDistance;
// One over the unit distance.
uniform float unitShare;
#ifdef OPAQUE
uniform sampler2D image;
#endif
#ifdef PAINT_FILTER
uniform vec2 pixelSize;
#endif

//VTK::Output::Dec

//INTERLUME::CUTS
//INTERLUME::CELL
//INTERLUME::PAINT
//INTERLUME::SHADE

const float OPAQUE_ENOUGH = 0.9999;

// Returns 1 - (1 - alpha)^length, with all digits of small ones too.
float opacityOf(float alpha, float length)
{
  float depth = depthOf(alpha) * length;
  float few = depth * (1.0 - depth * (1.0 / 2.0 - depth * (1.0 / 6.0 - depth / 24.0)));
  float opacity = depth < 0.05 ? few : 1.0 - exp(-depth);
  return alpha < 1.0 ? opacity : 1.0;
}

//INTERLUME::WALK

void main()
{
  vec2 at = 2.0 * texCoord - 1.0;
  vec3 origin = rayOrigin + at.x * rayOriginX + at.y * rayOriginY;
  vec3 direction = rayDirection + at.x * rayDirectionX + at.y * rayDirectionY;
  float unit = length(worldFromVoxels * direction);
  vec3 way = direction / unit;
  float lower = (nearFar.x - middle) * unit;
  float upper = (nearFar.y - middle) * unit;
#ifdef OPAQUE
  float opaque = texture(image, texCoord).r;
#ifdef PARALLEL
  upper = min(upper, (mix(nearFar.x, nearFar.y, opaque) - middle) * unit);
#else
  upper = min(upper, (1.0 / mix(1.0 / nearFar.x, 1.0 / nearFar.y, opaque) - middle) * unit);
#endif
#endif
  vec3 inverse = inverseOf(way);
  cutToMatter(origin, way, origin, inverse, lower, upper);

  Ray ray = Ray(origin, way, unit, lower, upper, lower, 0.0);
  vec4 sum = vec4(0.0);
#ifdef SMOOTH_PLACES
  vec3 size = abs(way);
  float stride = 1.0 / (sampleDistance * max(max(size.x, size.y), size.z));
  float reach = 0.0;
#ifdef PAINT_FILTER
  reach = max(reachOf(ray, lower), reachOf(ray, upper)) * max(paintSize.x, paintSize.y);
#endif
  while (goesOn(ray, sum))
  {
    bool isBeforeSplit = false;
    while (!isBeforeSplit && goesOn(ray, sum))
    {
      walkSmooth(ray, reach, stride, sum);
#ifdef PLAIN_CELLS
      isBeforeSplit = walkPlain(ray, sum);
#endif
    }
#ifdef SPLITS
    walkSplits(ray, sum);
#endif
  }
#else
  walkCells(ray, inverse, sum);
#endif
  if (!(sum.a > 0.0))
  {
    discard;
  }
  gl_FragData[0] = sum;
}
