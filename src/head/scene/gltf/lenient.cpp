// SPDX-License-Identifier: MIT
#include "head/scene/gltf/lenient.h"

#include <algorithm>

#include "base/core/one_line.h"
#include "base/core/warnings.h"

namespace dermis::scene::gltf {

void warn_line(const std::string& file, const std::string& place, const std::string& what) {
  const std::string kind = one_line(fmt::format("{}: {}", file, what));
  if (place.empty()) return warn_of(kind, file, kind);
  warn_of(kind, one_line(place, 80), one_line(fmt::format("{}: {}: {}", file, place, what)));
}
void warn_at(const std::string& file, const std::string& place, std::string_view what) {
  warn_line(file, place, std::string(what));
}
void warn_at(const Value& where, std::string_view what) { warn_at(where.file(), where.place(), what); }

void warn_of_fault(const std::string& file, std::string_view kind, const std::string& name,
                   const std::string& fault, std::string_view end) {
  warn_of(fmt::format("{}: {}", file, kind), one_line(name, 80), one_line(fmt::format("{}; {}", fault, end)));
}

void check_fault(const std::string& fault) {
  if (!fault.empty()) throw InputError("", fault);
}

double number_near(const Value& value, const char* key, double otherwise, double least, double most) {
  const std::optional<Value> found = value.find(key);
  if (!found) return otherwise;
  if (!found->is_number()) {
    warn_at(*found, "is no number, the default is taken");
    return otherwise;
  }
  const double number = found->any_number(), near = std::clamp(number, least, most);
  if (near != number) warn_at(*found, "is out of range, the nearest number in it is taken");
  return near;
}

bool boolean_near(const Value& value, const char* key, bool otherwise) {
  const std::optional<Value> found = value.find(key);
  if (!found) return otherwise;
  if (found->is_boolean()) return found->boolean();
  warn_at(*found, "is neither true nor false, the default is taken");
  return otherwise;
}

std::string text_near(const Value& value, const char* key, const std::string& otherwise) {
  const std::optional<Value> found = value.find(key);
  if (!found) return otherwise;
  if (found->is_text()) return found->text();
  warn_at(*found, "is no text, and is left out");
  return otherwise;
}

std::vector<double> numbers_near(const Value& value, const char* key, std::size_t size, double least,
                                 double most) {
  const std::optional<Value> found = value.find(key);
  if (!found) return {};
  std::vector<double> numbers;
  if (found->is_array() && found->array_size(0) == size)
    for (std::size_t i = 0; i < size && found->element(i).is_number(); ++i)
      numbers.push_back(found->element(i).any_number());
  if (numbers.size() != size) {
    warn_at(*found, "is not as many numbers as it must be, the default is taken");
    return {};
  }
  bool far = false;
  for (double& number : numbers) far |= std::clamp(number, least, most) != number;
  for (double& number : numbers) number = std::clamp(number, least, most);
  if (far) warn_at(*found, "is out of range, the nearest number in it is taken");
  return numbers;
}

int index_near(const Value& value, const char* key, std::size_t size, const char* what) {
  int index = -1;
  const std::string fault = fault_of([&] { index = value.index_or_none(key, size, what); });
  if (!fault.empty()) warn_at(value.at(key), fmt::format("names no {}, and is left out", what));
  return index;
}

}  // namespace dermis::scene::gltf
