// SPDX-License-Identifier: MIT
#include "head/scene/gltf/bytes.h"

#include <algorithm>
#include <cstring>

#include "base/core/file.h"
#include "head/scene/gltf/lenient.h"
#include "head/scene/gltf/uri.h"

namespace dermis::scene::gltf {

namespace {

constexpr std::uint64_t glb_padding_bytes = 3;  // the binary chunk is padded to a multiple of four

template <class Component_>
Component_ load(const std::byte* from) {
  Component_ value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

/// glTF 2.0, 3.6.2.2: c / 127, c / 255 and so on; the most negative number becomes -1.
template <class Component_>
float normalized_value(Component_ value) {
  return std::max(static_cast<float>(value) / static_cast<float>(std::numeric_limits<Component_>::max()),
                  -1.0f);
}

/// Copies `count` elements, `stride` bytes apart, to out. The caller has checked that they lie in the view.
template <class Component_, class T>
void copy_elements(const Accessor& a, const std::byte* from, std::uint64_t count, std::uint64_t stride,
                   T* out) {
  const std::uint64_t column = column_bytes(a);
  for (std::uint64_t i = 0; i < count; ++i)
    for (int c = 0; c < a.columns; ++c)
      for (int r = 0; r < a.rows; ++r) {
        const auto value = load<Component_>(from + i * stride + c * column + r * sizeof(Component_));
        if constexpr (std::is_same_v<T, float> && std::is_integral_v<Component_>)
          *out++ = a.normalized ? normalized_value(value) : static_cast<float>(value);
        else
          *out++ = static_cast<T>(value);
      }
}

template <class T>
void copy_any(const Accessor& a, Component component, const std::byte* from, std::uint64_t count,
              std::uint64_t stride, T* out) {
  switch (component) {
    case Component::int8: return copy_elements<std::int8_t>(a, from, count, stride, out);
    case Component::uint8: return copy_elements<std::uint8_t>(a, from, count, stride, out);
    case Component::int16: return copy_elements<std::int16_t>(a, from, count, stride, out);
    case Component::uint16: return copy_elements<std::uint16_t>(a, from, count, stride, out);
    case Component::uint32: return copy_elements<std::uint32_t>(a, from, count, stride, out);
    case Component::float32:
      if constexpr (std::is_same_v<T, float>) copy_elements<float>(a, from, count, stride, out);
  }
}

}  // namespace

Bytes::Bytes(const Document& document, const Container& container)
    : document_(document), read_bytes_(container.bytes.size()) {
  for (std::size_t i = 0; i < document.buffers.size(); ++i) {
    std::span<const std::byte>& bytes = buffers_.emplace_back();
    faults_.push_back(fault_of([&] { bytes = buffer_bytes(document.buffers[i], i, container); }));
  }
}

Bytes::Shared Bytes::file_bytes(const std::filesystem::path& path) {
  Shared& file = files_[path.lexically_normal()];
  if (!file) {
    file = std::make_shared<const std::vector<std::byte>>(
        read_file(path, std::min(budget_bytes_, std::uint64_t{2} << 30)));
    budget_bytes_ -= file->size();
    read_bytes_ += file->size();
  }
  return file;
}

std::span<const std::byte> Bytes::buffer_bytes(const Buffer& buffer, std::size_t number,
                                               const Container& container) {
  if (!buffer.uri && !buffer.is_chunk) return {};
  const std::string where = fmt::format("{}: buffers[{}]", document_.file, number);

  std::span<const std::byte> bytes;
  if (!buffer.uri) {
    bytes = *container.binary;
    if (bytes.size() > buffer.byte_length + glb_padding_bytes)
      warn_in(where, "byteLength is {}, the binary chunk has {} bytes", buffer.byte_length, bytes.size());
  } else if (auto data = data_uri(*buffer.uri, where)) {
    embedded_.push_back(std::make_shared<const std::vector<std::byte>>(std::move(*data)));
    bytes = *embedded_.back();
  } else {
    bytes = *file_bytes(uri_path(document_.folder, *buffer.uri, where));
  }

  if (bytes.size() < buffer.byte_length)
    warn_in(where, "is cut off: byteLength is {}, there are {} bytes", buffer.byte_length, bytes.size());
  return bytes.first(std::min<std::uint64_t>(bytes.size(), buffer.byte_length));
}

std::span<const std::byte> Bytes::part(int buffer, std::uint64_t offset, std::uint64_t length) const {
  check_fault(faults_[static_cast<std::size_t>(buffer)]);
  // Ranges were checked against byteLength, which a buffer may not have.
  const std::span<const std::byte> bytes = buffers_[static_cast<std::size_t>(buffer)];
  if (length == 0) return {};
  if (bytes.empty())
    throw input_error(document_.file, "buffers[{}]: is used, but has neither a uri nor a binary chunk",
                      buffer);
  if (offset > bytes.size() || length > bytes.size() - offset)
    throw input_error(document_.file, "buffers[{}]: is cut off: bytes {} to {} are used, there are {}",
                      buffer, offset, offset + length, bytes.size());
  return bytes.subspan(offset, length);
}

std::span<const std::byte> Bytes::view(int index) {
  const BufferView& view = document_.views[index];
  check_fault(view.fault);
  if (!view.meshopt) return part(view.buffer, view.offset, view.length);
  const auto [entry, is_new] = decompressed_.try_emplace(index);
  if (is_new) {
    const MeshoptView& meshopt = *view.meshopt;
    entry->second = decode_meshopt(meshopt, part(meshopt.buffer, meshopt.offset, meshopt.length),
                                   fmt::format("{}: bufferViews[{}]", document_.file, index));
  }
  return entry->second;
}

template <class T>
std::vector<T> Bytes::elements(int index) {
  const Accessor& a = document_.accessors[index];
  check_fault(a.fault);
  const std::size_t components = a.components();
  std::vector<T> out(a.count * components);

  if (a.view >= 0 && a.count > 0) {
    const std::uint64_t stride = stride_bytes(a, document_.views[a.view]);
    copy_any(a, a.component, view(a.view).data() + a.offset, a.count, stride, out.data());
  }
  if (!a.sparse || a.sparse->count == 0) return out;

  const Sparse& sparse = *a.sparse;
  const Accessor scalar;  // shape of the sparse indices
  std::vector<std::uint32_t> where(sparse.count);
  copy_any(scalar, sparse.indices_component, view(sparse.indices_view).data() + sparse.indices_offset,
           sparse.count, size_of(sparse.indices_component), where.data());
  std::vector<T> values(sparse.count * components);
  copy_any(a, a.component, view(sparse.values_view).data() + sparse.values_offset, sparse.count,
           stride_bytes(a, BufferView{}), values.data());

  if (!std::is_sorted(where.begin(), where.end()))
    warn_at(document_.file, a.place + ".sparse", "its indices do not increase");
  for (std::size_t i = 0; i < where.size(); ++i) {
    if (where[i] >= a.count)
      throw input_error(document_.file, "{}.sparse: index {} is {}; it must be below {}", a.place, i,
                        where[i], a.count);
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i * components), components,
                out.begin() + static_cast<std::ptrdiff_t>(where[i] * components));
  }
  return out;
}

std::vector<float> Bytes::floats(int accessor) { return elements<float>(accessor); }
std::vector<std::uint32_t> Bytes::integers(int accessor) { return elements<std::uint32_t>(accessor); }

EncodedImage Bytes::image(int index) {
  const ImageSource& image = document_.images[index];
  check_fault(image.fault);
  if (image.view >= 0) return EncodedImage(view(image.view));
  const std::string where = fmt::format("{}: images[{}]", document_.file, index);
  if (auto data = data_uri(*image.uri, where)) return EncodedImage(std::move(*data));
  return EncodedImage(read_file(uri_path(document_.folder, *image.uri, where)));
}

}  // namespace dermis::scene::gltf
