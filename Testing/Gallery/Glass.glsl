  // Normals from a gradient may face away from the eye near a silhouette: turn them.
  normalVCVSOutput *= normalVCVSOutput.z < 0.0 ? -1.0 : 1.0;
  // More opaque where the surface turns away from the eye, as a wall of glass is.
  opacity *= mix(1.0, 4.0, pow(1.0 - normalVCVSOutput.z, 2.0));
  opacity = min(opacity, 0.9);
  //VTK::Light::Impl
