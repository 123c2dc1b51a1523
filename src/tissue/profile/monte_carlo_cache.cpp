// SPDX-License-Identifier: MIT
#include "tissue/profile/monte_carlo_cache.h"

#include <fmt/format.h>

#include <cmath>
#include <deque>
#include <mutex>
#include <optional>
#include <span>
#include <sstream>
#include <string_view>

#include "base/core/cache.h"

namespace dermis::profile {
namespace {

constexpr std::size_t kept_in_memory = 64, max_rings = 4096;
constexpr double largest_mm = 1e100;  // areas of rings stay finite
constexpr std::uint64_t most_bytes = 1 << 20;

struct Entry {
  std::string key;
  std::shared_ptr<const MonteCarloResult> result;
};
std::mutex mutex;
std::deque<Entry> memory;

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

std::filesystem::path file_of(const std::string& key, const std::filesystem::path& folder) {
  if (folder.empty()) return {};
  // the key inside the file settles collisions
  return folder / fmt::format("monte-carlo-{:016x}.txt", cache::checksum(bytes_of(key)));
}

void put(std::string& text, const std::vector<double>& values) {
  text += fmt::format("{}", values.size());
  // fmt prints the shortest text that reads back exactly
  for (const double value : values) text += fmt::format(" {}", value);
  text += '\n';
}

std::string write(const std::string& key, const MonteCarloResult& r) {
  std::string text = key + "\n";
  put(text, {r.reflected_total, r.reflected_total_error, r.transmitted_total, r.transmitted_total_error,
             r.ballistic, r.cut});
  put(text, r.absorbed);
  put(text, r.reflected.edges_mm());
  put(text, r.reflected.energies());
  put(text, r.reflected_error);
  put(text, r.transmitted.energies());
  return text;
}

bool get(std::istream& in, std::vector<double>& values, std::size_t expected) {
  std::size_t count = 0;
  if (!(in >> count) || count > max_rings || (expected != 0 && count != expected)) return false;
  values.assign(count, 0.0);
  for (double& value : values)
    if (!(in >> value) || !std::isfinite(value)) return false;
  return true;
}

/// Checks a fraction of the energy that entered. Roulette is right only on average, so that few photons may
/// return slightly more than 1.
bool is_part(double energy) { return energy >= 0 && energy <= 2; }

std::optional<MonteCarloResult> read(const std::string& key, const std::string& text) {
  std::istringstream in(text);
  std::string line;
  std::vector<double> totals, edges, reflected, transmitted;
  MonteCarloResult r;

  if (!std::getline(in, line) || line != key) return std::nullopt;
  if (!get(in, totals, 6) || !get(in, r.absorbed, 0) || !get(in, edges, 0) || edges.size() < 3)
    return std::nullopt;

  const std::size_t rings = edges.size() - 1;
  if (!get(in, reflected, rings) || !get(in, r.reflected_error, rings) || !get(in, transmitted, rings))
    return std::nullopt;

  // Checks that the edges rise from 0 and that energies are fractions of the light that entered.
  if (edges.front() != 0 || edges.back() > largest_mm) return std::nullopt;
  for (std::size_t i = 0; i < rings; ++i)
    if (!(edges[i] < edges[i + 1]) || !is_part(reflected[i]) || !is_part(transmitted[i])) return std::nullopt;

  r.reflected_total = totals[0];
  r.reflected_total_error = totals[1];
  r.transmitted_total = totals[2];
  r.transmitted_total_error = totals[3];
  r.ballistic = totals[4];
  r.cut = totals[5];
  r.reflected = Annuli(edges, std::move(reflected));
  r.transmitted = Annuli(std::move(edges), std::move(transmitted));
  return r;
}

void keep(const std::string& key, const std::shared_ptr<const MonteCarloResult>& result) {
  const std::lock_guard lock(mutex);
  memory.push_back({key, result});
  if (memory.size() > kept_in_memory) memory.pop_front();
}

}  // namespace

std::string cache_key(const ScatterScene& scene, const MonteCarloOptions& options) {
  std::string key = fmt::format("dermis monte-carlo 3 photons {} seed {} light {}", options.photons,
                                options.seed, static_cast<int>(scene.light));
  for (const ScatterLayer& layer : scene.layers) {
    const optics::Medium& m = layer.medium;
    key += fmt::format(" | {:a} {:a} {:a} {:a} {:a}", m.sigma_a_per_mm, m.sigma_s_per_mm, m.g, m.eta,
                       layer.thickness_mm);
  }
  return key;
}

std::shared_ptr<const MonteCarloResult> cached(const std::string& key, const std::filesystem::path& folder) {
  {
    const std::lock_guard lock(mutex);
    for (const Entry& entry : memory)
      if (entry.key == key) return entry.result;
  }
  const auto bytes = cache::read(file_of(key, folder), most_bytes);
  if (!bytes) return nullptr;
  auto result = read(key, std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()));
  if (!result) return nullptr;
  auto shared = std::make_shared<const MonteCarloResult>(std::move(*result));
  keep(key, shared);
  return shared;
}

void remember(const std::string& key, const std::filesystem::path& folder,
              const std::shared_ptr<const MonteCarloResult>& result) {
  keep(key, result);
  if (folder.empty()) return;
  const std::string text = write(key, *result);
  const auto bytes = bytes_of(text);
  cache::write(file_of(key, folder), {bytes.begin(), bytes.end()});
}

}  // namespace dermis::profile
