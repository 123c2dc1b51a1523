// SPDX-License-Identifier: MIT
// Materials, their pictures and where these lie, on files built in memory.
#include <cmath>

#include "support.h"
#include "support/log_lines.h"

namespace dermis::scene::test {

namespace {

void add_texture(Builder& b) {
  b.json["images"] = Json::array({{{"uri", one_pixel}}});
  b.json["textures"] = Json::array({{{"source", 0}}});
}

/// A triangle whose one material is `material`.
Builder with_material(const Json& material) {
  Builder b;
  b.triangle();
  add_texture(b);
  b.json["materials"] = Json::array({material});
  Json& primitive = b.json["meshes"][0]["primitives"][0];
  primitive["material"] = 0;
  primitive["attributes"]["TEXCOORD_1"] = Json(primitive["attributes"]["TEXCOORD_0"]);
  return b;
}

}  // namespace

TEST(GltfMaterial, FactorsMapsAndExtensions) {
  const AssetData scene =
      with_material(
          Json::parse(R"({"name": "eye", "alphaMode": "MASK", "alphaCutoff": 0.3, "doubleSided": true,
    "pbrMetallicRoughness": {
      "baseColorFactor": [0.1, 0.2, 0.3, 0.4], "metallicFactor": 0.5, "roughnessFactor": 0.25,
      "baseColorTexture": {"index": 0}},
    "normalTexture": {"index": 0, "scale": -2, "texCoord": 1},
    "occlusionTexture": {"index": 0, "strength": 0.5}, "emissiveFactor": [1, 0.5, 0],
    "extensions": {
      "KHR_materials_emissive_strength": {"emissiveStrength": 4},
      "KHR_materials_ior": {"ior": 1.33}, "KHR_materials_unlit": {},
      "KHR_materials_specular": {
        "specularFactor": 0.5, "specularColorFactor": [2, 1, 0], "specularTexture": {"index": 0}}}})"))
          .load();

  const Material& m = scene.materials[0];
  EXPECT_EQ(m.base_colour, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
  EXPECT_EQ(m.metallic, 0.5f);
  EXPECT_EQ(m.roughness, 0.25f);
  EXPECT_EQ(m.normal_map.scale, -2);
  EXPECT_EQ(m.normal_map.uv_set, 1);
  EXPECT_EQ(m.occlusion_map.scale, 0.5f);
  EXPECT_EQ(m.emissive, glm::vec3(4, 2, 0));
  EXPECT_EQ(m.ior, 1.33f);
  EXPECT_EQ(m.specular, 0.5f);
  EXPECT_EQ(m.specular_colour, glm::vec3(2, 1, 0));
  EXPECT_EQ(m.specular_map.channel, 3);
  EXPECT_TRUE(m.unlit && m.double_sided && m.skin);
  EXPECT_EQ(m.alpha_mode, AssetAlpha::mask);
  EXPECT_EQ(m.alpha_cutoff, 0.3f);

  ASSERT_EQ(scene.images.size(), 1u);
  EXPECT_EQ(scene.images[0].pixels->rgba, (std::vector<std::uint8_t>{255, 0, 0, 127}));
}

// As its extension says, what stands beside it is for readers without it.
TEST(GltfMaterial, SpecularGlossinessCounts) {
  const auto older = [](const Json& members) {
    return Json{{"name", "skin"}, {"extensions", {{"KHR_materials_pbrSpecularGlossiness", members}}}};
  };
  Json material = older({{"diffuseFactor", {0.5, 0.25, 1, 1}},
                         {"diffuseTexture", {{"index", 0}}},
                         {"glossinessFactor", 0.75},
                         {"specularFactor", {1, 1, 1}}});
  const Material plain = with_material(material).load().materials[0];
  EXPECT_EQ(plain.base_colour, glm::vec4(0.5f, 0.25f, 1, 1));
  EXPECT_TRUE(plain.base_colour_map.present());
  EXPECT_EQ(plain.metallic, 0);
  EXPECT_EQ(plain.roughness, 0.25f);

  // The one pixel's alpha is 127.
  const AssetData mapped = with_material(older({{"diffuseTexture", {{"index", 0}}},
                                                {"glossinessFactor", 0.5},
                                                {"specularGlossinessTexture", {{"index", 0}}}}))
                               .load();
  const Material& m = mapped.materials[0];
  EXPECT_EQ(m.roughness, 1);
  EXPECT_EQ(mapped.images[static_cast<std::size_t>(m.metallic_roughness_map.image)].pixels->rgba,
            (std::vector<std::uint8_t>{255, 192, 0, 255}));
  EXPECT_EQ(mapped.images[static_cast<std::size_t>(m.base_colour_map.image)].pixels->rgba,
            (std::vector<std::uint8_t>{255, 0, 0, 127}));

  for (const Json& beside :
       {Json::object(), Json{{"roughnessFactor", 0.9}, {"baseColorFactor", {1, 0, 0, 1}}}}) {
    material["pbrMetallicRoughness"] = beside;
    const Material both = with_material(material).load().materials[0];
    EXPECT_EQ(both.base_colour, plain.base_colour);
    EXPECT_EQ(both.roughness, plain.roughness);
    EXPECT_EQ(both.metallic, 0);
  }
}

TEST(GltfMaterial, LightPassesASurfaceAndIsScatteredBySkin) {
  const auto shell = [](const char* name, const char* mode) {
    return Json{{"name", name},
                {"alphaMode", mode},
                {"extras", {{"dermis", {{"skin", std::string(name) == "skin"}}}}},
                {"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 0.75}}}}}};
  };
  const Warnings warnings;
  const Material cornea = with_material(shell("cornea", "OPAQUE")).load().materials[0];
  EXPECT_EQ(cornea.alpha_mode, AssetAlpha::blend);
  EXPECT_EQ(cornea.transmission, 0.75f);
  EXPECT_FALSE(warnings.any_with("transmission")) << warnings.all();

  // Of a map the mean counts: the one pixel is all red.
  Json mapped = shell("lens", "OPAQUE");
  mapped["extensions"]["KHR_materials_transmission"]["transmissionTexture"] = {{"index", 0}};
  EXPECT_EQ(with_material(mapped).load().materials[0].transmission, 0.75f);

  const Material skin = with_material(shell("skin", "OPAQUE")).load().materials[0];
  EXPECT_TRUE(skin.skin);
  EXPECT_EQ(skin.transmission, 0);
  const Material cut_out = with_material(shell("net", "MASK")).load().materials[0];
  EXPECT_EQ(cut_out.alpha_mode, AssetAlpha::mask);
  EXPECT_TRUE(
      warnings.any_with("KHR_materials_transmission of skin and of cut-out materials is left out: 'skin'"))
      << warnings.all();
  EXPECT_TRUE(warnings.any_with("is left out: 'net'")) << warnings.all();
}

// One line that names what is drawn as a surface although it would be skin; what is not used is not named.
TEST(GltfMaterial, BlendedSkinIsASurface) {
  Builder b;
  for (int i = 0; i < 3; ++i) {
    b.triangle();
    b.json["meshes"][i]["primitives"][0]["material"] = i;
  }
  b.json["materials"] = {{{"name", "skin A"}, {"alphaMode", "BLEND"}},
                         {{"name", "skin B"}, {"alphaMode", "MASK"}},
                         {{"name", "skin C"}, {"alphaMode", "BLEND"}},
                         {{"name", "skin D"}, {"alphaMode", "BLEND"}}};
  tests::LogLines said;
  const AssetData scene = b.load();
  LoadOptions by_name;
  by_name.skin_material = {"skin C"};
  const AssetData named = b.load(by_name);
  std::vector<std::string> lines = said.all;
  std::erase_if(lines, [](const std::string& line) { return line.find("BLEND") == std::string::npos; });

  EXPECT_FALSE(scene.materials[0].skin);
  EXPECT_TRUE(scene.materials[1].skin);
  EXPECT_FALSE(scene.materials[2].skin);
  EXPECT_EQ(scene.materials[0].alpha_mode, AssetAlpha::blend);
  EXPECT_EQ(scene.materials[0].ior, 1.5f) << "that of any surface";
  EXPECT_FALSE(named.materials[2].skin) << "--skin names what may be skin, not how it is drawn";
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NE(lines[0].find("'skin A', 'skin C'"), std::string::npos) << lines[0];
  EXPECT_NE(lines[1].find("'skin C'"), std::string::npos) << lines[1];
}

TEST(GltfMaterial, SkinIsAWordOfTheName) {
  const auto is_skin = [](const std::string& name) {
    Builder b;
    for (int i = 0; i < 2; ++i) {
      b.triangle();
      b.json["meshes"][i]["primitives"][0]["material"] = i;
    }
    b.json["materials"] = {{{"name", name}}, {{"name", "Hair"}}};
    const Warnings quiet;
    return b.load().materials[0].skin;
  };
  for (const char* name : {"skin", "Wolf3D_Skin", "Std_Skin_Head.001", "MI_Face_Skin_Baked",
                           "N00_000_00_Face_00_SKIN (Instance)", "headskin", "FaceSkin", "skinMat",
                           "SkinHead", "SKINHead", "M_SKIN", "skin1", "bodyskin", "skins"})
    EXPECT_TRUE(is_skin(name)) << name;
  for (const char* name : {"skinny_jeans", "SkinnyJeans", "SKINNY", "snakeskin_boots", "Buckskin", "skinning",
                           "SkinnedMesh", "moleskin", "Face"})
    EXPECT_FALSE(is_skin(name)) << name;
}

TEST(GltfMaterial, OfMaterialsThatNothingUsesOneCalledSkinSaysThatTheOnlyOtherIsNone) {
  Builder b;
  b.triangle();
  b.json["meshes"][0]["primitives"][0]["material"] = 0;
  b.json["materials"] = {{{"name", "Cloth"}}, {{"name", "Old"}}};
  {
    const Warnings warnings;
    EXPECT_TRUE(b.load().materials[0].skin);
    EXPECT_TRUE(warnings.any_with("of 2 materials only 'Cloth' is in use; it is drawn as skin"))
        << warnings.all();
  }

  b.json["materials"][1]["name"] = "Body_Skin";
  const Warnings warnings;
  EXPECT_FALSE(b.load().materials[0].skin);
  EXPECT_TRUE(
      warnings.any_with("no material is skin ('Body_Skin' is, and nothing uses it); name one with "
                        "skin_material: 'Cloth'"))
      << warnings.all();
}

TEST(GltfMaterial, SkinRule) {
  Builder b;
  for (int i = 0; i < 3; ++i) {
    b.triangle();
    b.json["meshes"][i]["primitives"][0]["material"] = i;
  }
  b.json["materials"] = {{{"name", "Eye"}}, {{"name", "FaceSkin"}}, {{"name", "Hair"}}};

  const auto skins = [](const AssetData& s) {
    std::string names;
    for (const Material& m : s.materials) names += m.skin ? m.name + " " : "";
    return names;
  };
  EXPECT_EQ(skins(b.load()), "FaceSkin ");
  EXPECT_EQ(b.load().materials[1].ior, 1.4f);
  EXPECT_EQ(b.load().materials[0].ior, 1.5f);

  LoadOptions named;
  named.skin_material = {"Hair"};
  EXPECT_EQ(skins(b.load(named)), "Hair ");
  named.skin_material = {"Ha[hi]r", "E*"};
  EXPECT_EQ(skins(b.load(named)), "Eye Hair ");
  named.skin_material = {"Hair", "Nose"};
  EXPECT_ERROR(b.error(named), "no material is called 'Nose'; there are: Eye, FaceSkin, Hair");

  b.json["materials"][0]["extras"] = {{"dermis", {{"skin", true}}}};
  EXPECT_EQ(skins(b.load()), "Eye ");
  b.json["materials"][0]["extras"] = {{"dermis", {{"skin", false}}}};
  EXPECT_EQ(skins(b.load()), "FaceSkin ");

  b.json["materials"][1]["name"] = "Face";
  const Warnings warnings;
  EXPECT_EQ(skins(b.load()), "");
  EXPECT_TRUE(warnings.any_with("no material is skin; name one with skin_material: 'Eye', 'Face', 'Hair'"))
      << warnings.all();
}

TEST(GltfMaterial, DermisExtrasAreReadInFull) {
  const SkinMaterial s = with_material(Json::parse(R"({"extras": {"dermis": {"skin": true, "mix": 0.25,
    "profile": {"name": "mine", "variances_mm2": [0.5, 2], "weights": [[0.5, 0.25, 1], [0.5, 0.75, 0]]},
    "specular": {"texture": 0, "channel": 1, "scale": 2},
    "roughness": {"texture": {"index": 0, "texCoord": 1}},
    "displacement": {"texture": 0, "mm": 3, "middle": 0.537},
    "detail": {"texture": {"index": 0, "texCoord": 1}, "scale": 0.5}, "lobes": [[1, 0.6], [2, 0.4]]}}})"))
                             .load()
                             .materials[0]
                             .skin_settings;

  ASSERT_TRUE(s.profile);
  EXPECT_EQ(s.profile->terms.size(), 2u);
  EXPECT_EQ(s.mix, 0.25f);
  EXPECT_EQ(s.specular.channel, 1);
  EXPECT_EQ(s.specular.scale, 2);
  EXPECT_EQ(s.roughness.channel, 1);  // green, as glTF has roughness
  EXPECT_EQ(s.roughness.uv_set, 1);

  EXPECT_EQ(s.displacement_mm, 3);
  EXPECT_EQ(s.displacement_middle, 0.537f);
  EXPECT_EQ(s.detail.image, 0);
  EXPECT_EQ(s.detail.uv_set, 1);
  EXPECT_EQ(s.detail.scale, 0.5f);
  ASSERT_EQ(s.lobes.size(), 2u);
  EXPECT_EQ(s.lobes[1].roughness_factor, 2);
}

TEST(GltfMaterial, DermisExtrasAreStrict) {
  const auto error = [](const std::string& dermis) {
    return with_material({{"extras", {{"dermis", Json::parse(dermis)}}}}).error();
  };

  EXPECT_ERROR(
      error(R"({"skinn": true})"),
      "unknown key 'skinn'; there are: skin, profile, mix, specular, roughness, displacement, detail, lobes");
  EXPECT_ERROR(error(R"({"specular": {"texture": 0, "chanel": 1}})"),
               "unknown key 'chanel'; there are: texture, channel, scale");
  EXPECT_ERROR(error(R"({"displacement": {"texture": 0}})"), "'mm' is missing");
  EXPECT_ERROR(error(R"({"specular": {"texture": 1}})"), "there is no texture 1");
  EXPECT_ERROR(error(R"({"detail": {"scale": 1}})"), "'texture' is missing");
  EXPECT_ERROR(error(R"({"detail": {"texture": 7}})"), "there is no texture 7");
  EXPECT_ERROR(error(R"({"detail": {"texture": 0, "scale": -1}})"), "must be 0 to 10");
  EXPECT_ERROR(error(R"({"specular": {"texture": 0, "channel": "X"}})"), "one of R, G, B, A");

  EXPECT_ERROR(error(R"({"mix": 1.5})"), "must be 0 to 1");
  EXPECT_ERROR(error(R"({"lobes": [[1, 0.5], [2, 0.4]]})"), "must sum to 1");
  EXPECT_ERROR(error(R"({"lobes": [[0, 1]]})"), "must be over 0");
  EXPECT_ERROR(error(R"({"lobes": []})"), "empty array");

  EXPECT_ERROR(error(R"({"profile": "no-such-skin"})"), "there are:");
  EXPECT_ERROR(error(R"({"profile": "/etc/passwd"})"), "relative to the scene");
  EXPECT_ERROR(error(R"({"profile": {"name": "x", "variances_mm2": [-1], "weights": [[1, 1, 1]]}})"),
               "extras.dermis.profile");
  EXPECT_ERROR(error(R"([])"), "must be an object");
}

TEST(GltfMaterial, ProfileFileLiesBesideTheScene) {
  const TempFolder folder;
  write_text(folder.path() / "mine.json",
             R"({"name": "mine", "variances_mm2": [1], "weights": [[1, 1, 1]]})");
  const Builder b = with_material({{"extras", {{"dermis", {{"profile", "mine.json"}}}}}});
  EXPECT_EQ(load_gltf(b.write(folder.path())).materials[0].skin_settings.profile->name, "mine");
}

TEST(GltfMaterial, FileTangentsServeOnlyAPlainNormalMap) {
  // Tangents along -x, against what the coordinates say: +x means that they were made anew.
  const auto tangent_x = [](const Json& normal_texture, float w) {
    Builder b = with_material({{"normalTexture", normal_texture}});
    b.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
        b.accessor({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    b.json["meshes"][0]["primitives"][0]["attributes"]["TANGENT"] =
        b.accessor({-1, 0, 0, w, -1, 0, 0, w, -1, 0, 0, w}, "VEC4");
    return b.load().primitives[0].vertices[0].tangent;
  };
  EXPECT_EQ(tangent_x({{"index", 0}}, 1).x, -1);
  EXPECT_EQ(tangent_x({{"index", 0}}, 0.3f).x, 1);  // no handedness: not usable
  const Json flip = {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"scale", {1, -1}}}}}}};
  const glm::vec4 flipped = tangent_x(flip, 1);
  EXPECT_EQ(flipped.x, 1);
  // v of the file runs along +y; flipped it runs along -y, so the picture's top is at +y and cross(n, t) = +y
  // agrees.
  EXPECT_EQ(flipped.w, 1);
}

TEST(GltfImages, PlainSourceStandsInForUnreadFormats) {
  Builder b = with_material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  b.json["images"].push_back({{"uri", "missing.ktx2"}});
  b.json["textures"][0]["extensions"] = {{"KHR_texture_basisu", {{"source", 1}}}};
  b.json["extensionsUsed"] = {"KHR_texture_basisu"};
  EXPECT_EQ(b.load().images.size(), 1u);
  b.json["textures"][0].erase("source");
  const Warnings warnings;
  EXPECT_FALSE(b.load().materials[0].base_colour_map.present());
  EXPECT_TRUE(warnings.any_with("no PNG or JPEG picture"));
  b.json["extensionsRequired"] = {"KHR_texture_basisu"};
  EXPECT_ERROR(b.error(), "requires the extension KHR_texture_basisu");
}

TEST(GltfImages, OnlyUsedImagesAreDecodedAndBadOnesNamed) {
  Builder b = with_material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  b.json["images"].push_back({{"uri", "nowhere.png"}});
  b.json["textures"].push_back({{"source", 1}});
  EXPECT_EQ(b.error(), "");
  b.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 1}};
  EXPECT_ERROR(b.error(), "nowhere.png");
  b.json["images"][1] = {{"uri", "data:image/png;base64,AAAA"}, {"name", "pores"}};
  EXPECT_ERROR(b.error(), "image 'pores'");
}

TEST(GltfUris, WhatIsReadAndWhatIsRefused) {
  const TempFolder folder;
  const auto error = [&](const std::string& uri) {
    Builder b;
    b.triangle();
    b.json["buffers"][0]["uri"] = uri;
    write_text(folder.path() / "a b%.bin", b.bytes);
    write_text(folder.path() / "plain.bin", b.bytes);
    fs::create_directories(folder.path() / "sub");
    write_text(folder.path() / "sub" / "built.gltf", b.json.dump());
    return error_of(folder.path() / "sub" / "built.gltf");
  };

  EXPECT_EQ(error("../plain.bin"), "");
  EXPECT_EQ(error("../a%20b%25.bin"), "");
  EXPECT_EQ(error("../a b%.bin"), "");  // not escaped, but there

  EXPECT_ERROR(error((folder.path() / "plain.bin").string()), "absolute path");
  EXPECT_ERROR(error("%2Fetc%2Fhostname"), "absolute path");
  EXPECT_ERROR(error("file:///etc/hostname"), "not a relative uri");
  EXPECT_ERROR(error("C:\\x.bin"), "not a relative uri");
  EXPECT_ERROR(error("http://example.com/x.bin"), "not a relative uri");

  EXPECT_ERROR(error("no.bin"), "no such file");
  EXPECT_ERROR(error(".."), "is a directory");
  EXPECT_ERROR(error(""), "the uri is empty");

  EXPECT_ERROR(error("data:application/octet-stream;base64,AAAA"), "cut off");
  EXPECT_ERROR(error("data:application/octet-stream;base64,A*AA"), "not valid base64");
  EXPECT_ERROR(error("data:application/octet-stream,AAAA"), "base64");
}

}  // namespace dermis::scene::test
