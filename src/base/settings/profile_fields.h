// SPDX-License-Identifier: MIT
// Inputs of profiles, a row for each.
#pragma once

#include "base/core/fields.h"
#include "dermis/profile.h"

namespace dermis {

template <>
inline constexpr auto fields_of<ProfileOptions> = std::tuple{
    Field{"gaussians",
          &ProfileOptions::gaussians,
          {.help = "terms of the sum", .least = 1, .most = 8, .option = "gaussians", .common = true}},
    Field{"model",
          &ProfileOptions::model,
          {.help = "model of the spread of light", .option = "model", .common = true}},
    Field{"fit",
          &ProfileOptions::fit,
          {.help = "the Gaussians match R over the plane, or the light within each radius", .option = "fit"}},
    Field{"photons",
          &ProfileOptions::photons,
          {.help = "Monte-Carlo: photons per channel", .least = 1000, .most = 1e9, .option = "photons"}},
    Field{"seed",
          &ProfileOptions::seed,
          {.help = "Monte-Carlo: equal seeds give equal bits", .option = "seed"}}};

template <>
inline constexpr auto fields_of<Coefficients> = std::tuple{
    Field{"sigma_a_per_mm",
          &Coefficients::sigma_a_per_mm,
          // 1e6 is a mean free path of a nanometre: beyond any tissue, and far from overflow.
          {.help = "absorption", .unit = "per mm", .least = 0, .most = 1e6, .option = "coefficients"}},
    Field{"sigma_s_per_mm",
          &Coefficients::sigma_s_per_mm,
          {.help = "scattering", .unit = "per mm", .least = 0, .most = 1e6, .option = "coefficients"}},
    Field{"g",
          &Coefficients::g,
          {.help = "mean cosine of the phase function",
           .least = -1,
           .most = 1,
           .open = true,
           .option = "coefficients"}},
    Field{"eta",
          &Coefficients::eta,
          {.help = "refractive index, relative to the air above",
           .least = 1,
           .most = 3,
           .option = "coefficients"}}};

template <>
inline constexpr auto fields_of<SpectralSkin> = std::tuple{
    Field{"melanin",
          &SpectralSkin::melanin,
          {.help = "volume fraction of melanin in the epidermis",
           .least = 0,
           .most = 0.5,
           .option = "melanin",
           .common = true}},
    Field{"blend",
          &SpectralSkin::blend,
          {.help = "eumelanin's share of the melanin", .least = 0, .most = 1, .option = "blend"}},
    Field{"haemoglobin",
          &SpectralSkin::haemoglobin,
          {.help = "volume fraction of blood in the dermis",
           .least = 0,
           .most = 0.1,
           .option = "hemoglobin",
           .common = true}},
    Field{"oxygenation",
          &SpectralSkin::oxygenation,
          {.help = "share of the blood that carries oxygen", .least = 0, .most = 1, .option = "oxygenation"}},
    Field{"epidermis_mm",
          &SpectralSkin::epidermis_mm,
          {.help = "thickness of the epidermis",
           .unit = "mm",
           .least = 0.01,
           .most = 2,
           .option = "epidermis-mm"}}};

}  // namespace dermis
