// SPDX-License-Identifier: MIT
// portrait OUT.png [HEAD.glb]: one picture of a head, and what it cost.
#include <dermis/renderer.h>

#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: portrait OUT.png [HEAD.glb]\n");
    return 2;
  }
  try {
    // Without a file, the head that is built into the library.
    const dermis::Scene scene = argc > 2 ? dermis::Scene::load(argv[2]) : dermis::Scene::built_in();

    dermis::RenderSettings settings;
    settings.output.width = 160;  // pixels
    settings.output.height = 180;
    // at most: texels of a side of the maps in which light spreads, and of shadow maps
    settings.quality.map_size = 256;
    settings.quality.shadow_size = 256;
    settings.camera.orbit_deg = {20, 5};

    // One renderer serves any number of scenes and pictures: it keeps the device and its pipelines.
    dermis::Renderer renderer;
    const dermis::Picture picture = renderer.render(scene, settings);
    picture.save(argv[1]);

    const dermis::Statistics& cost = picture.statistics;
    std::printf("%s: %d x %d pixels in %.1f ms on %s\n", scene.name().c_str(), picture.width, picture.height,
                cost.frame_ms_median, cost.device.c_str());
    for (const dermis::PassStatistics& pass : cost.passes)
      std::printf("  %-24s %8.2f ms\n", pass.name.c_str(), pass.ms);
  } catch (const std::exception& error) {
    // dermis::InputError: what was given; dermis::DeviceError: what it runs on
    std::fprintf(stderr, "portrait: %s\n", error.what());
    return 1;
  }
}
