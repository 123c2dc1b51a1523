// SPDX-License-Identifier: MIT
// An evaluation of animated glTF files that shares nothing with the library's: JSON and bytes of the file,
// plain doubles, one matrix product at a time. No compression.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace dermis::scene::test {

class PosedByHand {
 public:
  using Point = std::array<double, 3>;

  explicit PosedByHand(const std::filesystem::path& file);

  bool is_compressed() const { return compressed_; }  ///< then none of the rest can be called
  std::size_t animations() const;
  double end_s(std::size_t animation) const;
  /// Returns the positions of all vertices of each primitive at each node, counted as dermis/asset.h does, m.
  std::vector<std::vector<Point>> positions_m(std::size_t animation, double seconds) const;
  /// Likewise, between two animations: share 0 is the first, 1 the second.
  std::vector<std::vector<Point>> blended_m(std::size_t first, double first_s, std::size_t second,
                                            double second_s, double share) const;

 private:
  using Json = nlohmann::json;
  using Matrix = std::array<double, 16>;  // column after column
  struct Node {
    std::vector<double> translation, rotation, scale, matrix, weights;
  };

  const std::vector<double>& numbers(std::size_t accessor) const;
  std::vector<double> read(const Json& accessor, const Json& at, std::size_t count) const;
  std::vector<Node> nodes_at(std::size_t animation, double seconds) const;
  std::vector<double> sampled(const Json& sampler, std::size_t size, bool turns, double seconds) const;
  std::vector<std::vector<Point>> positions_of(const std::vector<Node>& nodes) const;
  std::vector<Matrix> worlds(const std::vector<Node>& nodes) const;

  Json json_;
  std::vector<std::string> buffers_;
  bool compressed_ = false;
  mutable std::map<std::size_t, std::vector<double>> read_;
};

}  // namespace dermis::scene::test
