// SPDX-License-Identifier: MIT
#include "lab_cascade.h"

#include "passes/cascade/cascade.h"
#include "passes/cascade/cascade_io.h"
#include "passes/downsample/downsample.h"
#include "passes/gutters/gutters.h"
#include "passes/upsample/upsample.h"

namespace dermis::lab {

LabCascade::LabCascade(passes::FramePlan& plan, const Experiment& e, const scene::SkinMesh& skin,
                       frame::TextureId light, frame::TextureId stretch)
    : plan_(&plan), e_(&e), stretch_(stretch) {
  const scene::UnwrapDensity density = scene::unwrap_density(skin, e.scene.mm_per_unit);
  const passes::CascadeDensity texels{
      .max_texels_per_mm = density.largest_uv_per_mm.p95 * e.map_size,
      .mean_texels_per_mm = density.uv_per_mm.mean * e.map_size,
      .coarse_texels_per_mm = density.least_uv_per_mm.p25 * e.map_size * e.level_density};
  narrow_ = passes::narrow_terms(e.variances_mm2, texels.mean_texels_per_mm, MOST_NARROW);
  steps_ = passes::cascade_steps(e.variances_mm2, narrow_, texels, passes::max_halvings);

  // Each term on maps with half as many texels, as if they held them: the variance stays positive in the
  // middle of the map alone.
  if (e.wrong_level)
    for (passes::CascadeStep& step : steps_) {
      step.halvings = std::min(step.halvings + 1, passes::max_halvings);
      step.halvings_after = std::min(step.halvings_after + 1, passes::max_halvings);
    }
  if (e.wrong_level && !steps_.empty()) steps_.front().halvings_after = 0;
  for (passes::CascadeStep& step : steps_) {
    step.variance_mm2 *= e.variance_factor;
    step.total_mm2 *= e.variance_factor;
  }

  const std::uint32_t most = steps_.empty() ? 0 : steps_.back().halvings;
  for (std::uint32_t n = 0; n <= most; ++n) {
    unspread_.push_back(n == 0 ? light : make("unspread", n));
    spread_.push_back(make("spread", n));
    scratch_.push_back(make("scratch", n));
  }
}

frame::TextureId LabCascade::make(const std::string& name, std::uint32_t halvings) {
  const std::uint32_t side = static_cast<std::uint32_t>(e_->map_size) >> halvings;
  return plan_->texture(name + std::to_string(halvings),
                        {.width = side, .height = side, .format = VK_FORMAT_R16G16B16A16_SFLOAT});
}

passes::MappedTerms LabCascade::terms() const {
  passes::MappedTerms terms{.first_wide = narrow_};
  for (std::size_t i = 0; i < e_->variances_mm2.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      terms.weights[i][c] = e_->weights.empty() ? 1.0f : static_cast<float>(e_->weights[i][c]);
  return terms;
}

void LabCascade::add_gutters(std::uint32_t halvings) {
  plan_->add<passes::Gutters>("gutters", {spread_[halvings]}, {.squares = on(halvings)});
}

void LabCascade::climb(std::uint32_t halvings, std::uint32_t step) {
  for (; halvings_ > halvings; --halvings_) {
    const std::uint32_t to = halvings_ - 1;
    passes::Upsample::Settings up{.from = on(halvings_),
                                  .to = on(to),
                                  .steps = steps_,
                                  .step = step,
                                  .next_step = to == halvings && !e_->holds_all};
    if (to == halvings && step > 0) up.joins = steps_[step - 1].term;
    plan_->add<passes::Upsample>(
        "up", {spread_[halvings_], unspread_[to], spread_[to], stretch_, unspread_[to]}, up);
    add_gutters(to);
  }
}

void LabCascade::add_step(std::uint32_t number) {
  const bool widest = number + 1 == steps_.size();
  const std::uint32_t n = steps_[number].halvings;
  passes::CascadeBlur::Settings blur{.squares = on(n), .steps = steps_, .number = number};
  // What steps take off is what their levels say: without levels, nothing.
  if (e_->forget_moves)
    for (passes::CascadeStep& step : blur.steps) step.share = step.share_done = 0;
  plan_->add<passes::CascadeBlur>("u", {widest ? unspread_[n] : spread_[n], stretch_, scratch_[n]}, blur);

  blur.axis = 1;
  if (widest) blur.scales = steps_[number].term;
  if (number > 0 && steps_[number - 1].halvings == n) blur.joins = steps_[number - 1].term;
  plan_->add<passes::CascadeBlur>("v", {scratch_[n], stretch_, spread_[n], {}, unspread_[n]}, blur);
  add_gutters(n);
}

frame::TextureId LabCascade::add() {
  for (std::uint32_t n = 1; n < unspread_.size(); ++n) {
    plan_->add<passes::Downsample>("down", {unspread_[n - 1], stretch_, unspread_[n]},
                                   {.from = on(n - 1), .to = on(n)});
  }

  halvings_ = coarsest();
  for (std::size_t i = steps_.size(); i-- > 0;) {
    climb(steps_[i].halvings, static_cast<std::uint32_t>(i) + 1);
    add_step(static_cast<std::uint32_t>(i));
  }
  climb(0, 0);

  const frame::TextureId sum = make("sum", 0);
  plan_->add<passes::CascadeSum>("sum",
                                 {unspread_[0],
                                  stretch_,
                                  sum,
                                  {},
                                  steps_.empty() ? frame::TextureId{} : spread_[0],
                                  steps_.empty() ? frame::TextureId{} : scratch_[0]},
                                 {.squares = on(0), .variances_mm2 = e_->variances_mm2, .steps = steps_});
  plan_->add<passes::Gutters>("sum gutters", {sum}, {.squares = on(0)});
  return sum;
}

}  // namespace dermis::lab
