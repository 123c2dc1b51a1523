// SPDX-License-Identifier: MIT
// Turns real spherical harmonics up to order 5, those of environment/harmonics.h, by any rotation. One text
// for the shader, in floats, and for the test of its maths, in doubles.
//
// Based on: Kautz, Sloan, Snyder: Fast, Arbitrary BRDF Shading for Low-Frequency Lighting Using Spherical
// Harmonics. EGRW 2002, appendix (a rotation as turns about the axis of the harmonics, and quarter turns that
// are constant)
//
// No loop is longer than 18. The software driver unrolls up to 32; arrays whose index it does not know it
// puts into memory, which made the pass 20 times slower.
#ifndef DERMIS_SHARED_TURNED_HARMONICS_H
#define DERMIS_SHARED_TURNED_HARMONICS_H
#define HARMONICS_36 36

#ifdef __cplusplus
#include <array>
#include <glm/glm.hpp>
#define DERMIS_INLINE inline
#define DERMIS_HARMONICS(name) std::array<Real, HARMONICS_36>& name
namespace dermis::io {
using Real = double;
using Real2 = glm::dvec2;
using Real4 = glm::dvec4;
#else
#define DERMIS_INLINE
#define DERMIS_HARMONICS(name) inout float name[HARMONICS_36]
#define Real float
#define Real2 vec2
#define Real4 vec4
#endif

DERMIS_INLINE Real2 complex_product(Real2 a, Real2 b) {
  return Real2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

DERMIS_INLINE Real2 unit_complex(Real2 v) {
  const Real size = length(v);
  return size > Real(1e-18) ? v / size : Real2(1.0, 0.0);
}

// Degrees m and -m of order l, by turn = e^(i m angle). Indices are constants, so that the device keeps the
// terms in registers.
#define TURN_PAIR(l, m)                                                            \
  {                                                                                \
    const Real cosine = h[(l) * ((l) + 1) + (m)], sine = h[(l) * ((l) + 1) - (m)]; \
    h[(l) * ((l) + 1) + (m)] = cosine * turn.x - sine * turn.y;                    \
    h[(l) * ((l) + 1) - (m)] = cosine * turn.y + sine * turn.x;                    \
  }

// Turns about +Y by the angle of e, |e| = 1, from +Z towards +X.
DERMIS_INLINE void turn_about_y(DERMIS_HARMONICS(h), Real2 e) {
  Real2 turn = e;
  TURN_PAIR(1, 1);
  TURN_PAIR(2, 1);
  TURN_PAIR(3, 1);
  TURN_PAIR(4, 1);
  TURN_PAIR(5, 1);
  turn = complex_product(turn, e);
  TURN_PAIR(2, 2);
  TURN_PAIR(3, 2);
  TURN_PAIR(4, 2);
  TURN_PAIR(5, 2);
  turn = complex_product(turn, e);
  TURN_PAIR(3, 3);
  TURN_PAIR(4, 3);
  TURN_PAIR(5, 3);
  turn = complex_product(turn, e);
  TURN_PAIR(4, 4);
  TURN_PAIR(5, 4);
  turn = complex_product(turn, e);
  TURN_PAIR(5, 5);
}

// Turns about +X by 90 degrees: +Y becomes +Z.
DERMIS_INLINE void quarter_turn_about_x(DERMIS_HARMONICS(h)) {
  Real turned[HARMONICS_36];
  for (int k = 0; k < HARMONICS_36 / 2; ++k) turned[2 * k] = turned[2 * k + 1] = Real(0.0);
#define QUARTER_TURN(to, from, weight) turned[to] += Real(weight) * h[from];
#include "render/shared/quarter_turn.inc"
#undef QUARTER_TURN
  turned[0] = h[0];
  for (int k = 0; k < HARMONICS_36 / 2; ++k) {
    h[2 * k] = turned[2 * k];
    h[2 * k + 1] = turned[2 * k + 1];
  }
}

// Turns by a unit quaternion (x, y, z, w): what lay at d lies at q d q^-1.
//
// q = Ry(a) Rz(b) Ry(c) has w + i y = cos(b/2) e^(i (a + c) / 2) and z + i x = sin(b/2) e^(i (a - c) / 2). So
// no angle is needed: a, b and c are products of unit complex numbers. If one of the two is 0, only a + c or
// only a - c counts, and any value of the other serves.
//
// A quarter turn Q about +X takes Ry(b) to Rz(b) = Q Ry(b) Q^-1, and Q^-1 = Ry(pi) Q Ry(pi). The turns by pi
// join those by b and c.
DERMIS_INLINE void turn_harmonics(DERMIS_HARMONICS(h), Real4 q) {
  const Real2 whole = Real2(q.w, q.y), part = Real2(q.z, q.x);
  const Real2 half_sum = unit_complex(whole), half_difference = unit_complex(part);
  const Real2 a = complex_product(half_sum, half_difference);
  const Real2 b =
      unit_complex(Real2(dot(whole, whole) - dot(part, part), Real(2.0) * length(whole) * length(part)));
  const Real2 c = complex_product(half_sum, Real2(half_difference.x, -half_difference.y));

  turn_about_y(h, -c);
  quarter_turn_about_x(h);
  turn_about_y(h, -b);
  quarter_turn_about_x(h);
  turn_about_y(h, a);
}

#undef TURN_PAIR
#ifdef __cplusplus
}  // namespace dermis::io
#endif
#endif
