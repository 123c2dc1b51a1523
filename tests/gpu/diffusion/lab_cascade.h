// SPDX-License-Identifier: MIT
// The cascade of the product over one square.
#pragma once

#include "lab.h"
#include "passes/cascade_steps.h"
#include "passes/frame_data.h"
#include "passes/light_pool.h"
#include "scene/unwrap.h"

namespace dermis::lab {

class LabCascade {
 public:
  LabCascade(passes::FramePlan& plan, const Experiment& e, const scene::SkinMesh& skin,
             frame::TextureId light, frame::TextureId stretch);
  std::uint32_t coarsest() const { return static_cast<std::uint32_t>(unspread_.size()) - 1; }
  passes::MappedTerms terms() const;
  /// Adds the passes; returns the map of the sum.
  frame::TextureId add();

 private:
  std::vector<passes::MapSquare> on(std::uint32_t halvings) const { return {{.halvings = halvings}}; }
  frame::TextureId make(const std::string& name, std::uint32_t halvings);
  void climb(std::uint32_t halvings, std::uint32_t step);
  void add_step(std::uint32_t number);
  void add_gutters(std::uint32_t halvings);

  passes::FramePlan* plan_;
  const Experiment* e_;
  std::uint32_t narrow_ = 0;
  std::vector<passes::CascadeStep> steps_;
  frame::TextureId stretch_;
  std::vector<frame::TextureId> unspread_, spread_, scratch_;  // by halvings
  std::uint32_t halvings_ = 0;
};

}  // namespace dermis::lab
