// Clips view rays to the box of a volume, clipping planes and cropping regions.

uniform vec3 boxLower;
uniform vec3 boxUpper;
#ifdef CLIPPING_PLANES
uniform vec4 clippingPlanes[CLIPPING_PLANES];
#endif
#ifdef CROPPING
// Axes of the volume, one per column, and the cropping thresholds along them.
uniform mat3 croppingAxes;
uniform vec3 croppingLower;
uniform vec3 croppingUpper;
uniform int croppingFlags;
#endif

// Returns the reciprocal of a direction in box coordinates. Components near 0 are replaced by 1e-12
// first.
vec3 inverseOf(vec3 q)
{
  return 1.0 / mix(q, vec3(1e-12), lessThan(abs(q), vec3(1e-12)));
}

// Clips the interval [lower, upper] of s on the ray x + s d to the box and the clipping planes. p
// is x in box coordinates, and inverse is the reciprocal of d in box coordinates.
void cutToMedium(vec3 x, vec3 d, vec3 p, vec3 inverse, inout float lower, inout float upper)
{
  vec3 a = (boxLower - p) * inverse;
  vec3 b = (boxUpper - p) * inverse;
  vec3 near = min(a, b);
  vec3 far = max(a, b);
  lower = max(lower, max(max(near.x, near.y), near.z));
  upper = min(upper, min(min(far.x, far.y), far.z));
#ifdef CLIPPING_PLANES
  for (int i = 0; i < CLIPPING_PLANES; ++i)
  {
    float height = dot(clippingPlanes[i].xyz, x) + clippingPlanes[i].w;
    float slope = dot(clippingPlanes[i].xyz, d);
    if (abs(slope) < 1e-12)
    {
      upper = height < 0.0 ? lower - 1.0 : upper;
    }
    else if (slope > 0.0)
    {
      lower = max(lower, -height / slope);
    }
    else
    {
      upper = min(upper, -height / slope);
    }
  }
#endif
}

#ifdef CROPPING
// Returns true if cropping removes the region at x.
bool isCropped(vec3 x)
{
  vec3 v = x * croppingAxes;
  ivec3 region = ivec3(greaterThanEqual(v, croppingLower)) + ivec3(greaterThan(v, croppingUpper));
  return (croppingFlags & (1 << (region.x + 3 * region.y + 9 * region.z))) == 0;
}

// Replaces the interval [lower, upper] of s on the ray x + s d with one interval that has the total
// length and the center of mass of the parts that cropping retains.
void cutToRegions(vec3 x, vec3 d, inout float lower, inout float upper)
{
  vec3 inverse = inverseOf(d * croppingAxes);
  vec3 first = (croppingLower - x * croppingAxes) * inverse;
  vec3 second = (croppingUpper - x * croppingAxes) * inverse;
  float from = lower;
  float size = 0.0;
  float moment = 0.0;
  // Six thresholds divide a line into up to seven parts.
  for (int i = 0; i < 7 && from < upper; ++i)
  {
    vec3 next = min(mix(first, vec3(upper), lessThanEqual(first, vec3(from))),
      mix(second, vec3(upper), lessThanEqual(second, vec3(from))));
    float to = min(min(next.x, next.y), min(next.z, upper));
    float middle = 0.5 * (from + to);
    float kept = isCropped(x + middle * d) ? 0.0 : to - from;
    size += kept;
    moment += kept * middle;
    from = to;
  }
  float center = size > 0.0 ? moment / size : lower;
  lower = center - 0.5 * size;
  upper = center + 0.5 * size;
}
#else
void cutToRegions(vec3 x, vec3 d, inout float lower, inout float upper)
{
}
#endif
