// SPDX-License-Identifier: MIT
#include "gpu/support/renderer.h"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "gpu/device.h"

namespace dermis::tests {
namespace {

/// Ends the renderer with the last test: later the validation layer has ended itself.
class OneRenderer : public testing::Environment {
 public:
  void SetUp() override {
    if (gpu::list_devices().empty())
      GTEST_SKIP() << "no Vulkan device (Debian, Ubuntu: apt install mesa-vulkan-drivers)";
  }
  void TearDown() override {
    for (const std::function<void()>& end : ends_) end();
    renderer_.reset();
  }
  void at_the_end(std::function<void()> end) { ends_.push_back(std::move(end)); }

  Renderer& get() {
    if (!renderer_) make();
    return *renderer_;
  }

  bool is_validated() {
    get();
    return validated_;
  }

  /// Those since the last call; makes no renderer.
  std::vector<std::string> new_messages() {
    if (!renderer_) return {};
    std::vector<std::string> messages = renderer_->validation_messages();
    messages.erase(messages.begin(), messages.begin() + static_cast<std::ptrdiff_t>(known_messages_));
    known_messages_ += messages.size();
    return messages;
  }

 private:
  void make() {
    try {
      renderer_ = std::make_unique<Renderer>(Renderer::Options{.validate = true});
      validated_ = true;
    } catch (const DeviceError& error) {
      if (std::string(error.what()).find("layer") == std::string::npos) throw;
      renderer_ = std::make_unique<Renderer>();
    }
  }

  std::vector<std::function<void()>> ends_;
  std::unique_ptr<Renderer> renderer_;
  bool validated_ = false;
  std::size_t known_messages_ = 0;
};

OneRenderer* const one = static_cast<OneRenderer*>(testing::AddGlobalTestEnvironment(new OneRenderer));

/// Makes a message of the validation layer a failure of the test in which it came.
class ValidationIsSilent : public testing::EmptyTestEventListener {
  void OnTestEnd(const testing::TestInfo&) override {
    for (const std::string& message : one->new_messages()) ADD_FAILURE() << message;
  }
};

const bool listens = [] {
  testing::UnitTest::GetInstance()->listeners().Append(new ValidationIsSilent);
  return true;
}();

}  // namespace

Renderer& renderer() { return one->get(); }

bool is_validated() { return one->is_validated(); }

void with_the_last_test(std::function<void()> end) { one->at_the_end(std::move(end)); }

bool on_software() {
  static const bool software = gpu::list_devices().front().type == "software";  // takes milliseconds
  return software;
}

}  // namespace dermis::tests
