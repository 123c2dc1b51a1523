// SPDX-License-Identifier: MIT
#include "tissue/profile/tabulated.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/one_line.h"

namespace dermis::profile {
namespace {

using std::numbers::pi;
constexpr std::size_t max_rows = 100'000;

std::string_view trim(std::string_view text) {
  while (!text.empty() && (text.back() == '\r' || text.back() == ' ' || text.back() == '\t'))
    text.remove_suffix(1);
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  return text;
}

/// Returns text fit for a message: one line, at most 60 bytes.
std::string shown(std::string_view text) { return one_line(text, 60); }

std::array<double, 4> parse_row(std::string_view line, const std::string& place) {
  std::array<double, 4> row{};
  for (int column = 0; column < 4; ++column) {
    const std::size_t comma = line.find(',');
    if ((comma == std::string_view::npos) != (column == 3))
      throw input_error(place, "expected four numbers r_mm,R,G,B");
    const std::string_view field = trim(line.substr(0, comma));
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), row[column]);
    if (error != std::errc() || end != field.data() + field.size())
      throw input_error(place, "'{}' is not a number", shown(field));
    if (!(row[column] >= 0 && row[column] <= 1e12))
      throw input_error(place, "values must be 0 to 1e12, got {}", row[column]);
    if (comma != std::string_view::npos) line.remove_prefix(comma + 1);
  }
  return row;
}

std::string without_spaces(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (c != ' ' && c != '\t' && c != '\r') out += c;
  return out;
}

}  // namespace

Tabulated::Tabulated(std::vector<double> radii_mm, std::vector<double> values_per_mm2,
                     const std::string& where)
    : radii_mm_(std::move(radii_mm)), values_(std::move(values_per_mm2)) {
  if (radii_mm_.size() < 2 || radii_mm_.size() != values_.size())
    throw input_error(where, "a profile needs at least two rows, got {}", radii_mm_.size());
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (!(values_[i] >= 0) || !(radii_mm_[i] >= 0) || (i > 0 && !(radii_mm_[i] > radii_mm_[i - 1])))
      throw input_error(where, "row {}: radii must rise from row to row, and values be >= 0", i);
  // The disc within the first radius, then 2 pi times the integral of r times each linear piece.

  total_ = pi * radii_mm_.front() * radii_mm_.front() * values_.front();
  for (std::size_t i = 0; i + 1 < radii_mm_.size(); ++i) {
    const double r0 = radii_mm_[i], r1 = radii_mm_[i + 1], h = r1 - r0;
    // Int r (v0 + (v1 - v0)(r - r0)/h) dr over the piece
    total_ += 2 * pi * h * (values_[i] * (2 * r0 + r1) + values_[i + 1] * (r0 + 2 * r1)) / 6;
  }
  if (!(total_ > 0) || !std::isfinite(total_)) throw input_error(where, "the profile is 0 everywhere");
}

double Tabulated::at(double radius_mm) const {
  if (radius_mm <= radii_mm_.front()) return values_.front();
  const auto above = std::upper_bound(radii_mm_.begin(), radii_mm_.end(), radius_mm);
  if (above == radii_mm_.end()) return radius_mm == radii_mm_.back() ? values_.back() : 0;
  const std::size_t i = static_cast<std::size_t>(above - radii_mm_.begin());
  const double part = (radius_mm - radii_mm_[i - 1]) / (radii_mm_[i] - radii_mm_[i - 1]);
  return values_[i - 1] + part * (values_[i] - values_[i - 1]);
}

double Tabulated::inner_mm() const {
  return std::max(radii_mm_.front() > 0 ? radii_mm_.front() : radii_mm_[1], 1e-5 * radii_mm_.back());
}

std::array<ProfilePtr, 3> parse_csv(std::string_view text, const std::string& where) {
  std::vector<double> radii;
  std::array<std::vector<double>, 3> values;
  bool header = false;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // the byte order mark that spreadsheets write

  for (int number = 1; !text.empty(); ++number) {
    const std::size_t newline = text.find('\n');
    const std::string_view line = trim(text.substr(0, newline));
    text.remove_prefix(newline == std::string_view::npos ? text.size() : newline + 1);
    if (line.empty() || line.front() == '#') continue;

    const std::string place = fmt::format("{}: line {}", where, number);
    if (!header) {
      if (line.find('\r') != std::string_view::npos)
        throw input_error(where, "its lines end with a carriage return alone; save it with line feeds");
      if (without_spaces(line) != "r_mm,R,G,B")
        throw input_error(place, "expected the header r_mm,R,G,B (mm, 1/mm^2), got '{}'", shown(line));
      header = true;
      continue;
    }

    const auto row = parse_row(line, place);
    if (!radii.empty() && !(row[0] > radii.back()))
      throw input_error(place, "radii must rise: {} mm after {} mm", row[0], radii.back());
    if (radii.size() == max_rows) throw input_error(place, "more than {} rows", max_rows);
    radii.push_back(row[0]);
    for (int c = 0; c < 3; ++c) values[c].push_back(row[c + 1]);
  }

  if (!header) throw input_error(where, "empty; expected the header r_mm,R,G,B and rows below it");
  std::array<ProfilePtr, 3> profiles;
  for (int c = 0; c < 3; ++c)
    profiles[c] = std::make_shared<Tabulated>(radii, std::move(values[c]), where + ": column " + "RGB"[c]);
  return profiles;
}

std::array<ProfilePtr, 3> load_csv(const std::filesystem::path& path) {
  const auto bytes = read_file(path, 32 << 20, true);
  return parse_csv({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path.string());
}

}  // namespace dermis::profile
