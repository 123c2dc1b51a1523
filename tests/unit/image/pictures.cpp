// SPDX-License-Identifier: MIT
#include "pictures.h"

#include <spng.h>

#include <jpeglib.h>
#include <cstdio>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfTiledOutputFile.h>

#include <cstdlib>
#include <cstring>
#include <random>
#include <sstream>
#include <stdexcept>

#include "base/core/error.h"

namespace dermis::image::test {

namespace {

void check(int result) {
  if (result != SPNG_OK) throw std::logic_error(spng_strerror(result));
}

Bytes take(void* data, std::size_t size) {
  Bytes bytes(size);
  std::memcpy(bytes.data(), data, size);
  std::free(data);
  return bytes;
}

class Memory : public Imf::OStream {
 public:
  Memory() : OStream("test") {}
  void write(const char c[], int n) override { stream_.write(c, n); }
  std::uint64_t tellp() override { return static_cast<std::uint64_t>(stream_.tellp()); }
  void seekp(std::uint64_t at) override { stream_.seekp(static_cast<std::streamoff>(at)); }
  Bytes bytes() const { return bytes_of(stream_.str()); }

 private:
  std::ostringstream stream_;
};

}  // namespace

Bytes make_png(const PngRecipe& recipe, std::span<const std::uint8_t> samples) {
  spng_ctx* context = spng_ctx_new(SPNG_CTX_ENCODER);
  check(spng_set_option(context, SPNG_ENCODE_TO_BUFFER, 1));

  spng_ihdr header{};
  header.width = recipe.width;
  header.height = recipe.height;
  header.bit_depth = recipe.bit_depth;
  header.color_type = recipe.colour_type;
  header.interlace_method = recipe.interlaced ? 1 : 0;
  check(spng_set_ihdr(context, &header));

  if (!recipe.palette_rgba.empty()) {
    spng_plte palette{};
    spng_trns transparency{};
    palette.n_entries = transparency.n_type3_entries =
        static_cast<std::uint32_t>(recipe.palette_rgba.size() / 4);
    for (std::uint32_t i = 0; i < palette.n_entries; ++i) {
      const std::uint8_t* p = &recipe.palette_rgba[i * 4];
      palette.entries[i] = {p[0], p[1], p[2], 0};
      transparency.type3_alpha[i] = p[3];
    }
    check(spng_set_plte(context, &palette));
    check(spng_set_trns(context, &transparency));
  }

  if (recipe.transparent_grey >= 0) {
    spng_trns transparency{};
    transparency.gray = static_cast<std::uint16_t>(recipe.transparent_grey);
    check(spng_set_trns(context, &transparency));
  }

  check(spng_encode_image(context, samples.data(), samples.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE));
  std::size_t size = 0;
  int result = 0;
  void* data = spng_get_png_buffer(context, &size, &result);
  check(result);
  spng_ctx_free(context);
  return take(data, size);
}

Bytes make_jpeg(int width, int height, JpegKind kind, std::span<const std::uint8_t> samples) {
  jpeg_compress_struct info{};
  jpeg_error_mgr errors{};
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  unsigned char* data = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &data, &size);

  info.image_width = static_cast<JDIMENSION>(width);
  info.image_height = static_cast<JDIMENSION>(height);
  info.input_components = kind == JpegKind::grey ? 1 : (kind == JpegKind::cmyk ? 4 : 3);
  info.in_color_space =
      kind == JpegKind::grey ? JCS_GRAYSCALE : (kind == JpegKind::cmyk ? JCS_CMYK : JCS_RGB);
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, 95, TRUE);

  // Keep all components at full resolution.
  for (int c = 0; c < info.num_components; ++c)
    info.comp_info[c].h_samp_factor = info.comp_info[c].v_samp_factor = 1;
  if (kind == JpegKind::progressive) jpeg_simple_progression(&info);

  jpeg_start_compress(&info, TRUE);
  while (info.next_scanline < info.image_height) {
    const std::size_t row_bytes = static_cast<std::size_t>(width * info.input_components);
    JSAMPROW row = const_cast<JSAMPROW>(samples.data()) + info.next_scanline * row_bytes;
    jpeg_write_scanlines(&info, &row, 1);
  }

  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  return take(data, size);
}

Bytes make_exr(const ExrRecipe& r, std::span<const float> values) {
  const Imath::Box2i data(Imath::V2i(r.x, r.y), Imath::V2i(r.x + r.width - 1, r.y + r.height - 1));
  const Imath::Box2i show(Imath::V2i(r.show_x, r.show_y),
                          Imath::V2i(r.show_x + r.show_width - 1, r.show_y + r.show_height - 1));
  Imf::Header header(r.show_width == 0 ? data : show, data);
  header.compression() = static_cast<Imf::Compression>(r.compression);

  const std::size_t pixel = r.channels.size() * sizeof(float);
  Imf::FrameBuffer source;
  for (std::size_t c = 0; c < r.channels.size(); ++c) {
    const std::string name(1, r.channels[c]);
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    source.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data() + c, data, pixel,
                                         pixel * static_cast<std::size_t>(r.width)));
  }

  Memory stream;
  if (r.tile == 0) {
    Imf::OutputFile file(stream, header, 0);
    file.setFrameBuffer(source);
    file.writePixels(r.height);
  } else {
    const unsigned side = static_cast<unsigned>(r.tile);
    header.setTileDescription(Imf::TileDescription(side, side, Imf::ONE_LEVEL));
    Imf::TiledOutputFile file(stream, header, 0);
    file.setFrameBuffer(source);
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
  }
  return stream.bytes();
}

Bytes bytes_of(std::string_view text) {
  const auto view = std::as_bytes(std::span(text.data(), text.size()));
  return {view.begin(), view.end()};
}

std::string error_of8(std::span<const std::byte> bytes, const DecodeLimits& limits) {
  try {
    decode_image8(bytes, "map", limits);
  } catch (const InputError& error) { return error.what(); }
  return "no error";
}

std::string error_of_f(std::span<const std::byte> bytes, const DecodeLimits& limits) {
  try {
    decode_image_f(bytes, "sky", limits);
  } catch (const InputError& error) { return error.what(); }
  return "no error";
}

std::vector<std::uint8_t> noise(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<std::uint8_t> values(count);
  for (std::uint8_t& value : values) value = static_cast<std::uint8_t>(random() >> 24);
  return values;
}

}  // namespace dermis::image::test
