// SPDX-License-Identifier: MIT
#include "cli/sequence/frames.h"

#include <utility>

namespace dermis::cli::sequence {

Frames::Frames(Renderer& renderer, const RenderSettings& settings) : renderer_(renderer) {
  const bool steady = settings.output.exposure_ev && settings.output.show == OutputSettings{}.show;
  if (steady) session_.emplace(renderer);
}

std::optional<Frame> Frames::draw(std::size_t number, const Scene& scene, const RenderSettings& settings) {
  if (!session_) {
    if (prepared_)
      prepared_->set(scene, settings);
    else
      prepared_.emplace(renderer_.prepare(scene, settings));
    return Frame{number, prepared_->picture()};
  }

  const Ticket ticket = session_->draw(scene, settings);
  std::optional<Frame> before = finish();
  drawing_ = {number, ticket};
  return before;
}

std::optional<Frame> Frames::finish() {
  if (!drawing_) return std::nullopt;
  const Drawing drawing = *std::exchange(drawing_, std::nullopt);
  return Frame{drawing.number, session_->picture(drawing.ticket)};
}

}  // namespace dermis::cli::sequence
