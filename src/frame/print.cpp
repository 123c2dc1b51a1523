// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "frame/graph.h"
#include "gpu/formats.h"

namespace dermis::frame {
namespace {

std::string_view name_of(PassKind kind) {
  return kind == PassKind::compute ? "compute" : kind == PassKind::raster ? "raster" : "copy";
}

// Returns text for Graphviz's quotes.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) (c == '"' || c == '\\' ? out += '\\' : out) += c;
  return out;
}

std::string_view name_of(Lifetime lifetime) {
  switch (lifetime) {
    case Lifetime::transient: return "transient";
    case Lifetime::persistent: return "persistent";
    case Lifetime::of_host: return "of the host";
  }
  return "";
}

std::string size_of(const gpu::TextureDesc& desc) {
  std::string text = fmt::format("{}x{}", desc.width, desc.height);
  if (desc.layers > 1) text += fmt::format("x{}", desc.layers);
  if (desc.samples > 1) text += fmt::format(" {} samples", desc.samples);
  return text;
}

}  // namespace

std::string print_text(const FrameGraph& graph) {
  std::string text = "passes\n";
  for (const PassNode& pass : graph.passes()) {
    text += fmt::format("  {:<28} {:<8}", pass.name, name_of(pass.kind));
    for (const Use& use : pass.uses)
      text +=
          fmt::format(" {} '{}';", row_of(use.access).verb,
                      use.is_texture ? graph.textures()[use.index].name : graph.buffers()[use.index].name);
    text += '\n';
  }

  text += "textures\n";
  for (const TextureNode& t : graph.textures())
    text += fmt::format("  {:<28} {:<20} {:<10} {:>9.2f} MB {}\n", t.name, size_of(t.desc),
                        gpu::format_name(t.desc.format), static_cast<double>(gpu::bytes_of(t.desc)) / 1e6,
                        name_of(t.lifetime));

  if (!graph.buffers().empty()) text += "buffers\n";
  for (const BufferNode& b : graph.buffers())
    text += fmt::format("  {:<28} {:>9} bytes {}\n", b.name, b.desc.bytes, name_of(b.lifetime));
  return text;
}

std::string print_dot(const FrameGraph& graph) {
  std::string text = "digraph frame {\n  rankdir=LR;\n  node [fontname=\"sans-serif\"];\n";
  for (std::size_t p = 0; p < graph.passes().size(); ++p) {
    const PassNode& pass = graph.passes()[p];
    text += fmt::format("  p{} [shape=box, style=filled, fillcolor=\"#f2d6c9\", label=\"{}\"];\n", p,
                        escaped(pass.name));
    for (const Use& use : pass.uses) {
      const std::string resource = fmt::format("{}{}", use.is_texture ? 't' : 'b', use.index);
      text += writes(use.access) ? fmt::format("  p{} -> {};\n", p, resource)
                                 : fmt::format("  {} -> p{};\n", resource, p);
    }
  }

  for (std::size_t t = 0; t < graph.textures().size(); ++t) {
    const TextureNode& node = graph.textures()[t];
    text += fmt::format("  t{} [shape=ellipse, label=\"{}\\n{} {}\"];\n", t, escaped(node.name),
                        size_of(node.desc), gpu::format_name(node.desc.format));
  }

  for (std::size_t b = 0; b < graph.buffers().size(); ++b)
    text += fmt::format("  b{} [shape=ellipse, style=dashed, label=\"{}\\n{} bytes\"];\n", b,
                        escaped(graph.buffers()[b].name), graph.buffers()[b].desc.bytes);
  return text + "}\n";
}

}  // namespace dermis::frame
