// SPDX-License-Identifier: MIT
// The files of a sample.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/dataset/studio.h"

namespace dermis::dataset {

/// A file of a sample: "depth.png" of 000123.depth.png.
struct Member {
  std::string ending;
  std::vector<std::byte> bytes;
};

struct Encoded {
  std::uint64_t sample = 0;
  std::vector<Member> members;
  std::string json_sha256;      ///< of its JSON
  std::string pictures_sha256;  ///< of the values of picture and labels, whatever encodes them
};

/// Returns the name of a sample, with which the names of its files begin.
std::string stem_of(const Recipe::State& recipe, std::uint64_t sample);
/// The endings of a sample's files, in their order.
std::vector<std::string> endings_of(const Recipe::State& recipe);

/// Throws InputError: a label has a number that its file does not hold.
Encoded encoded(const Recipe::State& recipe, const Drawn& drawn);

/// The hash of what was drawn, landmarks included: whether they are seen is of the picture.
std::string hash_of_pictures(const Recipe::State& recipe, const Drawn& drawn);

inline constexpr const char* landmarks_ending = "landmarks.json";

}  // namespace dermis::dataset
