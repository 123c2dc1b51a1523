// SPDX-License-Identifier: MIT
#include <vector>

#include "base/core/error.h"
#include "base/core/known_names.h"
#include "render/techniques/burley_disc/burley_disc.h"
#include "render/techniques/lambert/lambert.h"
#include "render/techniques/pre_integrated/pre_integrated.h"
#include "render/techniques/published/published.h"
#include "render/techniques/screen_gaussians/screen_gaussians.h"
#include "render/techniques/separable/separable.h"
#include "render/techniques/technique.h"
#include "render/techniques/texture_space/texture_space.h"

namespace dermis::techniques {
namespace {

std::vector<const Technique*>& all() {
  static std::vector<const Technique*> list{&texture_space, &lambert,        &screen_gaussians, &separable,
                                            &burley_disc,   &pre_integrated, &published};
  return list;
}

}  // namespace

std::span<const Technique* const> techniques() { return all(); }

void add(const Technique& technique) {
  for (const Technique* t : all())
    if (t->name == technique.name) throw input_error("technique", "'{}' is in the list", technique.name);
  all().push_back(&technique);
}

const Technique& find_technique(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Technique* t : all()) {
    if (t->name == name) return *t;
    names.push_back(t->name);
  }
  throw input_error("technique", "{}", unknown_name(name, names));
}

}  // namespace dermis::techniques
