//INTERLUME::FEATURES
// Defines the textured flow as the medium that slices sample, see vtkSliceMedium.

uniform vec3 lastCell;
uniform vec3 voxels;
// One divided by ScalarOpacityUnitDistance.
uniform float inverseUnitDistance;
#ifdef SHADE
uniform mat3 worldFromVoxels;
#endif

//INTERLUME::CELL
//INTERLUME::PAINT
//INTERLUME::SHADE

float mediumAt(vec3 p, mat3 size, out vec3 color)
{
  color = vec3(0.0);
  vec3 place = p * voxels - 0.5;
  vec3 cell = clamp(floor(place), vec3(0.0), lastCell);
  ivec2 stored = kindAt(ivec3(cell));
  if (stored.x >= EMPTY)
  {
    return 0.0;
  }
  Sample found = noSample();
  int pieces = 1;
#ifdef PAINT_FILTER
  Footprint footprint = Footprint(size[0] * voxels, size[1] * voxels, size[2] * voxels);
  found.IsWide = isWide(stored.y, footprint);
  if (!lookUpCell(place, cell, stored.x, found.IsWide, found))
  {
    return 0.0;
  }
  if (found.IsWide)
  {
    setFootprint(found, footprint);
    pieces = found.Pieces;
  }
#else
  if (!lookUpCell(place, cell, stored.x, false, found))
  {
    return 0.0;
  }
#endif
  float strength = strengthAt(place);
  float extinction = 0.0;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < pieces && strength > 0.0; ++i)
  {
    vec4 paint;
    if (takePiece(found, i, sum, paint) && paint.a > 0.0)
    {
      paint *= strength;
      float depth = depthOf(paint.a);
      extinction += depth;
      color += paint.rgb * (depth / paint.a);
    }
  }
  color /= max(extinction, 1e-30);
  return extinction * inverseUnitDistance / float(partsOf(found));
}

#ifdef SHADE
vec3 axisAt(vec3 p)
{
  return axisAtVoxel(p * voxels - 0.5);
}
#endif
