// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES
#if defined(PAINT_FILTER) || defined(SPLITS) || defined(SEAMS)
#define PLAIN_CELLS
#endif

// Casts a view ray through an implicit flow field. Positions are in voxel coordinates, 0 at the
// first voxel. Distances along the ray are in world units, 0 at the plane through the center of the
// volume.
in vec2 texCoord;

uniform vec3 rayOrigin;
uniform vec3 rayOriginX;
uniform vec3 rayOriginY;
uniform vec3 rayDirection;
uniform vec3 rayDirectionX;
uniform vec3 rayDirectionY;
uniform mat3 worldFromVoxels;
// Distances of the near and far planes, and of the plane at which distances along the ray are 0, in
// multiples of rayDirection. See FlowViewRays.
uniform vec2 nearFar;
uniform float centerDistance;
uniform vec3 lastCell;
uniform float sampleDistance;
// One divided by ScalarOpacityUnitDistance.
uniform float inverseUnitDistance;
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

// Returns 1 - (1 - alpha)^length. The result is accurate for small alpha and length.
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
  float lower = (nearFar.x - centerDistance) * unit;
  float upper = (nearFar.y - centerDistance) * unit;
#ifdef OPAQUE
  float opaque = texture(image, texCoord).r;
#ifdef PARALLEL
  upper = min(upper, (mix(nearFar.x, nearFar.y, opaque) - centerDistance) * unit);
#else
  upper = min(upper, (1.0 / mix(1.0 / nearFar.x, 1.0 / nearFar.y, opaque) - centerDistance) * unit);
#endif
#endif
  vec3 inverse = inverseOf(way);
  cutToMedium(origin, way, origin, inverse, lower, upper);

  Ray ray = Ray(origin, way, unit, lower, upper, lower, 0.0);
  vec4 sum = vec4(0.0);
#ifdef SMOOTH_POSITIONS
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
