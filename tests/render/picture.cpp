// Pictures: files, tone maps, difference measures, labels, and textures with the limits of their size.
#include "render/picture/picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/parallel.h"
#include "io/files/temporary.h"
#include "io/samples/degrees.h"
#include "render/compare/arrange.h"
#include "render/compare/measured.h"
#include "render/job.h"
#include "render/picture/canvas.h"
#include "render/proof/parity.h"
#include "render/scene/prepared.h"
#include "render/scene/texture.h"

namespace brdf::render {
namespace {

std::filesystem::path temporary(const char* name) {
  static const io::TemporaryFolder folder;
  return folder.path() / name;
}

TEST(Picture, ExrLayersReadBackExactly) {
  Picture first(5, 3), second(5, 3);
  for (std::size_t k = 0; k < first.pixels.size(); ++k) {
    first.pixels[k] = glm::vec4(float(k) / 7, 1e-20f, 1e20f, 1);
    second.pixels[k] = glm::vec4(-float(k), 0.5f, 3, 0);
  }
  const auto file = temporary("layers.exr");
  write_exr(file, {{"", &first, true}, {"reference", &second}});
  EXPECT_EQ(read_exr(file, "").pixels, first.pixels);
  EXPECT_EQ(read_exr(file, "reference").at(4, 2), glm::vec4(-14, 0.5f, 3, 0));
  EXPECT_THROW(read_exr(file, "absent"), InputError);
}

TEST(Picture, AFullDeviceIsTheEnvironmentsFault) {
  const Picture picture(4, 4);
  const auto file = temporary("full.exr");
  std::filesystem::create_symlink("/dev/full", file);
  EXPECT_THROW(write_exr(file, {{"", &picture, true}}), EnvironmentError);
}

TEST(Picture, PngReadsBackToTheSameBytes) {
  BytePicture picture(4, 2);
  for (std::size_t k = 0; k < picture.pixels.size(); ++k)
    picture.pixels[k] = {std::uint8_t(k), 255, std::uint8_t(200 - k)};
  const auto file = temporary("bytes.png");
  write_png(file, picture);
  const Texture back = load_texture(file);
  ASSERT_EQ(back.width, 4);
  for (std::size_t k = 0; k < picture.pixels.size(); ++k) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(back.texels[k][c], picture.pixels[k][c]);
  }
}

TEST(Picture, ToneMapsAreTheOnesTheyAreNamedAfter) {
  const glm::vec3 c(0.25f, 1, 4);
  EXPECT_EQ(tone_mapped(c, ToneMap::none, 0), glm::vec3(0.25f, 1, 1));
  EXPECT_EQ(tone_mapped(c, ToneMap::none, 1), glm::vec3(0.5f, 1, 1));
  EXPECT_NEAR(tone_mapped(c, ToneMap::srgb, 0).r, 0.537099, 1e-5);
  EXPECT_NEAR(tone_mapped(c, ToneMap::reinhard, 0).g, 0.735357, 1e-5);  // sRGB of 1/2
  EXPECT_NEAR(tone_mapped(c, ToneMap::thesis, 0).b, std::pow(0.8, 1 / 2.2), 1e-6);
}

TEST(Picture, MeasuresKnowCoverageAndScale) {
  Picture a(2, 2), b(2, 2);
  for (std::size_t k = 0; k < 4; ++k) a.pixels[k] = b.pixels[k] = glm::vec4(0.5f, 0.5f, 0.5f, 1);
  EXPECT_EQ(compare(a, b).rel_mse, 0);
  EXPECT_TRUE(std::isinf(compare(a, b).psnr));
  a.pixels[0] = glm::vec4(0);
  EXPECT_EQ(compare(a, b).coverage_mismatch, 0.25);
  EXPECT_EQ(compare(a, b).rel_mse, 0);  // of the pixels that both pictures cover
  a.pixels[1].r = 0.6f;
  EXPECT_NEAR(compare(a, b).rel_mse, 0.01 / 0.26 / 9, 1e-8);
}

TEST(Picture, WhatWasNotMeasuredIsHatchedAndLeftOut) {
  Picture a(16, 1), b(16, 1);
  for (std::size_t k = 0; k < 16; ++k) {
    a.pixels[k] = glm::vec4(0.5f, 0.5f, 0.5f, 1);
    b.pixels[k] = glm::vec4(0.5f, 0.4f, 0.5f, k < 12 ? 1 : kNotMeasured);
  }
  b.pixels[15] = glm::vec4(9, 9, 9, kNotMeasured);
  const Difference d = compare(a, b);
  EXPECT_NEAR(d.rel_mse, 0.01 / 0.17 / 3, 1e-8);
  EXPECT_EQ(d.coverage_mismatch, 0);
  EXPECT_EQ(d.not_measured, 0.25);
  const BytePicture shown = displayed(b, ToneMap::srgb, 0),
                    signs = difference_picture(a, b, Scale::plus_minus);
  for (std::size_t k = 12; k < 16; ++k) {
    EXPECT_EQ(shown.pixels[k], signs.pixels[k]) << k;  // grey stripes for any value
    EXPECT_EQ(shown.pixels[k][0], shown.pixels[k][2]);
  }
  EXPECT_NE(shown.pixels[11], shown.pixels[12]);
  // 25 % brighter is half way from white to red.
  EXPECT_GT(signs.pixels[0][0], signs.pixels[0][2]);
  std::swap(a, b);
  for (glm::vec4& pixel : b.pixels) pixel.a = 1;
  const BytePicture darker = difference_picture(a, b, Scale::plus_minus);
  EXPECT_LT(darker.pixels[0][0], darker.pixels[0][2]);
}

TEST(Picture, LabelsKeepTheirPlace) {
  const std::string name = "A: \u00c4 very long name of a material that ends here";
  const float width = text_width(name, 12);
  EXPECT_EQ(elided(name, 12, width), name);
  for (const float share : {0.9f, 0.5f, 0.2f, 0.05f}) {
    const std::string shorter = elided(name, 12, share * width);
    EXPECT_LE(text_width(shorter, 12), share * width);
    EXPECT_NE(shorter.find("\u2026"), std::string::npos);
    EXPECT_TRUE(share < 0.4f || (shorter.starts_with("A: ") && shorter.ends_with("here"))) << shorter;
  }
  // Two labels next to each other in a small picture: neither crosses the dividing line.
  const Picture black(200, 120);
  Comparison c{.a = &black, .b = &black, .name_a = name, .name_b = name, .split = 0.3f};
  const BytePicture both = arranged(c, Display::split);
  for (int y = 0; y < 120; ++y) EXPECT_EQ(both.pixels[std::size_t(y * 200 + 60)][0], 255);
  c.name_b = "B";
  const BytePicture other = arranged(c, Display::split);
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 60; ++x)
      EXPECT_EQ(both.pixels[std::size_t(y * 200 + x)], other.pixels[std::size_t(y * 200 + x)]);
}

TEST(Picture, ThreadsWriteTextAtTheSameTime) {
  const auto written = [](int pixels) {
    BytePicture picture(160, 48);
    draw_text(picture, {4, 40}, "Light at 30\u00b0", pixels);
    return picture.pixels;
  };
  constexpr int kFirst = 9, kSizes = 8;
  std::vector<decltype(written(0))> alone;
  for (int k = 0; k < kSizes; ++k) alone.push_back(written(kFirst + k));
  std::vector<char> same(2000);
  io::parallel_for(
      same.size(),
      [&](std::size_t k) {
        const int size = int(k) % kSizes;
        same[k] = written(kFirst + size) == alone[std::size_t(size)];
      },
      4);
  EXPECT_EQ(std::count(same.begin(), same.end(), 0), 0);
}

TEST(Picture, RustyMetalIsSeededTileableAndPartlyRusty) {
  const auto maps = rusty_metal(64, 7), again = rusty_metal(64, 7), other = rusty_metal(64, 8);
  EXPECT_EQ(maps[0].texels, again[0].texels);
  EXPECT_NE(maps[0].texels, other[0].texels);
  std::size_t metal = 0;
  double across = 0, inside = 0;
  for (std::size_t y = 0; y < 64; ++y) {
    across += std::abs(maps[2].texels[y * 64][0] - maps[2].texels[y * 64 + 63][0]);
    inside += std::abs(maps[2].texels[y * 64 + 31][0] - maps[2].texels[y * 64 + 32][0]);
    for (std::size_t x = 0; x < 64; ++x) metal += maps[3].texels[y * 64 + x][0] > 127;
  }
  EXPECT_GT(metal, 64u * 64 / 10);
  EXPECT_LT(metal, 64u * 64 * 9 / 10);
  EXPECT_LT(across, 3 * inside + 64 * 4);  // no seam
}

// Writes an uncompressed TGA. Its rows are a hole in the file.
std::filesystem::path black_tga(int width, int height) {
  const auto file = temporary("black.tga");
  const char header[18] = {
      0,  0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, char(width), char(width >> 8), char(height), char(height >> 8),
      24, 0};
  std::ofstream(file, std::ios::binary).write(header, sizeof header);
  std::filesystem::resize_file(file, sizeof header + 3 * std::size_t(width) * std::size_t(height));
  return file;
}

TEST(Picture, MapsAreLimitedByTheirDecodedSize) {
  EXPECT_EQ(load_texture(black_tga(4096, 4096)).texels.size(), std::size_t(kMostTexels));
  EXPECT_THROW(load_texture(black_tga(0, 30)), InputError);
  try {
    load_texture(black_tga(4097, 4096));
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("black.tga: has 4097 x 4096 pixels; at most 16777216"),
              std::string::npos)
        << error.what();
  }
}

TEST(Picture, ABmpWithItsFirstRowOnTopIsLimitedToo) {
  const auto file = temporary("on_top.bmp");
  std::string header("BM\0\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0", 18);
  for (const std::int32_t size : {4097, -4096})
    for (int k = 0; k < 4; ++k) header += char(std::uint32_t(size) >> (8 * k));
  header += std::string("\1\0\x18\0", 4) + std::string(24, '\0');
  std::ofstream(file, std::ios::binary) << header;
  EXPECT_THROW(load_texture(file), InputError);
  header[18] = 1;  // 1 by 4096
  header[19] = 0;
  std::ofstream(file, std::ios::binary) << header << std::string(4 * 4096, '\0');
  EXPECT_EQ(load_texture(file).texels.size(), 4096u);
}

TEST(Picture, MapsThatEndTooSoonAreRefused) {
  const auto bytes_of = [](const std::filesystem::path& file) { return io::read_content(file).bytes; };
  std::string bmp("BM\0\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\x04\0\0\0\x03\0\0\0\1\0\x18\0", 30);
  bmp += std::string(24, '\0') + std::string(3 * 4 * 3, '\x7f');
  std::string runs = bytes_of(black_tga(4, 3)).substr(0, 18);  // run-length coded: one run of twelve pixels
  runs[2] = 10;
  runs += "\x8b\1\2\3";
  for (const auto& [name, whole] : {std::pair{"cut.png", png_of(BytePicture(13, 11))},
                                    {"cut.bmp", bmp},
                                    {"cut.tga", bytes_of(black_tga(40, 30))},
                                    {"cut_runs.tga", runs}}) {
    const auto file = temporary(name);
    std::ofstream(file, std::ios::binary) << whole;
    EXPECT_NO_THROW(load_texture(file)) << name;
    for (const std::size_t size : {whole.size() - 1, whole.size() - 2, whole.size() / 2 + 10}) {
      std::filesystem::resize_file(file, std::min(size, whole.size() - 1));
      EXPECT_THROW(load_texture(file), InputError) << name << " of " << size << " bytes";
    }
  }
}

TEST(Picture, MapsOfAllObjectsTogetherAreLimited) {
  Scene scene;
  scene.objects.resize(std::size_t(kMostTexelsOfAll) / std::size_t(kMostTexels) / 4);
  for (Object& object : scene.objects) {
    object.mesh = "plane";
    object.material = make_material(*find_form("lambert"));
    object.textures.fill(black_tga(4096, 4096));
  }
  EXPECT_NO_THROW(prepare(scene));
  scene.objects.push_back(scene.objects[0]);
  EXPECT_THROW(prepare(scene), InputError);
}

TEST(Picture, MissingTexturesAndOutputsAreNamed) {
  EXPECT_THROW(load_texture(temporary("absent.png")), InputError);
  std::ofstream(temporary("no.png")) << "no picture";
  EXPECT_THROW(load_texture(temporary("no.png")), InputError);
  Job job;
  job.output = "picture.tiff";
  EXPECT_THROW(run(job), InputError);
}

TEST(Picture, TheNamesOfChannelsDecideWhatIsRed) {
  Scene scene;
  scene.objects.resize(1);
  scene.objects[0].mesh = "plane";
  Material& material = scene.objects[0].material;
  material = make_material(*find_form("lambert"), {"465nm", "525nm", "630nm"});
  for (std::size_t c = 0; c < 3; ++c) material.terms[0].weights[c] = {0.2 + 0.1 * double(c)};
  const Item item = prepare(scene).layers[0][0];
  EXPECT_EQ(item.weights[0], (std::vector<float>{0.4f}));
  EXPECT_EQ(item.weights[2], (std::vector<float>{0.2f}));
  EXPECT_EQ(item.channels, (std::array<std::size_t, 3>{2, 1, 0}));

  io::SampleTable table;
  table.channels = material.channels;
  table.values = {{0.1}, {0.2}, {0.3}};
  table.add_directions(30, 180, 30, 0);
  const Vec3<double> i = io::unit_vector(30, 180), o = io::unit_vector(30, 0);
  const glm::vec3 wi(glm::dvec3(i.x, i.y, i.z)), wo(glm::dvec3(o.x, o.y, o.z));
  const glm::vec3 shown = interpolate(table)(wi, wo).f_cos / wi.z;
  EXPECT_NEAR(shown.r, 0.3f, 1e-5f);
  EXPECT_NEAR(shown.b, 0.1f, 1e-5f);
  ViewState state;
  state.scene = scene;
  ASSERT_EQ(colour_notes(state).size(), 1u);
  EXPECT_NE(colour_notes(state)[0].find("630nm, 525nm, 465nm"), std::string::npos);
}

TEST(Picture, ParityBoundsAreThePublishedOnes) {
  ParityRow row;
  row.gbuffer_bits = 32;
  row.difference.rel_mse = 2e-11;
  EXPECT_FALSE(passes(row));
  row.gbuffer_bits = 16;
  EXPECT_TRUE(passes(row));
  row.difference.coverage_mismatch = 2e-4;
  EXPECT_FALSE(passes(row));
}

}  // namespace
}  // namespace brdf::render
