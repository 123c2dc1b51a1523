// SPDX-License-Identifier: MIT
#include "image/tone_map.h"

#include <algorithm>
#include <cmath>

#include "base/core/assert.h"
#include "base/core/parallel.h"
#include "image/colour.h"

namespace dermis::image {
namespace {

using Matrix = std::array<Colour, 3>;  // rows

Colour multiply(const Matrix& m, const Colour& c) {
  Colour out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][0] * c[0] + m[i][1] * c[1] + m[i][2] * c[2];
  return out;
}

template <class Function>
Colour each(const Colour& c, const Function& function) {
  return {function(c[0]), function(c[1]), function(c[2])};
}

float clamp_to_one(float value) { return std::min(value, 1.0f); }

// NaN compares false and becomes 0.
float light_of(float value) { return value > 0 ? std::min(value, max_half) : 0.0f; }

float greatest(const Colour& c) { return std::max({c[0], c[1], c[2]}); }

// [PBRN] K_d: how fast bright colours lose chroma.
constexpr float desaturation = 0.15f;

// [PBRN] p_n: the largest channel p > begin after compression, below 1. Starts at `begin` with slope 1.
float compressed_peak(float p, float begin) { return 1 - (1 - begin) * (1 - begin) / (p + 1 - 2 * begin); }

// [PBRN] g: the share of the colour that is kept; the rest becomes white.
float kept_chroma(float p, float p_n) { return 1 / (desaturation * (p - p_n) + 1); }

// [PBRN] Fresnel reflectance of index 1.5 at normal incidence, which its toe subtracts.
constexpr float f90 = 0.04f;

Colour neutral(const Colour& c) {
  constexpr float begin = 0.8f - f90;

  // The toe subtracts light that a glossy surface reflects everywhere.
  const float x = std::min({c[0], c[1], c[2]});
  const float f = x <= 2 * f90 ? x - x * x / (4 * f90) : f90;
  const Colour without = each(c, [&](float v) { return v - f; });

  // The shoulder and the blend to white.
  const float p = greatest(without);
  if (p <= begin) return without;
  const float p_n = compressed_peak(p, begin), g = kept_chroma(p, p_n);
  return each(without, [&](float v) { return v * (p_n / p) * g + p_n * (1 - g); });
}

// Departs from [PBRN] in two ways.
// - No toe: subtracting 0.04 from every channel multiplies the chroma of dark skin by up to 1.7. The shoulder
//   then begins at 0.8, the brightest base colour that [PBRN] promises to keep.
// - Blends to white in cube roots, as CIELAB measures colour. A blend in linear light shifts the CIELAB hue
//   of measured skin by up to 5.1 degrees between 0.8 and 16, this one by 3.6.
Colour natural(const Colour& c) {
  constexpr float begin = 0.8f;
  const float p = greatest(c);
  if (p <= begin) return c;

  const float p_n = compressed_peak(p, begin), g = kept_chroma(p, p_n);
  const float white = std::cbrt(p_n);
  return each(c, [&](float v) {
    const float root = std::cbrt(v * (p_n / p)) * g + white * (1 - g);
    return root * root * root;
  });
}

// ITU-R BT.2087: linear Rec.709 to Rec.2020, and back.
constexpr Matrix rec2020_of_rec709{{{0.62740390f, 0.32928304f, 0.04331307f},
                                    {0.06909729f, 0.91954040f, 0.01136232f},
                                    {0.01639144f, 0.08801331f, 0.89559525f}}};
constexpr Matrix rec709_of_rec2020{{{1.66049100f, -0.58764114f, -0.07284986f},
                                    {-0.12455047f, 1.13289990f, -0.00834942f},
                                    {-0.01815076f, -0.10057890f, 1.11872966f}}};
// [AgX] moves the primaries inwards before the curve, so that bright colours can reach white, and outwards
// after it.
constexpr Matrix agx_inset{{{0.85662715f, 0.09512124f, 0.04825161f},
                            {0.13731897f, 0.76124199f, 0.10143904f},
                            {0.11189821f, 0.07679942f, 0.81130237f}}};
constexpr Matrix agx_outset{{{1.12710058f, -0.11060664f, -0.01649394f},
                             {-0.14132976f, 1.15782370f, -0.01649394f},
                             {-0.14132976f, -0.11060664f, 1.25193641f}}};

// [AgX]: from 10 stops below a grey of 0.18 to 6.5 above it, along a contrast curve to a display value.
float agx_curve(float light) {
  constexpr float least_ev = -12.47393f, greatest_ev = 4.026069f;
  const float ev = std::clamp(std::log2(std::max(light, 1e-10f)), least_ev, greatest_ev);
  const float x = (ev - least_ev) / (greatest_ev - least_ev);
  return -0.00232f + x * (0.1191f + x * (0.4298f + x * (-6.868f + x * (31.96f + x * (-40.14f + x * 15.5f)))));
}

Colour agx(const Colour& c) {
  const Colour inset = multiply(agx_inset, multiply(rec2020_of_rec709, c));
  const Colour shown = multiply(agx_outset, each(inset, agx_curve));

  // The curve gives values for a display of gamma 2.2.
  const Colour light = each(shown, [](float v) { return std::pow(std::max(v, 0.0f), 2.2f); });
  return each(multiply(rec709_of_rec2020, light), [](float v) { return std::clamp(v, 0.0f, 1.0f); });
}

// x is at most max_half, whose square a float holds.
float narkowicz(float x) { return clamp_to_one(x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f)); }

}  // namespace

Colour tone_mapped(ToneMap tone_map, const Colour& linear) {
  const Colour light = each(linear, light_of);
  switch (tone_map) {
    case ToneMap::natural: return natural(light);
    case ToneMap::neutral: return neutral(light);
    case ToneMap::agx: return agx(light);
    case ToneMap::filmic: return each(light, narkowicz);
    case ToneMap::srgb:
    case ToneMap::linear: break;
  }
  return each(light, clamp_to_one);
}

Colour to_display(ToneMap tone_map, const Colour& linear) {
  const Colour light = tone_mapped(tone_map, linear);
  return tone_map == ToneMap::linear ? light : each(light, linear_to_srgb);
}

std::array<std::uint8_t, 3> to_display8(ToneMap tone_map, const Colour& linear) {
  const Colour light = tone_mapped(tone_map, linear);
  std::array<std::uint8_t, 3> out{};
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = tone_map == ToneMap::linear ? static_cast<std::uint8_t>(std::lround(light[c] * 255.0f))
                                         : linear_to_srgb8(light[c]);
  return out;
}

Image8 to_display(const ImageF& linear, ToneMap tone_map) {
  DERMIS_ASSERT_LE(1, linear.channels);
  DERMIS_ASSERT_LE(linear.channels, 4);
  const bool grey = linear.channels < 3;
  const int alpha = linear.channels == 2 ? 1 : (linear.channels == 4 ? 3 : -1);
  Image8 shown{.width = linear.width, .height = linear.height, .rgba = {}};
  shown.rgba.resize(static_cast<std::size_t>(linear.width) * static_cast<std::size_t>(linear.height) * 4);

  parallel_for(static_cast<std::size_t>(linear.height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < linear.width; ++x) {
      const float* in = linear.at(x, y);
      const Colour colour = grey ? Colour{in[0], in[0], in[0]} : Colour{in[0], in[1], in[2]};
      std::uint8_t* out = shown.at(x, y);
      const auto values = to_display8(tone_map, colour);
      std::copy(values.begin(), values.end(), out);
      out[3] = alpha < 0 ? std::uint8_t{255}
                         : static_cast<std::uint8_t>(std::lround(clamp_to_one(light_of(in[alpha])) * 255.0f));
    }
  });

  return shown;
}

}  // namespace dermis::image
