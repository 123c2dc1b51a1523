// SPDX-License-Identifier: MIT
#include "tools/dataset/distribution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "base/core/error.h"
#include "tools/dataset/exact.h"
#include "tools/dataset/philox.h"

namespace dermis::dataset {
namespace {

enum class Kind { uniform, whole, log_uniform, normal, choice, table };
constexpr std::array<const char*, 6> kind_names{"uniform", "whole",  "log_uniform",
                                                "normal",  "choice", "table"};
constexpr double most_whole = 1e9;
constexpr int most_attempts = 100'000;
// The range to which a normal distribution is cut must hold a tenth of a deviation within two of them: it is
// hit in one of 200 attempts.
constexpr double within_deviations = 2, least_width = 0.1;

std::optional<Kind> kind_of(const std::function<bool(const char*)>& has) {
  for (std::size_t i = 0; i < kind_names.size(); ++i)
    if (has(kind_names[i])) return static_cast<Kind>(i);
  return std::nullopt;
}
std::optional<Kind> kind_of(const Json& tree) {
  if (!tree.is_object()) return std::nullopt;
  return kind_of([&](const char* name) { return tree.contains(name); });
}

std::string member(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}
std::string element(const std::string& path, std::size_t i) { return fmt::format("{}[{}]", path, i); }

// Two numbers of an array, the second one above the first.
std::array<double, 2> range(const json::Value& object, const char* key) {
  const std::vector<double> numbers = object.numbers(key, 2);
  if (!(numbers[0] < numbers[1]))
    object.at(key).fail("must be [least, most] with least below most, got [{:g}, {:g}]", numbers[0],
                        numbers[1]);
  return {numbers[0], numbers[1]};
}

void check_weights(const json::Value& object, std::size_t count) {
  const std::vector<double> weights = object.numbers("weights", count);
  for (std::size_t i = 0; i < weights.size(); ++i) object.at("weights").element(i).number(0, 1e9);
  if (!weights.empty() && !(std::accumulate(weights.begin(), weights.end(), 0.0) > 0))
    object.at("weights").fail("are all 0");
}

void check_normal(const json::Value& object) {
  object.only_keys({"normal", "within"});
  const std::vector<double> normal = object.numbers("normal", 2);
  const double mean = normal[0], deviation = normal[1];
  if (!(deviation > 0)) object.at("normal").fail("must be [mean, deviation] with a deviation above 0");
  if (!object.has("within")) object.fail("a normal distribution needs \"within\": [least, most]");
  const auto [least, most] = range(object, "within");
  const double low = std::max(least, mean - within_deviations * deviation),
               high = std::min(most, mean + within_deviations * deviation);
  if (high - low < least_width * deviation)
    object.at("within").fail(
        "holds too little of the distribution: less than a tenth of a deviation within two "
        "of the mean");
}

void check_table(const json::Value& object) {
  object.only_keys({"table"});
  const json::Value table = object.at("table").object();
  table.only_keys({"edges", "weights"});
  const std::vector<double> edges = table.numbers("edges", 0);
  if (edges.size() < 2) table.fail("needs at least two \"edges\"");
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (!(edges[i - 1] < edges[i])) table.at("edges").fail("must rise, element {} does not", i);
  if (!table.has("weights")) table.fail("needs \"weights\", one fewer than edges");
  check_weights(table, edges.size() - 1);
}

void check_one(Kind kind, const json::Value& object) {
  switch (kind) {
    case Kind::uniform:
      object.only_keys({"uniform"});
      range(object, "uniform");
      return;
    case Kind::whole: {
      object.only_keys({"whole"});
      range(object, "whole");
      for (std::size_t i = 0; i < 2; ++i) {
        const json::Value number = object.at("whole").element(i);
        if (!number.is_integer()) number.fail("must be a whole number");
        number.number(-most_whole, most_whole);
      }
      return;
    }
    case Kind::log_uniform:
      object.only_keys({"log_uniform"});
      if (!(range(object, "log_uniform")[0] > 1e-30)) object.at("log_uniform").fail("must be above 0");
      return;
    case Kind::normal: return check_normal(object);
    case Kind::choice: {
      object.only_keys({"choice", "weights"});
      const json::Value choices = object.at("choice");
      const std::size_t count = choices.array_size();
      if (object.has("weights")) check_weights(object, count);
      for (std::size_t i = 0; i < count; ++i) check_distributions(choices.element(i));
      return;
    }
    case Kind::table: return check_table(object);
  }
}

std::size_t weighted(const Json& weights, double u) {
  double sum = 0;
  for (const Json& weight : weights) sum += weight.get<double>();
  double left = u * sum;
  std::size_t last = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double weight = weights[i].get<double>();
    if (weight > 0) last = i;
    if (left < weight) return i;
    left -= weight;
  }
  return last;  // u * sum was rounded up
}

std::size_t choose(const Json& node, Stream& stream) {
  const std::size_t count = node["choice"].size();
  const double u = stream.next();
  if (node.contains("weights")) return weighted(node["weights"], u);
  return std::min(static_cast<std::size_t>(u * static_cast<double>(count)), count - 1);
}

double draw_normal(const Json& node, Stream& stream) {
  const double mean = node["normal"][0], deviation = node["normal"][1];
  const double least = node["within"][0], most = node["within"][1];
  for (int i = 0; i < most_attempts; ++i) {
    const double x = mean + deviation * normal_quantile(stream.next() + 0x1p-54);
    if (x >= least && x <= most) return x;
  }
  throw InternalError("a normal distribution gave no number within its bounds");
}

double draw_table(const Json& table, Stream& stream) {
  const std::size_t bin = weighted(table["weights"], stream.next());
  const double low = table["edges"][bin], high = table["edges"][bin + 1];
  return low + stream.next() * (high - low);
}

Json draw_number(Kind kind, const Json& node, Stream& stream) {
  if (kind == Kind::normal) return draw_normal(node, stream);
  if (kind == Kind::table) return draw_table(node["table"], stream);

  const Json& bounds = node[kind_names[static_cast<std::size_t>(kind)]];
  const double low = bounds[0], high = bounds[1], u = stream.next();
  if (kind == Kind::whole) return static_cast<std::int64_t>(low + std::floor(u * (high - low + 1)));
  if (kind == Kind::uniform) return low + u * (high - low);
  const double a = exact_log(low), x = exact_exp(a + u * (exact_log(high) - a));
  return std::clamp(x, low, high);
}

/// Gives values in place of distributions.
class Picker {
 public:
  virtual ~Picker() = default;
  virtual std::size_t choice(const Json& node, const std::string& path) = 0;
  virtual Json number(Kind kind, const Json& node, const std::string& path) = 0;
};

Json resolved(const Json& tree, const std::string& path, Picker& picker) {
  if (const auto kind = kind_of(tree)) {
    if (*kind != Kind::choice) return picker.number(*kind, tree, path);
    const std::size_t i = picker.choice(tree, path);
    return resolved(tree["choice"][i], element(path, i), picker);
  }
  Json out = tree;
  if (tree.is_object())
    for (auto& [key, value] : out.items()) value = resolved(tree[key], member(path, key), picker);
  if (tree.is_array())
    for (std::size_t i = 0; i < tree.size(); ++i) out[i] = resolved(tree[i], element(path, i), picker);
  return out;
}

class Drawing : public Picker {
 public:
  Drawing(std::uint32_t seed, const NumberOf& number_of) : seed_(seed), number_of_(number_of) {}
  std::size_t choice(const Json& node, const std::string& path) override {
    Stream stream = stream_of(path);
    return choose(node, stream);
  }
  Json number(Kind kind, const Json& node, const std::string& path) override {
    Stream stream = stream_of(path);
    return draw_number(kind, node, stream);
  }

 private:
  Stream stream_of(const std::string& path) const { return {seed_, path, number_of_(path)}; }
  std::uint32_t seed_;
  const NumberOf& number_of_;
};

/// Takes the first alternative everywhere but in one place, and notes how many each place has.
class Alternatives : public Picker {
 public:
  std::map<std::string, std::size_t> picked, seen;

  std::size_t choice(const Json& node, const std::string& path) override {
    return pick(path, node["choice"].size());
  }
  Json number(Kind kind, const Json& node, const std::string& path) override {
    const std::size_t i = pick(path, kind == Kind::whole ? 2 : 3);
    const Json& ends = kind == Kind::table    ? node["table"]["edges"]
                       : kind == Kind::normal ? node["within"]
                                              : node[kind_names[static_cast<std::size_t>(kind)]];
    if (i < 2) return i == 0 ? ends.front() : ends.back();
    // No whole number: where one must stand, this shows that it does not.
    const double low = ends.front(), high = ends.back(), inside = low + 0.3819660113 * (high - low);
    return inside == std::floor(inside) ? low + 0.2360679775 * (high - low) : inside;
  }

 private:
  std::size_t pick(const std::string& path, std::size_t count) {
    seen[path] = count;
    const auto found = picked.find(path);
    return found == picked.end() ? 0 : found->second;
  }
};

}  // namespace

bool is_distribution(const Json& tree) { return kind_of(tree).has_value(); }

void check_distributions(const json::Value& value) {
  if (value.is_object()) {
    if (const auto kind = kind_of([&](const char* name) { return value.has(name); }))
      return check_one(*kind, value);
    for (const std::string& key : value.keys()) check_distributions(value.at(key));
  }
  if (value.is_array())
    for (std::size_t i = 0; i < value.array_size(0); ++i) check_distributions(value.element(i));
}

Json drawn(const Json& tree, const std::string& path, std::uint32_t seed, const NumberOf& number_of) {
  Drawing drawing(seed, number_of);
  return resolved(tree, path, drawing);
}

std::vector<Json> extremes(const Json& tree, const std::string& path, std::size_t most) {
  std::vector<Json> found;
  std::set<std::string> known;
  std::deque<std::map<std::string, std::size_t>> waiting{{}};
  while (!waiting.empty()) {
    Alternatives picker;
    picker.picked = waiting.front();
    waiting.pop_front();
    if (found.size() == most) throw input_error(path, "has more than {} distributions and choices", most);
    found.push_back(resolved(tree, path, picker));
    for (const auto& [place, count] : picker.seen) {
      if (!known.insert(place).second) continue;
      for (std::size_t i = 1; i < count; ++i) {
        // The picks that led to this place stay.
        waiting.push_back(picker.picked);
        waiting.back()[place] = i;
      }
    }
  }
  return found;
}

std::vector<std::string> paths_of(const Json& tree, const std::string& path) {
  std::vector<std::string> paths;
  const auto add = [&paths](std::vector<std::string> more) {
    paths.insert(paths.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  if (const auto kind = kind_of(tree)) {
    paths.push_back(path);
    if (*kind == Kind::choice)
      for (std::size_t i = 0; i < tree["choice"].size(); ++i)
        add(paths_of(tree["choice"][i], element(path, i)));
    return paths;
  }
  if (tree.is_object())
    for (const auto& [key, value] : tree.items()) add(paths_of(value, member(path, key)));
  if (tree.is_array())
    for (std::size_t i = 0; i < tree.size(); ++i) add(paths_of(tree[i], element(path, i)));
  return paths;
}

}  // namespace dermis::dataset
