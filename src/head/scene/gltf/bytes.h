// SPDX-License-Identifier: MIT
// Reads the bytes of a document: buffers from chunk, data uris and files, bufferViews (after meshopt),
// accessors as floats or integers.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "head/scene/gltf/document.h"

namespace dermis::scene::gltf {

/// The encoded bytes of an image, in a buffer of the file or owned.
class EncodedImage {
 public:
  explicit EncodedImage(std::span<const std::byte> in_buffer) : bytes_(in_buffer) {}
  explicit EncodedImage(std::vector<std::byte> own) : own_(std::move(own)), bytes_(own_) {}
  EncodedImage(EncodedImage&&) = default;
  EncodedImage(const EncodedImage&) = delete;
  std::span<const std::byte> bytes() const { return bytes_; }

 private:
  std::vector<std::byte> own_;
  std::span<const std::byte> bytes_;
};

class Bytes {
 public:
  /// Reads every buffer; one that cannot be read (no such file, all exceed 4 GiB) throws when it is used, and
  /// so does what one that is too short lacks. Both arguments must outlive this.
  Bytes(const Document& document, const Container& container);

  /// Returns how many bytes were read from files so far, each file once.
  std::uint64_t read_bytes() const { return read_bytes_; }
  /// Returns the bytes of a bufferView, decompressed if necessary; valid as long as this.
  std::span<const std::byte> view(int index);
  /// Returns all elements of an accessor, `components()` numbers each, normalised integers converted, sparse
  /// values inserted. They may be infinite or NaN.
  std::vector<float> floats(int accessor);
  /// Returns the same for an accessor of unsigned integers with one component.
  std::vector<std::uint32_t> integers(int accessor);
  /// Returns an image from its bufferView, data uri or file. Images outside buffers are read again at each
  /// call, so that many large pictures are not in memory together. Valid as long as this. Several threads may
  /// call it after one call for the same image.
  EncodedImage image(int index);

 private:
  using Shared = std::shared_ptr<const std::vector<std::byte>>;
  std::span<const std::byte> buffer_bytes(const Buffer& buffer, std::size_t number,
                                          const Container& container);
  std::span<const std::byte> part(int buffer, std::uint64_t offset, std::uint64_t length) const;
  Shared file_bytes(const std::filesystem::path& path);
  template <class T>
  std::vector<T> elements(int accessor);

  const Document& document_;
  std::vector<std::span<const std::byte>> buffers_;
  std::vector<std::string> faults_;  ///< by buffer; empty: none
  std::vector<Shared> embedded_;
  std::map<std::filesystem::path, Shared> files_;        ///< many buffers may share one file
  std::map<int, std::vector<std::byte>> decompressed_;   ///< by bufferView
  std::uint64_t budget_bytes_ = std::uint64_t{4} << 30;  ///< remaining bytes that may be read
  std::uint64_t read_bytes_ = 0;
};

/// Decodes EXT_meshopt_compression. Throws InputError (place `where`) for damaged data or a size that the
/// compressed bytes cannot hold.
std::vector<std::byte> decode_meshopt(const MeshoptView& view, std::span<const std::byte> compressed,
                                      const std::string& where);

}  // namespace dermis::scene::gltf
