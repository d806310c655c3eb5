// SPDX-License-Identifier: BSD-3-Clause
// The medium along a ray, for image and light buffer fragments. There are ROWS transfer functions
// of COLUMNS samples. OPACITY_OF is the texel component that defines opacity. With CUSTOM_MEDIUM,
// custom functions replace all of this: see vtkSliceMedium.

#ifdef CUSTOM_MEDIUM
//INTERLUME::CUSTOM_MEDIUM
#else
uniform sampler3D volume;
uniform sampler2D extinctions;
#ifdef SUMS
uniform sampler2D extinctionSums;
#endif
// A table column is (texel - columnOrigin) * columnScale.
uniform vec4 columnScale;
uniform vec4 columnOrigin;
#ifdef BENDS
uniform sampler2D bends;
#endif
#endif
uniform mat4 textureFromUnit;
// Length of one unit of unit space in world units.
uniform float worldLength;
#ifdef MASK
uniform sampler3D mask;
#endif
#ifdef TRANSMISSION
uniform sampler2D transmissions;
#endif
#if (defined(TRANSMISSION) || defined(COLOR)) && !defined(CUSTOM_MEDIUM)
uniform vec4 colorColumnScale;
uniform vec4 colorColumnOrigin;
#endif
#if (defined(GRADIENT_OPACITY) || defined(SHADE)) && !defined(CUSTOM_MEDIUM)
uniform vec3 voxel;
#ifdef DIFFERENCES
// For each voxel, the result of differencesAt.
uniform sampler3D neighborDifferences;
#endif
#endif
#ifdef GRADIENT_OPACITY
uniform sampler2D gradientOpacities;
// Factors that convert the result of differencesAt into gradient components, as expected by the
// gradient opacity functions.
uniform vec3 gradientSteps;
uniform vec4 gradientColumnScale;
uniform vec4 unitDistances;
#endif

// The slab extends from sliceEntrance to sliceEntrance + sliceSpacing along the normal.
uniform vec3 sliceNormal;
uniform float sliceEntrance;
uniform float sliceSpacing;

vec3 positionInTexture(vec3 x)
{
  return (textureFromUnit * vec4(x, 1.0)).xyz;
}

//INTERLUME::CUTS

#ifndef CUSTOM_MEDIUM
#ifdef BENDS
vec4 bendAt(int texel)
{
  return texelFetch(bends, ivec2(texel & (COLUMNS - 1), texel / COLUMNS), 0);
}

// Returns the value at the fraction share of the interval between two columns. The value is in a
// list of linear pieces, and first is the first texel of the list: see TransferColumns.
float lookUpBends(int first, int pieces, float share)
{
  // Find the first piece that ends after share.
  int low = first + 1;
  int high = first + pieces;
  while (low < high)
  {
    int middle = (low + high) / 2;
    bool isBefore = bendAt(middle).y > share;
    high = isBefore ? middle : high;
    low = isBefore ? low : middle + 1;
  }
  vec4 piece = bendAt(low);
  return mix(piece.z, piece.w, clamp((share - piece.x) / (piece.y - piece.x), 0.0, 1.0));
}
#endif

// A texel holds the values of its column and of the next column. If there are breakpoints between
// these columns, it instead holds the negated position of their list in bends, and the number of
// pieces. With EDGES, two more components hold the factor and offset that map a fraction of the
// interval to a fraction of its steep edge.
float lookUp(sampler2D table, float column, int row)
{
  float place = clamp(column, 0.0, float(COLUMNS - 1));
  int first = int(place);
  float share = place - float(first);
#ifdef EDGES
  vec4 values = texelFetch(table, ivec2(first, row), 0);
#else
  vec2 values = texelFetch(table, ivec2(first, row), 0).rg;
#endif
#ifdef BENDS
  if (values.x < 0.0)
  {
    return lookUpBends(int(-values.x), int(values.y), share);
  }
#endif
#ifdef EDGES
  share = clamp(share * values.z + values.w, 0.0, 1.0);
#endif
  return mix(values.x, values.y, share);
}

#if defined(BENDS) && (defined(TRANSMISSION) || defined(COLOR))
vec3 lookUpColorBends(int first, float share)
{
  int low = first + 1;
  int high = first + int(bendAt(first).x);
  while (low < high)
  {
    int middle = (low + high) / 2;
    bool isBefore = bendAt(middle + 1).x > share;
    high = isBefore ? middle : high;
    low = isBefore ? low : middle + 1;
  }
  vec4 left = bendAt(low);
  vec4 right = bendAt(low + 1);
  return mix(left.yzw, right.yzw, clamp((share - left.x) / max(right.x - left.x, 1e-30), 0.0, 1.0));
}
#endif

#ifdef SUMS
// Returns the extinction at a column, and the sum of extinctions up to that column.
vec2 lookUpSum(float column, int row)
{
  float place = clamp(column, 0.0, float(COLUMNS - 1));
  int first = int(place);
  // Sums up to the first column and up to the next one, and the extinctions at both columns.
  vec4 sums = texelFetch(extinctionSums, ivec2(first, row), 0);
#if defined(BENDS) || defined(EDGES)
  float extinction = lookUp(extinctions, column, row);
#else
  float extinction = mix(sums.z, sums.w, place - float(first));
#endif
  // Outside the table, the extinction is that of the nearest column.
  float sum = mix(sums.x, sums.y, place - float(first)) + extinction * (column - place);
  return vec2(extinction, sum);
}
#endif

#if defined(TRANSMISSION) || defined(COLOR)
// The fourth channel of a table texel describes the interval from its column to the next one: the
// position of the list of breakpoints, the negated encoded ends of a steep edge, or 0.
vec3 lookUpColor(sampler2D table, vec4 texel, int row)
{
  float column =
    clamp((texel[row] - colorColumnOrigin[row]) * colorColumnScale[row], 0.0, float(COLUMNS - 1));
  int first = min(int(column), COLUMNS - 2);
  float share = column - float(first);
  vec4 color = texelFetch(table, ivec2(first, row), 0);
#ifdef BENDS
  if (color.a > 0.0)
  {
    return lookUpColorBends(int(color.a), share);
  }
#endif
#ifdef EDGES
  float places = float(EDGE_POSITIONS);
  float from = floor(-color.a / (places + 1.0));
  float to = -color.a - from * (places + 1.0);
  share = color.a < 0.0 ? clamp((share * places - from) / max(to - from, 0.01), 0.0, 1.0) : share;
#endif
  return mix(color.rgb, texelFetch(table, ivec2(first + 1, row), 0).rgb, share);
}
#endif
#endif

// With a transmission color, light has three channels, otherwise one. PART is the fraction of the
// extinction that applies to each channel. It is 1 for a GRAY medium.
#ifdef TRANSMISSION
#define LIGHT vec3
#define CHANNELS rgb
#ifdef GRAY
#define PART(texel) vec3(1.0)
#else
#define PART(texel) (1.0 - lookUpColor(transmissions, texel, 0))
#endif
#else
#define LIGHT float
#define CHANNELS r
#define PART(texel) 1.0
#endif

#ifndef CUSTOM_MEDIUM
// Returns the interpolated value of the finite samples around a position. share is the interpolated
// fraction of finite samples.
vec4 texelAt(vec3 p, out float share)
{
  vec4 texel = texture(volume, p);
  share = 1.0;
#ifdef MASK
  share = texture(mask, p).r;
  texel /= max(share, 1e-6);
#endif
  return texel;
}

#if defined(GRADIENT_OPACITY) || defined(SHADE)
// Computes the difference of the values one voxel after and one voxel before p, along each texture
// axis. here is the value at p.
void differencesAt(vec3 p, vec4 here, out vec4 differences[3])
{
#ifdef DIFFERENCES
  // The interpolation of the voxels' differences is the difference of the interpolated values.
  vec3 found = texture(neighborDifferences, p).rgb;
  for (int axis = 0; axis < 3; ++axis)
  {
    differences[axis] = vec4(found[axis]);
  }
#else
  for (int axis = 0; axis < 3; ++axis)
  {
    vec3 offset = vec3(0.0);
    offset[axis] = voxel[axis];
    float share;
    vec4 before = texelAt(p - offset, share);
    before = share > 0.0 ? before : here;
    vec4 after = texelAt(p + offset, share);
    after = share > 0.0 ? after : here;
    differences[axis] = after - before;
  }
#endif
}

// Returns the length of v without underflow of squared components.
float lengthOf(vec3 v)
{
  float size = max(max(abs(v.x), abs(v.y)), abs(v.z));
  return size > 0.0 ? size * length(v / size) : 0.0;
}

// Returns the direction of the gradient of one component, in unit space. difference is the result
// of differencesAt for that component.
vec3 gradientOf(vec3 difference)
{
  float size = max(max(abs(difference.x), abs(difference.y)), abs(difference.z));
  return normalize((difference / size / voxel) * mat3(textureFromUnit));
}
#endif
#endif

#ifdef CUSTOM_MEDIUM
// Extent of a fragment's sample in texture coordinates: a vector along the ray and the vectors
// along the edges of a pixel.
mat3 sampleSize = mat3(0.0);

// Sets sampleSize from the direction d and length piece of a ray segment and from the pixel edges x
// and y, all in unit space.
void setSampleSize(vec3 d, float piece, vec3 x, vec3 y)
{
  sampleSize =
    mat3(textureFromUnit) * mat3(piece * d, x - dot(x, d) * d, y - dot(y, d) * d);
}

// Computes the extinction at x, which is p in texture coordinates. texel returns the color.
float extinctionsAt(vec3 x, vec3 p, out vec4 texel, out vec4 parts)
{
  texel = vec4(0.0);
  parts = vec4(0.0);
  vec3 color = vec3(0.0);
  parts.x = mediumAt(p, sampleSize, color) * worldLength;
  texel = vec4(color, 0.0);
  return parts.x;
}
#else
// Computes the extinction of each row at x, which is p in texture coordinates. Returns their sum.
float extinctionsAt(vec3 x, vec3 p, out vec4 texel, out vec4 parts)
{
  parts = vec4(0.0);
  float share;
  texel = texelAt(p, share);
  vec4 columns = (texel - columnOrigin) * columnScale;
#if ROWS == 1
  parts.x = lookUp(extinctions, columns.OPACITY_OF, 0) * (share * worldLength);
#else
  for (int row = 0; row < ROWS; ++row)
  {
    parts[row] = lookUp(extinctions, columns[row], row) * (share * worldLength);
  }
#endif
#ifdef GRADIENT_OPACITY
  if (dot(parts, vec4(1.0)) > 0.0)
  {
    vec4 differences[3];
    differencesAt(p, texel, differences);
    for (int row = 0; row < ROWS; ++row)
    {
#if ROWS == 1
      vec3 difference =
        vec3(differences[0].OPACITY_OF, differences[1].OPACITY_OF, differences[2].OPACITY_OF);
#else
      vec3 difference = vec3(differences[0][row], differences[1][row], differences[2][row]);
#endif
      float factor = lookUp(
        gradientOpacities, lengthOf(difference * gradientSteps) * gradientColumnScale[row], row);
      float opacity = 1.0 - exp(-parts[row] * unitDistances[row]);
      parts[row] = -log(max(1.0 - opacity * factor, 1e-30)) / unitDistances[row];
    }
  }
#endif
  return dot(parts, vec4(1.0));
}
#endif

#ifdef SUMS
#if ROWS == 1
#define VALUES float
#else
#define VALUES vec4
#endif

// A sample of the medium. For each row, it contains the opacity column, the extinction and the sum
// of extinctions up to that column. The effective extinction is Extinctions * Fraction.
struct MediumSample
{
  VALUES Columns;
  VALUES Extinctions;
  VALUES Sums;
  float Fraction;
  vec4 Texel;
};

MediumSample mediumSampleOf(VALUES columns, float share, vec4 texel)
{
  MediumSample place;
  place.Columns = columns;
  place.Fraction = share;
  place.Texel = texel;
#if ROWS == 1
  vec2 found = lookUpSum(columns, 0);
  place.Extinctions = found.x;
  place.Sums = found.y;
#else
  place.Extinctions = vec4(0.0);
  place.Sums = vec4(0.0);
  for (int row = 0; row < ROWS; ++row)
  {
    vec2 found = lookUpSum(columns[row], row);
    place.Extinctions[row] = found.x;
    place.Sums[row] = found.y;
  }
#endif
  return place;
}

float extinctionOf(MediumSample place)
{
#if ROWS == 1
  return place.Extinctions * place.Fraction;
#else
  return dot(place.Extinctions, vec4(1.0)) * place.Fraction;
#endif
}

MediumSample mediumSampleOfTexel(vec4 texel, float share)
{
  vec4 columns = (texel - columnOrigin) * columnScale;
#if ROWS == 1
  return mediumSampleOf(columns.OPACITY_OF, share, texel);
#else
  return mediumSampleOf(columns, share, texel);
#endif
}

// Samples the medium at x, which is p in texture coordinates. Fraction includes gradient opacity
// and cropping. With SPANS, it does not include cropping, since the spans are already cropped.
MediumSample mediumSampleAt(vec3 x, vec3 p)
{
  float share;
  vec4 texel = texelAt(p, share);
#if defined(CROPPING) && !defined(SPANS)
  share = isCropped(x) ? 0.0 : share;
#endif
  MediumSample place = mediumSampleOfTexel(texel, share * worldLength);
#ifdef GRADIENT_OPACITY
  float whole = extinctionOf(place);
  vec4 parts;
  float left = extinctionsAt(x, p, texel, parts);
  place.Fraction *= whole > 0.0 ? left / whole : 0.0;
#endif
  return place;
}

MediumSample mediumSampleBetween(MediumSample a, MediumSample b, float part)
{
  return mediumSampleOf(mix(a.Columns, b.Columns, part), mix(a.Fraction, b.Fraction, part), a.Texel);
}

#ifdef SPANS
// Computes samples at both ends of the segment p + q t by linear extrapolation from the segment's
// two Gauss points. The resulting line is the best fit to the values along the segment.
void spanOf(vec3 p, vec3 q, float lower, float upper, out MediumSample start, out MediumSample end)
{
  const float inset = 0.21132487;
  const float beyond = 0.36602540;
  float firstFraction;
  float lastFraction;
  vec4 first = texelAt(p + q * mix(lower, upper, inset), firstFraction);
  vec4 last = texelAt(p + q * mix(upper, lower, inset), lastFraction);
  float share = 0.5 * (firstFraction + lastFraction) * worldLength;
  start = mediumSampleOfTexel(mix(first, last, -beyond), share);
  end = mediumSampleOfTexel(mix(last, first, -beyond), share);
}
#endif

// Returns the mean extinction of each row between two samples.
VALUES meanExtinctions(MediumSample a, MediumSample b)
{
  VALUES change = b.Columns - a.Columns;
  VALUES mean = 0.5 * (a.Extinctions + b.Extinctions);
  // The difference of sums at nearly equal columns is inaccurate.
#if ROWS == 1
  mean = abs(change) < 0.5 ? mean : (b.Sums - a.Sums) / change;
#else
  for (int row = 0; row < ROWS; ++row)
  {
    mean[row] = abs(change[row]) < 0.5 ? mean[row] : (b.Sums[row] - a.Sums[row]) / change[row];
  }
#endif
  return 0.5 * (a.Fraction + b.Fraction) * max(mean, VALUES(0.0));
}

// Returns the mean extinction between two samples, summed over all rows.
float meanExtinction(MediumSample a, MediumSample b)
{
#if ROWS == 1
  return meanExtinctions(a, b);
#else
  return dot(meanExtinctions(a, b), vec4(1.0));
#endif
}

// Returns the extinction-weighted mean position between two samples, 0 to 1.
float meanPosition(MediumSample a, MediumSample b)
{
  float first = extinctionOf(a);
  float last = extinctionOf(b);
  float sum = first + last;
  return sum > 0.0 ? (first + 2.0 * last) / (3.0 * sum) : 0.5;
}

// Returns the optical depth between two samples at the given distance from each other.
LIGHT depthBetween(MediumSample a, MediumSample b, float length)
{
  return meanExtinction(a, b) * length * PART(mix(a.Texel, b.Texel, meanPosition(a, b)));
}

#ifdef TRANSMISSION
float largestOf(vec3 light)
{
  return max(max(light.r, light.g), light.b);
}
#else
float largestOf(float light)
{
  return light;
}
#endif

#ifdef THICK
// Returns true if extinction jumps between two samples, that is, if the extinction midway is far
// from the mean of both samples.
bool jumps(MediumSample a, MediumSample b)
{
  float first = extinctionOf(a);
  float last = extinctionOf(b);
  float middle = extinctionOf(mediumSampleBetween(a, b, 0.5));
  return abs(middle - 0.5 * (first + last)) > 0.45 * max(first, last);
}

// Returns the optical depth of a slab on the ray x + s d, which is p + s q in texture coordinates.
// The slab extends from s = lower to s = upper, and the volume's box from start to end. extinction
// is the extinction at the middle of the slab, and across is the length of a full slab along d. If
// extinction jumps to about 0 before the middle of an adjacent slab, that slab does not draw the
// medium on this side of the jump. The optical depth then includes it, and lower or upper is moved
// to the jump. isFront is set if extinction jumps in front of the middle.
float depthOfSlab(vec3 x, vec3 d, vec3 p, vec3 q, float across, float start, float end,
  float extinction, inout float lower, inout float upper, inout bool isFront)
{
  float middle = 0.5 * (lower + upper);
  float size = 0.5 * (upper - lower);
  MediumSample here = mediumSampleAt(x + d * middle, p + q * middle);
  vec2 borders = vec2(lower, upper);
  float depth = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    float sign = i == 0 ? -1.0 : 1.0;
    float last = i == 0 ? start : end;
    float next = 0.5 * (borders[i] + sign * min(sign * borders[i] + across, sign * last));
    float way = abs(next - middle);
    MediumSample there = mediumSampleAt(x + d * next, p + q * next);
    float share = extinction * size;
    if (abs(last - borders[i]) > 0.01 * across && jumps(here, there))
    {
      bool isLeft = extinctionOf(there) > 0.05 * extinction;
      share = isLeft ? meanExtinction(here, mediumSampleBetween(here, there, size / way)) * size
                     : meanExtinction(here, there) * way;
      float reach = isLeft ? size : min(share / extinction, way);
      borders[i] = middle + sign * reach;
      isFront = isFront || i == 0;
    }
    depth += share;
  }
  lower = borders.x;
  upper = borders.y;
  return max(depth, 1e-6);
}
#endif
#endif
