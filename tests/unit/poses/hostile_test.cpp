// SPDX-License-Identifier: MIT
// Files whose animations are broken, and poses that make no sense: one line, or they play. Both for an asset
// that is loaded in a pose and for an instance that is posed.
#include <cmath>
#include <functional>
#include <limits>

#include "../gltf/support.h"
#include "../rig/two_clips.h"
#include "api/asset_state.h"
#include "api/scene_state.h"
#include "dermis/pose.h"
#include "dermis/scene.h"
#include "head/scene/import/shapes.h"
#include "head/scene/surface/measured.h"
#include "support/thrown.h"

namespace dermis::scene::test {
namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

// A triangle, node 0, that hangs on joint node 1 as well; its clip "0" moves node 0 by 1 m in 1 s.
struct Sound : Builder {
  Sound() {
    triangle();
    json["nodes"].push_back({{"name", "joint"}});
    json["scenes"][0]["nodes"].push_back(1);
    json["skins"] = Json::array({{{"joints", {1}}}});
    json["animations"] = Json::array({{{"samplers", Json::array()}, {"channels", Json::array()}}});
    add(sampler({0, 1}, {0, 0, 0, 1, 0, 0}), "translation");
  }

  Json& clip() { return json["animations"][0]; }
  int sampler(const std::vector<float>& times, const std::vector<float>& values,
              const std::string& type = "VEC3", const std::string& way = "LINEAR") {
    clip()["samplers"].push_back(
        {{"input", accessor(times, "SCALAR")}, {"output", accessor(values, type)}, {"interpolation", way}});
    return static_cast<int>(clip()["samplers"].size()) - 1;
  }
  void add(int from, const std::string& path, int node = 0) {
    clip()["channels"].push_back({{"sampler", from}, {"target", {{"node", node}, {"path", path}}}});
  }
  /// Makes the clip anew, of one channel.
  void replace(const std::vector<float>& times, const std::vector<float>& values,
               const std::string& type = "VEC3", const std::string& path = "translation",
               const std::string& way = "LINEAR") {
    clip() = {{"samplers", Json::array()}, {"channels", Json::array()}};
    add(sampler(times, values, type, way), path);
  }
  Json& attributes() { return json["meshes"][0]["primitives"][0]["attributes"]; }
  void hangs_on(float joint) {
    attributes()["JOINTS_0"] = accessor({joint, 0, 0, 0, joint, 0, 0, 0, joint, 0, 0, 0}, "VEC4", 5123);
    attributes()["WEIGHTS_0"] = accessor({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
    json["nodes"][0]["skin"] = 0;
  }
  void targets(std::size_t count) {
    const int offset = accessor({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    Json all = Json::array();
    for (std::size_t t = 0; t < count; ++t) all.push_back({{"POSITION", offset}});
    json["meshes"][0]["primitives"][0]["targets"] = all;
    std::vector<float> weights(2 * count, 0);
    std::fill(weights.begin() + static_cast<std::ptrdiff_t>(count), weights.end(),
              1.0f / static_cast<float>(count));
    replace({0, 1}, weights, "SCALAR", "weights");
  }
};

struct Hostile {
  const char* name;
  std::function<void(Sound&)> spoil;
  const char* at_rest;  ///< what loading says; empty: it loads, and stands at rest
  const char* in_clip;  ///< what the clip says, loaded in a pose or posed; empty: it plays
};

const Hostile hostile[] = {
    {"sound", [](Sound&) {}, "", ""},
    {"times stand",
     [](Sound& b) {
       b.replace({0, 0}, {0, 0, 0, 1, 0, 0});
     },
     "", ""},
    {"times fall",
     [](Sound& b) {
       b.replace({1, 0.5f}, {0, 0, 0, 1, 0, 0});
     },
     "", "times must not fall; 0.5 s follows 1 s"},
    {"a time is nan",
     [](Sound& b) {
       b.replace({NAN}, {0, 0, 0});
     },
     "", "time 0 is nan"},
    {"a time is infinite",
     [](Sound& b) {
       b.replace({0, INFINITY}, {0, 0, 0, 1, 0, 0});
     },
     "", "time 1 is inf"},
    {"a time is negative",
     [](Sound& b) {
       b.replace({-1}, {0, 0, 0});
     },
     "", ""},
    {"no times",
     [](Sound& b) { b.json["accessors"][b.clip()["samplers"][0]["input"].get<std::size_t>()]["count"] = 0; },
     "", "has no key frames"},

    {"a key is nan",
     [](Sound& b) {
       b.replace({0}, {0, NAN, 0});
     },
     "", "number 1 of its output is not finite"},
    {"a key is infinite",
     [](Sound& b) {
       b.replace({0}, {0, INFINITY, 0});
     },
     "", "is not finite"},
    {"a tangent is nan",
     [](Sound& b) {
       b.replace({0}, {NAN, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3", "translation", "CUBICSPLINE");
     },
     "", "number 0 of its output is not finite"},
    {"too few keys",
     [](Sound& b) {
       b.replace({0, 1}, {0, 0, 0});
     },
     "", "2 key frames of 3 need 6"},
    {"a key is as far as floats go",
     [](Sound& b) {
       b.replace({0}, {3e38f, 0, 0});
     },
     "", "m from the origin"},
    {"a scale is as large as floats go",
     [](Sound& b) {
       b.replace({0}, {3e38f, 3e38f, 3e38f}, "VEC3", "scale");
     },
     "", "m from the origin"},
    {"scales of 0",
     [](Sound& b) {
       b.replace({0, 1}, {0, 0, 0, 0, 0, 0}, "VEC3", "scale");
     },
     "", ""},
    {"mirrors",
     [](Sound& b) {
       b.replace({0, 1}, {1, 1, 1, -1, 1, 1}, "VEC3", "scale");
     },
     "", ""},
    {"a turn of no length",
     [](Sound& b) {
       b.replace({0}, {0, 0, 0, 0}, "VEC4", "rotation");
     },
     "", "rotation 0 has no length"},
    {"a turn through no length",
     [](Sound& b) {
       b.replace({0, 1}, {0, 0, 0, 1, 0, 0, 0, -1}, "VEC4", "rotation");
     },
     "", ""},
    {"a sampler that is missing", [](Sound& b) { b.clip()["channels"][0]["sampler"] = 7; }, "",
     "there is no sampler 7"},
    {"a channel without a sampler", [](Sound& b) { b.clip()["channels"][0].erase("sampler"); }, "",
     "'sampler' is missing"},
    {"a node that is missing", [](Sound& b) { b.clip()["channels"][0]["target"]["node"] = 9; }, "",
     "there is no node 9"},
    {"a sampler without times", [](Sound& b) { b.clip()["samplers"][0].erase("input"); }, "",
     "'input' is missing"},
    {"a sampler without values", [](Sound& b) { b.clip()["samplers"][0]["output"] = 99; }, "",
     "there is no accessor 99"},
    {"a way that is none", [](Sound& b) { b.clip()["samplers"][0]["interpolation"] = "BEZIER"; }, "",
     "LINEAR, STEP or CUBICSPLINE"},

    {"weights without targets",
     [](Sound& b) {
       b.add(0, "translation");
       b.clip()["channels"][0]["target"]["path"] = "weights";
     },
     "", ""},

    {"a joint of no node",
     [](Sound& b) {
       b.hangs_on(1);
       b.json["skins"][0]["joints"] = {1, 12};
     },
     "vertices hang on joint 1 of their skin, which is no node", nullptr},
    {"a joint of no node, on which nothing hangs",
     [](Sound& b) {
       b.hangs_on(0);
       b.json["skins"][0]["joints"] = {1, 12};
     },
     "", ""},
    {"vertices on a joint that the skin lacks", [](Sound& b) { b.hangs_on(7); }, "", ""},
    {"vertices on a joint", [](Sound& b) { b.hangs_on(0); }, "", ""},

    {"a bind matrix that is nan",
     [](Sound& b) {
       b.hangs_on(0);
       std::vector<float> bind(16, 0);
       bind[5] = NAN;
       b.json["skins"][0]["inverseBindMatrices"] = b.accessor(bind, "MAT4");
     },
     "joint 0 of their skin, which is no node, or whose inverse bind matrix is missing", nullptr},

    {"a loop of nodes",
     [](Sound& b) {
       b.json["nodes"][0]["children"] = {1};
       b.json["nodes"][1]["children"] = {0};
     },
     "", ""},
    {"a node below itself", [](Sound& b) { b.json["nodes"][0]["children"] = {0}; }, "", ""},
    {"a node with a matrix",
     [](Sound& b) { b.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; }, "",
     ""},

    {"ten thousand targets", [](Sound& b) { b.targets(10'000); }, "", ""},
    {"a clip of length 0",
     [](Sound& b) {
       b.replace({0}, {0.5f, 0, 0});
     },
     "", ""},
    {"two channels of one thing", [](Sound& b) { b.add(0, "translation"); }, "", ""},
    {"a channel of no node", [](Sound& b) { b.clip()["channels"][0]["target"].erase("node"); }, "", ""},
};

void expect_one_line(const std::string& said, const std::string& part) {
  EXPECT_ERROR(said, part);
  for (const char c : said) EXPECT_TRUE(static_cast<unsigned char>(c) >= 32) << said;
}

std::shared_ptr<const AssetData> flat_of(const dermis::Scene& scene) {
  return setup::flattened(api::placed_scene(scene));
}

void expect_finite(const AssetData& scene) {
  for (const Primitive& primitive : scene.primitives)
    for (const Vertex& v : primitive.vertices) {
      EXPECT_TRUE(std::isfinite(glm::length(v.position_m)));
      EXPECT_NEAR(glm::length(v.normal), 1, 1e-3);
      EXPECT_NEAR(glm::length(glm::vec3(v.tangent)), 1, 1e-3);
    }
}

TEST(HostileAnimations, AreOneLineOrPlay) {
  const TempFolder temp;
  const Warnings quiet;
  for (const Hostile& h : hostile) {
    SCOPED_TRACE(h.name);
    Sound file;
    h.spoil(file);
    const fs::path path = file.write(temp.path());
    const auto load = [&](const SceneOptions& options) {
      return tests::thrown<InputError>([&] { Asset::load(path, options); });
    };

    if (*h.at_rest != '\0') {
      expect_one_line(load({}), h.at_rest);
      expect_one_line(load({.clip = "0", .time_s = 0.5}), h.at_rest);
      continue;
    }
    const Asset asset = Asset::load(path);
    EXPECT_EQ(asset.clips(), std::vector<std::string>{"0"});
    dermis::Scene scene;
    const InstanceId id = scene.add({.asset = asset});
    const std::uint64_t before = scene.changes(id).rig;
    if (*h.in_clip != '\0') {
      expect_one_line(load({.clip = "0", .time_s = 0.5}), h.in_clip);
      expect_one_line(tests::thrown<InputError>([&] { scene.pose(id, "0", 0.5); }), h.in_clip);
      EXPECT_EQ(scene.changes(id).rig, before);
      EXPECT_FALSE(scene.instance(id).pose);
      continue;
    }
    for (const double seconds : {-1e300, -1.0, 0.0, 0.5, 1.0, 1e300}) {
      scene.pose(id, "0", seconds);
      expect_finite(*flat_of(scene));
    }
    EXPECT_GE(asset.clip_end_s("0"), 0);
    EXPECT_EQ(load({.clip = "0", .time_s = 0.5}), "nothing was thrown");
  }
}

// What a program may say of a pose that no file has said.
TEST(HostilePoses, AreOneLineAndChangeNothing) {
  const TempFolder temp;
  const Warnings quiet;
  Sound file;
  file.hangs_on(0);
  file.targets(2);
  file.json["nodes"].push_back({{"name", "joint"}});
  file.json["nodes"].push_back(
      {{"name", "fixed"}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}});
  file.json["nodes"].push_back({{"name", "two\nlines"}});
  const Asset asset = Asset::load(file.write(temp.path()));
  dermis::Scene scene;
  const InstanceId id = scene.add({.asset = asset});
  scene.pose(id, "", 0.25);
  const auto placed = flat_of(scene);
  const auto refuse = [&](const RigPose& pose, const std::string& says) {
    SCOPED_TRACE(says);
    const std::uint64_t before = scene.changes(id).rig;
    expect_one_line(tests::thrown<InputError>([&] { scene.set_pose(id, pose); }), says);
    EXPECT_EQ(scene.changes(id).rig, before);
    EXPECT_EQ(scene.instance(id).pose->clip->seconds, 0.25);
    EXPECT_THROW(scene.add({.asset = asset, .pose = pose}), InputError);
    EXPECT_EQ(scene.instances().size(), 1u);
  };
  const auto joint = [](const JointTransform& transform) { return RigPose{.joints = {transform}}; };
  using Vector = std::array<double, 3>;
  using Quaternion = std::array<double, 4>;

  refuse({.clip = ClipTime{"run", 0}}, "has no clip 'run'; there are: 0");
  refuse({.clip = ClipTime{"0\n1", 0}}, "has no clip");
  refuse({.clip = ClipTime{"", infinite}}, "clip.seconds must be finite, got inf");
  refuse({.clip = ClipTime{"", 0}, .second = ClipTime{"", nan_value}}, "second.seconds must be finite");
  refuse({.second = ClipTime{"none", 0}}, "has no clip 'none'");
  refuse({.blend = 1.01}, "blend must be 0 to 1, got 1.01");
  refuse({.blend = -infinite}, "blend must be 0 to 1, got -inf");
  refuse({.weights = {{"0", 100.5}}}, "weight '0' must be -100 to 100");
  refuse({.weights = {{"0", -infinite}}}, "weight '0' must be -100 to 100");
  refuse({.weights = {{"", 1}}}, "has no morph weight ''; there are: 0, 1");
  refuse(joint({.name = "joint"}), "has 2 joints of the name 'joint'");
  refuse(joint({.name = "fixed"}), "has a matrix in its file and cannot be moved");
  refuse(joint({.name = ""}), "has no joint ''; there are: ");
  refuse(joint({.name = "two lines"}), "has no joint 'two lines'; there are: ");
  refuse(joint({.name = "0", .translation = Vector{1e7, 0, 0}}), "translation of joint '0' must be");
  refuse(joint({.name = "0", .translation = Vector{0, 0, infinite}}), "translation of joint '0' must be");
  refuse(joint({.name = "0", .rotation = Quaternion{0, 0, 0, 0}}), "the length of the rotation");
  refuse(joint({.name = "0", .rotation = Quaternion{nan_value, 0, 0, 1}}), "rotation of joint '0'");
  refuse(joint({.name = "0", .scale = Vector{1, nan_value, 1}}), "scale of joint '0' must be");
  refuse(joint({.name = "0", .scale = Vector{1, 1, 1e9}}), "scale of joint '0' must be");
  EXPECT_EQ(placed->primitives[0].vertices[0].position_m,
            flat_of(scene)->primitives[0].vertices[0].position_m);
  expect_one_line(tests::thrown<InputError>([&] { scene.pose(InstanceId{77}, "", 0); }), "no instance 77");

  // At the ends of the ranges, and with nothing left of a mesh, they stand.
  for (const RigPose& pose :
       {RigPose{}, RigPose{.blend = 1}, RigPose{.weights = {{"0", -100}, {"0", 100}, {"1", 100}}},
        joint({.name = "0", .scale = Vector{0, 0, 0}}), joint({.name = "0", .scale = Vector{-1000, 0, 1}}),
        joint({.name = "0", .translation = Vector{-9e5, 0, 0}, .rotation = Quaternion{0, 0, 0, -1e6}}),
        RigPose{.clip = ClipTime{"", -1e300}, .second = ClipTime{"0", 1e300}, .blend = 0.5}}) {
    scene.set_pose(id, pose);
    expect_finite(*flat_of(scene));
  }
}

// A file that is too large to be posed is loaded in its pose, and says why it cannot be posed.
TEST(HostilePoses, OfWhatKeepsNoRigSayWhy) {
  AssetData large = sphere(0.1);
  large.name = "large.glb";
  large.clips = {"talk"};
  large.why_no_rig = "more than 5000000 vertices";
  const Asset asset = Asset::State::make(measured(std::move(large)));
  dermis::Scene scene;
  const InstanceId id = scene.add({.asset = asset});
  expect_one_line(
      tests::thrown<InputError>([&] { scene.pose(id, "talk", 0); }),
      "large.glb: cannot be posed once it is loaded: more than 5000000 vertices; a scene file can");
  expect_one_line(tests::thrown<InputError>([&] { asset.clip_end_s("talk"); }), "cannot be posed");
}

}  // namespace
}  // namespace dermis::scene::test
