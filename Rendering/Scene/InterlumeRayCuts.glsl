// What is cut from a volume: what is beside its box, behind clipping planes, in cropped regions.

uniform vec3 boxLower;
uniform vec3 boxUpper;
#ifdef CLIPPING_PLANES
uniform vec4 clippingPlanes[CLIPPING_PLANES];
#endif
#ifdef CROPPING
// The axes of the volume, one a column, and the thresholds along them.
uniform mat3 croppingAxes;
uniform vec3 croppingLower;
uniform vec3 croppingUpper;
uniform int croppingFlags;
#endif

// Returns one over a direction in the box's coordinates, as far as that goes.
vec3 inverseOf(vec3 q)
{
  return 1.0 / mix(q, vec3(1e-12), lessThan(abs(q), vec3(1e-12)));
}

// Finds the part of x + s d between lower and upper that is in the box and kept by the planes. In
// the box's coordinates x is p, and one over d is inverse.
void cutToMatter(vec3 x, vec3 d, vec3 p, vec3 inverse, inout float lower, inout float upper)
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
// Returns true if cropping takes the region at x away.
bool isCropped(vec3 x)
{
  vec3 v = x * croppingAxes;
  ivec3 region = ivec3(greaterThanEqual(v, croppingLower)) + ivec3(greaterThan(v, croppingUpper));
  return (croppingFlags & (1 << (region.x + 3 * region.y + 9 * region.z))) == 0;
}

// Makes lower and upper the ends of a segment that is as long as the parts of x + s d between them
// that cropping leaves, around the center of these.
void cutToRegions(vec3 x, vec3 d, inout float lower, inout float upper)
{
  vec3 inverse = inverseOf(d * croppingAxes);
  vec3 first = (croppingLower - x * croppingAxes) * inverse;
  vec3 second = (croppingUpper - x * croppingAxes) * inverse;
  float from = lower;
  float size = 0.0;
  float moment = 0.0;
  // Six thresholds part a line.
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
