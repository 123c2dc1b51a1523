// SPDX-License-Identifier: MIT
#include "made_up.h"

namespace dermis::frame::test {
namespace {

void touch(Declare& d, Access access, TextureId id) {
  switch (access) {
    case Access::sampled: return d.sample(id);
    case Access::storage_read: return d.read(id);
    case Access::storage_write: return d.write(id);
    case Access::colour_target: return d.colour(id);
    case Access::depth_target: return d.depth(id);
    case Access::copy_source: return d.copy_from(id);
    case Access::copy_target: return d.copy_to(id);
    case Access::indirect_arguments:
    case Access::indices: break;
  }
  DERMIS_ASSERT(access == Access::sampled);
}

void touch(Declare& d, Access access, BufferId id) {
  switch (access) {
    case Access::storage_read: return d.read(id);
    case Access::storage_write: return d.write(id);
    case Access::copy_source: return d.copy_from(id);
    case Access::copy_target: return d.copy_to(id);
    case Access::indirect_arguments: return d.indirect(id);
    case Access::indices: return d.indices(id);
    default: break;
  }
  DERMIS_ASSERT(access == Access::storage_read);
}

}  // namespace

MadeUp::Out MadeUp::declare(Declare& d) const {
  d.kind(settings.kind);
  d.runs(settings.runs);
  for (const Touch& t : settings.touches) std::visit([&](auto id) { touch(d, t.access, id); }, t.what);
  return {};
}

}  // namespace dermis::frame::test
