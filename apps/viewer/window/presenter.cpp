// SPDX-License-Identifier: MIT
#include "viewer/window/presenter.h"

#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <functional>
#include <string_view>

#include "dermis/error.h"
#include "viewer/window/style.h"

namespace dermis::viewer {

namespace {

std::size_t hash_of(const void* data, std::size_t bytes) {
  return std::hash<std::string_view>()({static_cast<const char*>(data), bytes});
}

// Of all that a frame shows but for the contents of its pictures.
std::size_t hash_of(const ImDrawData& lists) {
  std::size_t hash = 0;
  const auto add = [&hash](std::size_t more) { hash = hash * 1099511628211u ^ more; };
  add(hash_of(&lists.DisplaySize, sizeof(ImVec2)));
  for (int i = 0; i < lists.CmdListsCount; ++i) {
    const ImDrawList& list = *lists.CmdLists[i];
    add(hash_of(list.VtxBuffer.Data, static_cast<std::size_t>(list.VtxBuffer.Size) * sizeof(ImDrawVert)));
    add(hash_of(list.IdxBuffer.Data, static_cast<std::size_t>(list.IdxBuffer.Size) * sizeof(ImDrawIdx)));
    for (const ImDrawCmd& command : list.CmdBuffer) {
      add(hash_of(&command.ClipRect, sizeof(ImVec4)));
      add(reinterpret_cast<std::uintptr_t>(command.GetTexID()));
    }
  }
  return hash;
}

}  // namespace

Presenter::Presenter(Window& window, bool validate) : window_(window), validate_(validate) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  set_style(window.scale());
  ImGui_ImplGlfw_InitForVulkan(window.handle(), true);
  try {
    make();
  } catch (...) {
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    throw;
  }
}

Presenter::~Presenter() {
  parts_.reset();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void Presenter::make() {
  parts_.reset();
  try {
    parts_ = std::make_unique<Parts>(window_, validate_, said_);
  } catch (const SurfaceLost&) {
    throw DeviceError("the window's surface was lost, and no other one can be made");
  }
  for (std::size_t i = 1; i < picture_slots; ++i)
    if (!kept_[i].rgba.empty())
      parts_->ui.set_picture(static_cast<PictureSlot>(i), kept_[i].width, kept_[i].height, kept_[i].rgba);
}

void Presenter::set_picture(PictureSlot slot, int width, int height, std::span<const std::uint8_t> rgba) {
  kept_.at(static_cast<std::size_t>(slot)) = {width, height, {rgba.begin(), rgba.end()}};
  parts_->ui.set_picture(slot, width, height, rgba);
  has_news_ = true;
}

// ImGui needs several frames until all of an event is seen, and most of them look alike.
bool Presenter::is_shown(const ImDrawData& lists) {
  const std::size_t hash = hash_of(lists);
  const bool is_exposed = window_.take_exposed();
  if (hash == shown_ && !is_exposed && !has_news_) return true;
  shown_ = hash;
  has_news_ = false;
  return false;
}

bool Presenter::begin() {
  const VkExtent2D pixels = window_.pixels();
  if (pixels.width == 0 || pixels.height == 0) return false;
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
  return true;
}

bool Presenter::end() {
  ImGui::Render();
  if (is_shown(*ImGui::GetDrawData())) return true;
  constexpr std::array<float, 4> ground{0.09f, 0.09f, 0.1f, 1};
  try {
    // A swapchain that has just become too old gives none; the next one does.
    for (int tries = 0; tries < 2; ++tries) {
      const std::optional<Swapchain::Frame> frame = parts_->chain.begin(window_.pixels());
      if (!frame) continue;
      parts_->ui.record(*frame, *ImGui::GetDrawData(), ground);
      parts_->chain.present();
      ++frames_;
      return true;
    }
  } catch (const SurfaceLost&) {
    const auto now = std::chrono::steady_clock::now();
    if (lost_at_.time_since_epoch().count() != 0 && now - lost_at_ < std::chrono::seconds(2))
      throw DeviceError(
          "the window's device was lost twice within two seconds; 'dermis render' draws without");
    lost_at_ = now;
    make();
  }
  has_news_ = true;  // a frame that was not shown is to be
  return false;
}

void Presenter::drop() { ImGui::EndFrame(); }

}  // namespace dermis::viewer
