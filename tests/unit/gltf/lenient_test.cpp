// SPDX-License-Identifier: MIT
// What differs from the specification in something that the picture does not need: it is drawn, and a warning
// says so. docs/assets.md has the table.
#include <cmath>
#include <cstring>
#include <limits>

#include "head/scene/rig/rig.h"
#include "support.h"

namespace dermis::scene::test {
namespace {

/// A triangle of skin; `warning` is what loading it after `bend` says.
struct Drawn {
  AssetData scene;
  std::string warnings;
};

template <class Bend>
Drawn drawn(const Bend& bend, const LoadOptions& options = {}) {
  Builder b;
  b.triangle();
  b.json["materials"] = {{{"name", "skin"}}};
  b.json["meshes"][0]["primitives"][0]["material"] = 0;
  bend(b);
  const Warnings warnings;
  AssetData scene = b.load(options);
  return {std::move(scene), warnings.all()};
}

/// Expects the triangle where it stands in a sound file.
template <class Bend>
void expect_drawn(const Bend& bend, const std::string& warning) {
  const Drawn made = drawn(bend);
  ASSERT_GE(made.scene.primitives.size(), 1u) << warning;
  expect_near(made.scene.primitives[0].vertices[1].position_m, {0.2f, 0, 0});
  EXPECT_NE(made.warnings.find(warning), std::string::npos) << "'" << warning << "' in: " << made.warnings;
}

Json& primitive_of(Builder& b) { return b.json["meshes"][0]["primitives"][0]; }

}  // namespace

TEST(GltfLenient, EmptyAndNullMembersAreNotThere) {
  for (const char* member : {"animations", "cameras", "images", "textures", "samplers", "skins",
                             "extensionsUsed", "extensionsRequired", "nosuchthing"})
    for (const Json& empty : {Json::array(), Json(nullptr)})
      expect_drawn([&](Builder& b) { b.json[member] = empty; },
                   std::string("read as if not there: ") + member);
  for (const char* member : {"translation", "rotation", "scale", "matrix", "children", "weights"})
    expect_drawn([&](Builder& b) { b.json["nodes"][0][member] = nullptr; }, member);
  for (const char* member : {"children", "weights", "rotation"})
    expect_drawn([&](Builder& b) { b.json["nodes"][0][member] = Json::array(); }, member);
  expect_drawn([](Builder& b) { primitive_of(b)["targets"] = Json::array(); }, "targets");
  expect_drawn([](Builder& b) { b.json["scenes"] = Json::array(); }, "scenes");
}

// Where nothing that is shown needs them.
TEST(GltfLenient, ElementsOfAnotherTypeAreEmpty) {
  for (const char* array : {"meshes", "nodes", "materials"})
    for (const Json& element : {Json(5), Json("five"), Json::array({1}), Json(true)})
      expect_drawn(
          [&](Builder& b) {
            b.json["scenes"] = {{{"nodes", {0}}}};
            b.json[array].push_back(element);
          },
          fmt::format("of another type than the others, read as if not there: {}[1]", array));
  expect_drawn([](Builder& b) { b.json["samplers"] = {5}; }, "pictures repeat, and are filtered");
}

TEST(GltfLenient, MeshesAndNodesThatNothingShownNeedsMayBeBroken) {
  const auto unused = [](const char* array, const Json& element) {
    return [=](Builder& b) {
      b.json["scenes"] = {{{"nodes", {0}}}};
      b.json[array].push_back(element);
    };
  };
  expect_drawn(unused("meshes", {{"primitives", 5}}), "");
  expect_drawn(unused("meshes", {{"primitives", {{"attributes", {{"POSITION", 99}}}}}}), "");
  expect_drawn(unused("nodes", {{"mesh", 99}}), "");
  expect_drawn(unused("nodes", {{"mesh", 0}, {"skin", 7}}), "");

  Builder b;
  b.triangle();
  b.json["nodes"].push_back({{"mesh", 99}});
  b.json["scenes"] = {{{"nodes", {0, 1}}}};
  EXPECT_ERROR(b.error(), "there is no mesh 99");
  b.json["nodes"][1] = {{"mesh", 1}};
  b.json["meshes"].push_back({{"primitives", 5}});
  EXPECT_ERROR(b.error(), "primitives");
}

TEST(GltfLenient, ClipsThatMoveNothingAreLeftOut) {
  for (const Json& clip :
       {Json{{"name", "Take 001"}, {"channels", Json::array()}, {"samplers", Json::array()}},
        Json{{"channels", nullptr}, {"samplers", nullptr}}, Json::object()}) {
    expect_drawn([&](Builder& b) { b.json["animations"] = Json::array({clip}); },
                 "moves nothing, and is left out");
    EXPECT_TRUE(drawn([&](Builder& b) { b.json["animations"] = Json::array({clip}); }).scene.clips.empty());
  }
}

TEST(GltfLenient, NodesStandAsNearAsTheyCan) {
  expect_drawn([](Builder& b) { b.json["nodes"][0]["rotation"] = {0, 0, 0, 1.02}; }, "no unit quaternion");
  expect_drawn([](Builder& b) { b.json["nodes"][0]["rotation"] = {0, 0, 0, 0}; }, "quaternion of length 0");
  expect_drawn(
      [](Builder& b) {
        b.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1.0000001};
      },
      "not quite 0 0 0 1");
  expect_drawn(
      [](Builder& b) {
        b.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
        b.json["nodes"][0]["translation"] = {3, 0, 0};
      },
      "the matrix counts");
  expect_drawn([](Builder& b) { b.json["scenes"][0]["nodes"] = {0, 0}; }, "shows node 0 twice");
  expect_drawn(
      [](Builder& b) {
        b.json["nodes"].push_back({{"children", {0}}, {"translation", {0, 0, 0}}});
        b.json["nodes"].push_back({{"children", {0}}, {"translation", {9, 0, 0}}});
        b.json["scenes"][0]["nodes"] = {1, 2};
      },
      "has two parents");
  expect_drawn([](Builder& b) { b.json["scene"] = 7; }, "names no scene");
  expect_drawn(
      [](Builder& b) {
        b.json["nodes"].push_back({{"skin", 0}, {"weights", {1}}, {"camera", 3}});
        b.json["skins"] = Json::array({{{"joints", {0}}}});
      },
      "has a skin but no mesh");
}

TEST(GltfLenient, VerticesKeepWhatCanBeRead) {
  // A coordinate becomes that of a corner beside it.
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e9f}) {
    const Drawn made = drawn([&](Builder& b) {
      primitive_of(b)["attributes"]["TEXCOORD_0"] = b.accessor({0.25f, 0.5f, 1, bad, 0, 1}, "VEC2");
    });
    EXPECT_EQ(made.scene.primitives[0].vertices[1].uv0, glm::vec2(0.25f, 0.5f));
    EXPECT_NE(made.warnings.find("texture coordinates that are not finite"), std::string::npos);
  }

  const auto with = [](const char* semantic, const std::vector<float>& values, const char* type,
                       int component = 5126) {
    return [=](Builder& b) { primitive_of(b)["attributes"][semantic] = b.accessor(values, type, component); };
  };
  expect_drawn(with("NORMAL", {0, 0, 1}, "VEC3"), "NORMAL cannot be read, and is left out");
  expect_drawn(with("COLOR_0", {1, 1, 1}, "VEC3"), "COLOR_0 cannot be read");
  expect_drawn(with("_WRINKLES", {1}, "SCALAR"), "");
  expect_drawn(with("COLOR_0", {1, NAN, 1, 1, 1, 1, 1, 1, 1}, "VEC3"), "COLOR_0 is not finite everywhere");
  expect_drawn(with("JOINTS_0", std::vector<float>(12, 0), "VEC4", 5121), "has JOINTS_0 without WEIGHTS_0");
  expect_drawn([](Builder& b) { b.json["accessors"][0]["min"] = {0}; }, "");
  expect_drawn([](Builder& b) { b.json["accessors"][0]["normalized"] = true; },
               "normalized is not for FLOAT");
  expect_drawn([](Builder& b) { primitive_of(b)["material"] = 4; }, "names no material");

  // An element that nothing uses refuses nothing.
  expect_drawn(
      [](Builder& b) {
        b.json["bufferViews"].push_back({{"buffer", 0}, {"byteLength", 1000}});
      },
      "");
  expect_drawn(
      [](Builder& b) {
        b.json["accessors"].push_back({{"componentType", 1}, {"count", 1}, {"type", "VEC3"}});
        b.json["meshes"].push_back({{"primitives", {{{"attributes", {{"POSITION", 2}}}}}}});
      },
      "");
  expect_drawn([](Builder& b) { b.json["buffers"].push_back({{"byteLength", 9}, {"uri", "gone.bin"}}); }, "");
  expect_drawn([](Builder& b) { b.json["buffers"][0]["byteLength"] = 62; }, "is cut off");
}

TEST(GltfLenient, MorphTargetsOfOnePrimitive) {
  const auto bend = [](Builder& b) {
    const int moved = b.accessor({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    const Json plain = primitive_of(b);
    primitive_of(b)["targets"] = {{{"POSITION", moved}, {"NORMAL", moved}}};
    b.json["meshes"][0]["primitives"] = {plain, primitive_of(b)};
    b.json["meshes"][0]["weights"] = {1};
  };
  const Drawn made = drawn(bend);
  ASSERT_EQ(made.scene.primitives.size(), 2u);
  expect_near(made.scene.primitives[0].vertices[1].position_m, {0.2f, 0, 0});
  expect_near(made.scene.primitives[1].vertices[1].position_m, {0.2f, 0, 1});
  EXPECT_NE(made.warnings.find("morphs NORMAL, which the primitive does not have"), std::string::npos);
  EXPECT_TRUE(made.scene.rig);

  expect_drawn(
      [](Builder& b) {
        b.json["meshes"][0]["weights"] = {1, 2};
      },
      "has 2 weights for 0 morph targets");
  expect_drawn(
      [](Builder& b) {
        const int times = b.accessor({0, 1}, "SCALAR");
        b.json["animations"] =
            Json::array({{{"samplers", {{{"input", times}, {"output", times}}}},
                          {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}}});
      },
      "animates weights of a node without morph targets");
}

TEST(GltfLenient, APrimitiveWithoutJointsFollowsItsNode) {
  expect_drawn(
      [](Builder& b) {
        b.json["nodes"][0]["skin"] = 0;
        b.json["nodes"].push_back({{"translation", {5, 0, 0}}});
        b.json["skins"] = Json::array({{{"joints", {1}}}});
      },
      "it follows the node");
  expect_drawn(
      [](Builder& b) {
        b.json["nodes"][0]["skin"] = 0;
        b.json["skins"] = Json::array({{{"joints", Json::array()}}});
      },
      "has no joints");
  expect_drawn(
      [](Builder& b) {
        primitive_of(b)["attributes"]["JOINTS_0"] = b.accessor(std::vector<float>(12, 0), "VEC4");
        primitive_of(b)["attributes"]["WEIGHTS_0"] = b.accessor(std::vector<float>(12, 0.25f), "VEC4");
        b.json["nodes"][0]["skin"] = 0;
        b.json["nodes"].push_back(Json::object());
        b.json["skins"] = Json::array({{{"joints", {1}}}});
      },
      "JOINTS_0 should not be made of FLOAT");
}

// The node may stand anywhere: only the joint says where the vertex is.
TEST(GltfLenient, VerticesWithoutWeightHangOnTheirFirstJoint) {
  const auto bend = [](float first, float weight) {
    return [=](Builder& b) {
      std::vector<float> joints(12, 0), weights(12, 0);
      for (const std::size_t vertex : {0, 1, 2}) weights[4 * vertex] = vertex == 1 ? weight : 1;
      joints[4] = first;
      primitive_of(b)["attributes"]["JOINTS_0"] = b.accessor(joints, "VEC4", 5121);
      primitive_of(b)["attributes"]["WEIGHTS_0"] = b.accessor(weights, "VEC4");
      b.json["nodes"][0]["skin"] = 0;
      b.json["nodes"][0]["translation"] = {100, 0, 0};
      b.json["nodes"].push_back({{"translation", {0, 3, 0}}});
      b.json["nodes"].push_back({{"translation", {0, 0, 7}}});
      b.json["skins"] = Json::array({{{"joints", {1, 2}}}});
    };
  };
  const auto expect_at = [&](float first, float weight, const glm::vec3& place, const std::string& warning) {
    const Drawn made = drawn(bend(first, weight));
    expect_near(made.scene.primitives[0].vertices[1].position_m, place);
    EXPECT_NE(made.warnings.find(warning), std::string::npos) << made.warnings;
    ASSERT_TRUE(made.scene.rig);
    AssetData again = made.scene;
    take_pose(*again.rig, posed(*again.rig, again.rig->rest, "file"), again);
    expect_near(again.primitives[0].vertices[1].position_m, place);
  };
  const char* loose = "has vertices without weight, which hang on their first joint";
  expect_at(1, 0, {0.2f, 0, 7}, loose);
  expect_at(0, 0, {0.2f, 3, 0}, loose);
  expect_at(1, 0.5f, {0.2f, 0, 7}, "");
  expect_at(9, 1, {0.2f, 3, 0}, loose);
  expect_at(1, NAN, {0.2f, 0, 7}, "WEIGHTS_0 is not finite everywhere");
  expect_at(1, -2, {0.2f, 0, 7}, "WEIGHTS_0 is below 0 somewhere");
}

TEST(GltfLenient, MaterialsTakeTheNearestValue) {
  const auto material = [](const Json& members) {
    return drawn([&](Builder& b) { b.json["materials"][0].update(members); }).scene.materials[0];
  };
  EXPECT_EQ(material({{"pbrMetallicRoughness", {{"roughnessFactor", 1.5}}}}).roughness, 1);
  EXPECT_EQ(material({{"pbrMetallicRoughness", {{"roughnessFactor", "0.5"}}}}).roughness, 1);
  EXPECT_EQ(material({{"pbrMetallicRoughness", {{"baseColorFactor", {-0.1, 0.5, 2, 1}}}}}).base_colour,
            glm::vec4(0, 0.5f, 1, 1));
  EXPECT_EQ(material({{"emissiveFactor", {2, 0, 0}}}).emissive, glm::vec3(2, 0, 0));
  EXPECT_EQ(material({{"alphaMode", "SEETHROUGH"}}).alpha_mode, AssetAlpha::opaque);
  EXPECT_EQ(material({{"doubleSided", 1}}).double_sided, false);
  EXPECT_EQ(material({{"extensions", {{"KHR_materials_ior", {{"ior", 0.5}}}}}}).ior, 1);
  EXPECT_TRUE(material({{"extensions", {{"KHR_materials_unlit", true}}}}).skin);
  EXPECT_FALSE(material({{"normalTexture", {{"index", 3}}}}).normal_map.present());
}

// Skin needs its colour; nothing else does its picture.
TEST(GltfLenient, PicturesThatAreMissing) {
  const auto bend = [](const char* uri, bool accessory) {
    return [=](Builder& b) {
      b.json["images"] = Json::array({{{"uri", uri}}, {{"uri", one_pixel}}});
      b.json["textures"] = {{{"source", 0}}, {{"source", 1}}};
      const Json colour = {{"baseColorTexture", {{"index", 0}}}};
      b.json["materials"].push_back({{"name", "lash"}});
      b.json["materials"][accessory ? 1 : 0]["pbrMetallicRoughness"] = colour;
      b.json["materials"][1]["normalTexture"] = {{"index", 1}};
      Json lash = primitive_of(b);
      lash["material"] = 1;
      b.json["meshes"][0]["primitives"].push_back(lash);
    };
  };
  for (const char* uri :
       {"gone.png", "C:\\lash.png", "data:image/png;base64,AAAA", "data:image/png;base64,A*"}) {
    const Drawn made = drawn(bend(uri, true));
    EXPECT_NE(made.warnings.find("; the maps that it is for are left out"), std::string::npos) << uri;
    EXPECT_FALSE(made.scene.materials[1].base_colour_map.present());
    EXPECT_EQ(made.scene.materials[1].normal_map.image, 0) << "the other picture is still there";
    EXPECT_EQ(made.scene.images.size(), 1u);

    Builder skin;
    skin.triangle();
    skin.json["materials"] = {{{"name", "skin"}}};
    primitive_of(skin)["material"] = 0;
    bend(uri, false)(skin);
    EXPECT_NE(skin.error(), "") << uri;
  }

  // The file is damaged behind its header.
  const std::string png =
      "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQ";
  const Drawn made = drawn(bend(png.c_str(), true));
  EXPECT_FALSE(made.scene.materials[1].base_colour_map.present());
  EXPECT_EQ(made.scene.materials[1].normal_map.image, 0);
  EXPECT_EQ(made.scene.images.size(), 1u);
}

TEST(GltfLenient, LampsAndCamerasThatExportersWrite) {
  const auto light = [](const Json& members) {
    Json lamp = {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.4}}}};
    lamp.update(members);
    return drawn([&](Builder& b) {
      b.json["extensions"]["KHR_lights_punctual"]["lights"] = {lamp};
      b.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
      b.json["scenes"][0]["nodes"].push_back(1);
    });
  };
  const auto cone = [&](double inner, double outer) {
    return light({{"spot", {{"innerConeAngle", inner}, {"outerConeAngle", outer}}}}).scene.lights.at(0);
  };
  EXPECT_NEAR(cone(0.4, 0.4).inner_cone_rad, 0.4, 1e-3);
  EXPECT_LT(cone(0.4, 0.4).inner_cone_rad, cone(0.4, 0.4).outer_cone_rad);
  EXPECT_LT(cone(0.5, 0.4).inner_cone_rad, 0.4f);
  EXPECT_NEAR(cone(0.5, 3).outer_cone_rad, 1.5708, 1e-4);
  EXPECT_TRUE(light({{"spot", {{"outerConeAngle", 0}}}}).scene.lights.empty());
  EXPECT_NEAR(light({{"spot", nullptr}}).scene.lights.at(0).outer_cone_rad, 0.785398, 1e-6);
  EXPECT_EQ(light({{"range", 0}}).scene.lights.at(0).range_m, 0);
  EXPECT_EQ(light({{"color", {1, -0.001, 1}}}).scene.lights.at(0).colour, glm::vec3(1, 0, 1));
  EXPECT_EQ(light({{"intensity", -1}}).scene.lights.at(0).colour, glm::vec3(0));
  EXPECT_TRUE(light({{"type", "area"}}).scene.lights.empty());

  const auto camera = [](const Json& perspective) {
    return drawn([&](Builder& b) {
             b.json["cameras"] = {{{"type", "perspective"}, {"perspective", perspective}}};
             b.json["nodes"][0]["camera"] = 0;
           })
        .scene.cameras;
  };
  EXPECT_EQ(camera({{"yfov", 0.5}, {"znear", 0}}).at(0).znear_m, 0.01f);
  EXPECT_FALSE(camera({{"yfov", 0.5}, {"znear", 1}, {"zfar", 0.5}}).at(0).zfar_m);
  EXPECT_TRUE(camera({{"yfov", -1}, {"znear", 1}}).empty());
}

TEST(GltfLenient, Headers) {
  expect_drawn([](Builder& b) { b.json.erase("asset"); }, "does not say its version");
  expect_drawn([](Builder& b) { b.json["asset"]["version"] = 2; }, "");
  expect_drawn([](Builder& b) { b.json["extensionsRequired"] = {"KHR_materials_clearcoat"}; },
               "requires the extension KHR_materials_clearcoat, which is not read");
}

TEST(GltfLenient, Containers) {
  Builder b;
  b.triangle();
  const std::string whole = b.glb();
  std::uint32_t json_bytes = 0;
  std::memcpy(&json_bytes, whole.data() + 12, 4);
  const std::string json = whole.substr(20, json_bytes), bin = whole.substr(20 + json_bytes);
  const auto glb = [&](const std::string& text, std::uint32_t json_length, std::uint32_t length,
                       const std::string& rest) {
    std::string out = whole.substr(0, 20) + text + rest;
    std::memcpy(out.data() + 8, &length, 4);
    std::memcpy(out.data() + 12, &json_length, 4);
    return out;
  };
  const auto size = static_cast<std::uint32_t>(whole.size());
  const struct {
    const char* what;
    std::string bytes, warning;
  } files[] = {
      {"no length", glb(json, json_bytes, 0, bin), "header says 0 bytes"},
      {"too short", glb(json, json_bytes, size - 8, bin), "reaches past the length"},
      {"too long", glb(json, json_bytes, size + 100, bin), "header says"},
      {"byte-order mark", glb("\xEF\xBB\xBF" + json + " ", json_bytes + 4, size + 4, bin), "byte-order mark"},
      {"not padded", glb(json + " ", json_bytes + 1, size + 1, bin), "not a multiple of 4"},
      {"padding not counted", glb(json + "    ", json_bytes + 1, size + 4, bin), "not a multiple of 4"},
      {"chunks twice", glb(json, json_bytes, 2 * size - 20 - json_bytes, bin + bin), "has two binary chunks"},
      {"rest", glb(json, json_bytes, size + 3, bin + "abc"), "3 bytes behind the chunks"},
  };
  const TempFolder folder;
  for (const auto& file : files) {
    write_text(folder.path() / "file.glb", file.bytes);
    const Warnings warnings;
    EXPECT_EQ(error_of(folder.path() / "file.glb"), "") << file.what;
    EXPECT_TRUE(warnings.any_with(file.warning)) << file.what << ": " << warnings.all();
  }
}

}  // namespace dermis::scene::test
