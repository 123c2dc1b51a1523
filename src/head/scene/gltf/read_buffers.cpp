// SPDX-License-Identifier: MIT
// Reads buffers, bufferViews and accessors; checks every range against what holds it, so that no later read
// can leave it.
#include <algorithm>

#include "head/scene/gltf/document.h"
#include "head/scene/gltf/lenient.h"

namespace dermis::scene::gltf {

namespace {

constexpr std::uint64_t max_stride = 4096;  // glTF: 252

// An accessor without bytes of its own (sparse over nothing, or Draco) costs the file nothing, so its count
// is compared with the size of all buffers. The densest Draco data that we know holds about 20 indices per
// byte. Below the floor the memory does not matter.
constexpr std::uint64_t max_zero_elements = 1u << 24, free_zero_elements = 1u << 16,
                        zero_elements_per_byte = 64;

std::uint64_t zero_element_limit(const Document& document) {
  std::uint64_t bytes = 0;
  for (const Buffer& buffer : document.buffers)
    if (buffer.uri || buffer.is_chunk) bytes += std::min(buffer.byte_length, max_zero_elements);
  return std::min(max_zero_elements, free_zero_elements + bytes * zero_elements_per_byte);
}

void check_within(const Value& where, std::uint64_t offset, std::uint64_t length, std::uint64_t size,
                  const char* what) {
  if (offset > size || length > size - offset)
    where.fail("bytes {} to {} reach past the end of its {}, which has {}", offset, offset + length, what,
               size);
}

MeshoptView read_meshopt(const Document& document, const Value& value) {
  MeshoptView view;
  view.buffer = value.index("buffer", document.buffers.size(), "buffer");
  view.offset = value.count_or("byteOffset", 0);
  view.length = value.at("byteLength").count(1);
  view.stride = value.at("byteStride").count(1, 256);
  view.count = value.at("count").count(1);

  const std::string& mode = value.at("mode").text();
  if (mode == "ATTRIBUTES")
    view.mode = MeshoptMode::attributes;
  else if (mode == "TRIANGLES")
    view.mode = MeshoptMode::triangles;
  else if (mode == "INDICES")
    view.mode = MeshoptMode::indices;
  else
    value.at("mode").fail("must be ATTRIBUTES, TRIANGLES or INDICES, is '{}'", mode.substr(0, 40));

  const std::string filter = value.text_or("filter", "NONE");
  if (filter == "NONE")
    view.filter = MeshoptFilter::none;
  else if (filter == "OCTAHEDRAL")
    view.filter = MeshoptFilter::octahedral;
  else if (filter == "QUATERNION")
    view.filter = MeshoptFilter::quaternion;
  else if (filter == "EXPONENTIAL")
    view.filter = MeshoptFilter::exponential;
  else
    value.at("filter").fail("must be NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL, is '{}'",
                            filter.substr(0, 40));

  const bool attributes = view.mode == MeshoptMode::attributes;
  if (attributes && view.stride % 4 != 0)
    value.fail("byteStride {} must be a multiple of 4 in mode ATTRIBUTES", view.stride);
  if (!attributes && view.stride != 2 && view.stride != 4)
    value.fail("byteStride {} must be 2 or 4 in mode {}", view.stride, mode);
  if (view.mode == MeshoptMode::triangles && view.count % 3 != 0)
    value.fail("count {} must be a multiple of 3 in mode TRIANGLES", view.count);
  if (!attributes && view.filter != MeshoptFilter::none)
    value.fail("filter {} is only for mode ATTRIBUTES", filter);

  const std::uint64_t s = view.stride;
  const bool fits = view.filter == MeshoptFilter::none ||
                    (view.filter == MeshoptFilter::octahedral && (s == 4 || s == 8)) ||
                    (view.filter == MeshoptFilter::quaternion && s == 8) ||
                    view.filter == MeshoptFilter::exponential;
  if (!fits) value.fail("byteStride {} does not fit filter {}", s, filter);

  check_within(value, view.offset, view.length, document.buffers[view.buffer].byte_length, "buffer");
  if (document.buffers[view.buffer].fallback)
    value.fail("buffer {} is a fallback without bytes", view.buffer);
  return view;
}

BufferView read_view(const Document& document, const Value& value) {
  BufferView view;
  view.buffer = value.index("buffer", document.buffers.size(), "buffer");
  view.offset = value.count_or("byteOffset", 0);
  view.length = value.at("byteLength").count();
  view.stride = value.count_or("byteStride", 0, 0, max_stride);
  check_within(value, view.offset, view.length, document.buffers[view.buffer].byte_length, "buffer");

  if (const std::optional<Value> meshopt = extension(value, "EXT_meshopt_compression")) {
    view.meshopt = read_meshopt(document, *meshopt);
    if (view.meshopt->count > max_count / view.meshopt->stride ||
        view.meshopt->count * view.meshopt->stride != view.length)
      meshopt->fail("count {} times byteStride {} must be the view's byteLength {}", view.meshopt->count,
                    view.meshopt->stride, view.length);
  } else if (document.buffers[view.buffer].fallback) {
    value.fail("buffer {} is a fallback without bytes, and the view has no EXT_meshopt_compression",
               view.buffer);
  }
  return view;
}

Component read_component(const Value& value) {
  const std::uint64_t code = value.count();
  switch (code) {
    case 5120:
    case 5121:
    case 5122:
    case 5123:
    case 5125:
    case 5126: return static_cast<Component>(code);
    default: value.fail("must be 5120 to 5123, 5125 or 5126, is {}", code);
  }
}

void read_shape(Accessor& accessor, const Value& value) {
  struct Shape {
    const char* name;
    int columns, rows;
  };
  static constexpr std::array<Shape, 7> shapes{{{"SCALAR", 1, 1},
                                                {"VEC2", 1, 2},
                                                {"VEC3", 1, 3},
                                                {"VEC4", 1, 4},
                                                {"MAT2", 2, 2},
                                                {"MAT3", 3, 3},
                                                {"MAT4", 4, 4}}};

  const std::string& name = value.text();
  for (const Shape& shape : shapes)
    if (name == shape.name) {
      accessor.columns = shape.columns;
      accessor.rows = shape.rows;
      return;
    }
  value.fail("must be SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3 or MAT4, is '{}'", name.substr(0, 40));
}

/// Throws unless `count` elements of `bytes` each, `stride` apart, lie in the view.
void check_elements(const Value& where, const BufferView& view, std::uint64_t offset, std::uint64_t count,
                    std::uint64_t bytes, std::uint64_t stride) {
  // count <= 2^48, stride <= 2^12: no overflow
  const std::uint64_t extent = count == 0 ? 0 : (count - 1) * stride + bytes;
  check_within(where, offset, extent, view.length, "bufferView");
}

Sparse read_sparse(const Document& document, const Value& value, const Accessor& accessor) {
  Sparse sparse;
  sparse.count = value.count_or("count", 0);
  if (sparse.count == 0) return sparse;
  if (sparse.count > accessor.count)
    value.fail("count {} is more than the accessor's {}", sparse.count, accessor.count);

  const Value indices = value.at("indices"), values = value.at("values");
  sparse.indices_view = indices.index("bufferView", document.views.size(), "bufferView");
  sparse.indices_offset = indices.count_or("byteOffset", 0);
  sparse.indices_component = read_component(indices.at("componentType"));
  const Component c = sparse.indices_component;
  if (c != Component::uint8 && c != Component::uint16 && c != Component::uint32)
    indices.fail("componentType must be an unsigned integer");

  sparse.values_view = values.index("bufferView", document.views.size(), "bufferView");
  sparse.values_offset = values.count_or("byteOffset", 0);

  check_fault(document.views[sparse.indices_view].fault);
  check_fault(document.views[sparse.values_view].fault);
  const std::uint64_t bytes = element_bytes(accessor), stride = stride_bytes(accessor, BufferView{});
  check_elements(indices, document.views[sparse.indices_view], sparse.indices_offset, sparse.count,
                 size_of(c), size_of(c));
  check_elements(values, document.views[sparse.values_view], sparse.values_offset, sparse.count, bytes,
                 stride);
  return sparse;
}

// `min` and `max` are not read: writers round them, or count what is left out.
void read_accessor(const Document& document, const Value& value, Accessor& accessor) {
  accessor.component = read_component(value.at("componentType"));
  accessor.count = value.at("count").count();
  read_shape(accessor, value.at("type"));

  accessor.normalized = boolean_near(value, "normalized", false);
  if (accessor.normalized &&
      (accessor.component == Component::float32 || accessor.component == Component::uint32)) {
    warn_at(value, fmt::format("normalized is not for {}", name_of(accessor.component)));
    accessor.normalized = false;
  }

  accessor.view = value.index_or_none("bufferView", document.views.size(), "bufferView");
  accessor.offset = value.count_or("byteOffset", 0);
  if (accessor.view >= 0) {
    const BufferView& view = document.views[accessor.view];
    check_fault(view.fault);
    const std::uint64_t bytes = element_bytes(accessor), stride = stride_bytes(accessor, view);
    if (stride < bytes)
      value.fail("an element has {} bytes, but the bufferView's byteStride is {}", bytes, stride);
    check_elements(value, view, accessor.offset, accessor.count, bytes, stride);
  } else {
    const std::uint64_t limit = zero_element_limit(document);
    if (accessor.count > limit)
      value.fail("{} elements without a bufferView; the limit for this file is {}", accessor.count, limit);
  }

  if (const std::optional<Value> sparse = value.find("sparse"))
    accessor.sparse = read_sparse(document, *sparse, accessor);
}

}  // namespace

std::uint64_t size_of(Component component) {
  switch (component) {
    case Component::int8:
    case Component::uint8: return 1;
    case Component::int16:
    case Component::uint16: return 2;
    default: return 4;
  }
}

const char* name_of(Component component) {
  switch (component) {
    case Component::int8: return "BYTE";
    case Component::uint8: return "UNSIGNED_BYTE";
    case Component::int16: return "SHORT";
    case Component::uint16: return "UNSIGNED_SHORT";
    case Component::uint32: return "UNSIGNED_INT";
    default: return "FLOAT";
  }
}

std::uint64_t column_bytes(const Accessor& accessor) {
  const std::uint64_t bytes = accessor.rows * size_of(accessor.component);
  // Columns of matrices start at multiples of four.
  return accessor.columns == 1 ? bytes : (bytes + 3) / 4 * 4;
}

std::uint64_t element_bytes(const Accessor& accessor) {
  // The padding of the last column may be missing.
  return (accessor.columns - 1) * column_bytes(accessor) + accessor.rows * size_of(accessor.component);
}

std::uint64_t stride_bytes(const Accessor& accessor, const BufferView& view) {
  return view.stride != 0 ? view.stride : accessor.columns * column_bytes(accessor);
}

void read_buffers(Document& document, const Value& root, bool has_binary) {
  root.for_each("buffers", [&](const Value& value) {
    Buffer buffer;
    buffer.byte_length = value.at("byteLength").count();
    if (const std::optional<Value> uri = value.find("uri")) buffer.uri = uri->text();
    const std::optional<Value> meshopt = extension(value, "EXT_meshopt_compression");
    buffer.fallback = meshopt && meshopt->boolean_or("fallback", false) && !buffer.uri;
    // A buffer without bytes is legal as long as nothing is read from it.
    buffer.is_chunk = document.buffers.empty() && has_binary && !buffer.uri && !buffer.fallback;
    document.buffers.push_back(std::move(buffer));
  });
  root.for_each("bufferViews", [&](const Value& value) {
    BufferView view;
    std::string fault = fault_of([&] { view = read_view(document, value); });
    document.views.push_back(fault.empty() ? std::move(view) : BufferView{.fault = std::move(fault)});
  });
}

void read_accessors(Document& document, const Value& root) {
  root.for_each("accessors", [&](const Value& value) {
    Accessor& accessor = document.accessors.emplace_back();
    accessor.place = value.place();
    accessor.fault = fault_of([&] { read_accessor(document, value, accessor); });
    if (!accessor.fault.empty()) accessor.count = 0;
  });
}

}  // namespace dermis::scene::gltf
