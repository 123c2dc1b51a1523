// SPDX-License-Identifier: MIT
// Height of the rounded surface, for which a triangle stands, above it. Shadows
// are looked up from there: where light grazes a bent surface, its flat triangles would shadow themselves.
// Based on: [H21] Hanika: Hacking the Shadow Terminator. Ray Tracing Gems II, 2021, ch. 4, which lifts a
// point to the tangent plane of each corner that lies above it. Here the mean of the three planes lifts it,
// along its normal: that takes one value per vertex, which a raster can interpolate.

// Returns the distance of a vertex's tangent plane from the origin. n: unit.
float plane_distance(vec3 position, vec3 n) { return dot(position, n); }

// Returns the mean distance to the tangent planes of the corners, along the normal: above 0 where the surface
// is convex, below where it is hollow. All three are interpolated; the normal is not made unit again.
float bulge_at(vec3 position, vec3 normal, float plane) { return plane - dot(position, normal); }
