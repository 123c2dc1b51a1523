// SPDX-License-Identifier: MIT
/// The pipeline that draws ImGui's lists.
#pragma once

#include "viewer/window/owned.h"

namespace dermis::viewer {

/// `layout`: a texture at set 0, binding 0, and four floats of push constants.
Owned<VkPipeline> make_ui_pipeline(VkDevice device, VkPipelineLayout layout, VkFormat target);

}  // namespace dermis::viewer
