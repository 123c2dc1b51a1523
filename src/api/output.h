// SPDX-License-Identifier: MIT
/// From a frame that has run to what the caller gets: pixels, pictures of intermediate maps, statistics.
#pragma once

#include <span>
#include <vector>

#include "api/scene_on_device.h"
#include "dermis/renderer.h"
#include "frame/executor.h"
#include "render/setup/frame_setup.h"

namespace dermis::api {

/// InputError: a size over what the device can do, with both numbers.
void check_device_limits(const RenderSettings& settings, const gpu::DeviceLimits& limits);

/// Throws InputError if settings.show is unknown to the technique (lists the names that it knows), or is
/// light that a frame of `setup` does not store (says why).
void check_show(const techniques::FrameOutputs& outputs, const RenderSettings& settings,
                const setup::FrameSetup& setup);

/// Returns the passes of a frame that was timed, with what `graph` knows of them.
std::vector<PassStatistics> passes_of(const frame::FrameTime& frame, const frame::FrameGraph& graph);

/// Returns the middle value, of an even number the mean of the middle two; 0 of none.
double median(std::vector<double> values);

/// Fills in the times of at least one frame of a graph: medians, shortest, longest.
void fill_times(Statistics& statistics, std::span<const frame::FrameTime> frames,
                const frame::FrameGraph& graph);

/// `counters` as read back from FrameOutputs::counters.
/// `assets`: each once.
void fill_counts(Statistics& statistics, std::span<const AssetPointer> assets, const RenderSettings& settings,
                 const setup::FrameSetup& setup, std::span<const std::byte> counters);

/// Fills in what the device is, and its memory.
void fill_device(Statistics& statistics, gpu::Device& device);

/// Fills in size and pixels of a picture, from half floats RGBA and display values RGBA8.
void fill_picture(Picture& picture, const RenderSettings& settings, std::span<const std::byte> halves,
                  std::span<const std::byte> display);

/// The picture before bloom, linear RGBA.
std::vector<float> read_before_bloom(frame::GraphExecutor& executor, const techniques::FrameOutputs& out);

/// The picture, or the map that settings.show names, which check_show() has accepted.
void read_picture(Picture& picture, frame::GraphExecutor& executor, const techniques::FrameOutputs& out,
                  const RenderSettings& settings, const setup::FrameSetup& setup);

}  // namespace dermis::api
