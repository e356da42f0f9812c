// A table that was read can be written and read back, whatever its format. A table that could not be
// written is refused on reading.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "io/files/temporary.h"
#include "io/formats/exr_table.h"
#include "io/formats/merl.h"
#include "io/material/material_file.h"
#include "tests/io/reading.h"
#include "tests/io/tensor_bytes.h"

namespace brdf::io {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

TEST(Values, ThatTheCosineMakesInfiniteAreRefused) {
  EXPECT_EQ(message("# quantity: f_r*cos_o\n" + std::string(kHeader) + "30,180,89.99999999999999,0,1e300\n"),
            "file, line 3: 1e+300 divided by the cosine 2.4802620430283604e-16 exceeds the range of numbers");
}

// Names that could not be read back from a header row.
TEST(ChannelNames, AreOneRuleInEveryReaderAndTheWriter) {
  const std::vector<std::pair<std::string, std::string>> bad = {
      {"", "must not be empty"},
      {"theta_i", "must not be an angle's name"},
      {"phi_o", "must not be an angle's name"},
      {"12", "must not be a number"},
      {"inf", "must not be a number"},
      {"sigma_Y", "must not begin with sigma_"},
      {"a,b", "must not contain a comma"},
      {"a\nb", "must not contain control characters"},
      {"\x1b[31m", "must not contain control characters"},
      {"\xc2\x9b"
       "1m",
       "must not contain control characters"},
      {" a", "must not begin or end with a blank"},
      {"\xff", "must be UTF-8"},
      {repeated("x", 201), "must have at most 200 bytes"},
  };
  SampleTable table = read(std::string(kHeader) + kRow);
  for (const auto& [name, rule] : bad) {
    table.channels = {name};
    EXPECT_THAT(message_of([&] { written(table); }), AllOf(HasSubstr("file: channel"), HasSubstr(rule)))
        << name;
    const Material material = make_material(catalogue().front(), {name});
    if (name == "\xff") continue;  // cannot be written in JSON
    EXPECT_THAT(message_of([&] { check_material(material, "m"); }), HasSubstr("m: $.channels: channel"))
        << name;
    if (name.find_first_of(",\n") != name.npos || name == " a") continue;  // cannot be written in one field
    EXPECT_NE(message(replaced(kAstm, "Y", name)), "accepted") << name;
    EXPECT_NE(message(replaced(kHeader, ",f\n", "," + name + "\n") + kRow), "accepted") << name;
  }
  EXPECT_THAT(message(replaced(replaced(kAstm, "Y", "Y,Y"), "5,1", "5,1,2")),
              HasSubstr("channel 'Y' is named twice"));
  table.channels = {"f", "f"};
  EXPECT_THAT(message_of([&] { written(table); }), HasSubstr("channel 'f' is named twice"));
  table.channels = {"gr\xc3\xbcn 520 nm; #2"};
  expect_same(read(written(table)), table);
}

TEST(Writing, RefusesWhatCouldNotBeReadBack) {
  SampleTable table = read(replaced(kHeader, ",f", ",f,sigma_f") + replaced(kRow, "5,1", "5,1,.5"));
  table.values[0][0] = std::nan("");
  EXPECT_EQ(message_of([&] { written(table); }), "file, line 2: f nan must be finite");
  table.values[0][0] = 1;
  table.sigma[0][0] = 0;
  EXPECT_EQ(message_of([&] { written(table); }), "file, line 2: sigma_f 0 must be above 0 and finite");
  table.sigma[0][0] = 1;
  table.metadata = {{"long", repeated("x", kLongestLine)}};
  EXPECT_THAT(message_of([&] { written(table); }), HasSubstr("is longer than 16 MiB"));
  EXPECT_THAT(message_of([&] { merl::write("never.binary", SampleTable{}); }), HasSubstr("the table has 0"));
}

TEST(Comments, ThatNameTheQuantityNeverChangeValues) {
  const std::string csv = "# : quantity: f_r*cos_o\n" + std::string(kHeader) + kRow;
  const std::string astm = "quantity f_r*cos_o\n" + std::string(kAstm);
  const std::string colon = "quantity: f_r*cos_o\n" + std::string(kAstm);
  const std::string lens = "# quantity: f_r*cos_o\n" + std::string(kLens);
  TensorBytes tensor;
  tensor.field("description") = {"description", 1, {24}, "x\nquantity: f_r*cos_o\n# y"};
  for (const std::string& bytes : {csv, astm, colon, lens, tensor.bytes()}) {
    const SampleTable first = read(bytes);
    const std::string once = written(first);
    EXPECT_THAT(once, HasSubstr("# quantity: f_r\n"));
    const SampleTable second = read(once);
    expect_same(second, first);
    EXPECT_EQ(written(second), once);
  }
  // For a table that was made in memory, the written file must be as safe.
  SampleTable table = read(std::string(kHeader) + kRow);
  table.metadata = {{"quantity", "f_r*cos_i"}, {"quantity ", "f_r*cos_i"},  {"quantity:f_r", "x"},
                    {"a\nquantity", "b"},      {"", "quantity: f_r*cos_o"}, {"", "x\nquantity: f_r*cos_o"}};
  EXPECT_EQ(read(written(table)).values, table.values);
}

TEST(Comments, WithAColonStayFreeText) {
  const SampleTable table = read("# : see: there\n#\n# x\xc2\x9b\x1b[1m\n# plain\n# a: b: c\n# :: d\n" +
                                 std::string(kHeader) + kRow);
  EXPECT_THAT(table.metadata, ElementsAre(Pair("", "see: there"), Pair("", ""), Pair("", "x  [1m"),
                                          Pair("", "plain"), Pair("a", "b: c"), Pair("", ": d")));
  expect_same(read(written(table)), table);
}

TEST(Tensor, ArraysBeyondTheFilesEndAreRefused) {
  EXPECT_EQ(message(TensorBytes().bytes()), "accepted");
  const std::string whole = TensorBytes().bytes();
  EXPECT_THAT(message(whole.substr(0, whole.size() - 1)),
              HasSubstr("field 'rgb' extends beyond the end of the file"));
  // Products of the shape wrap around 64 bits: to 0, and to something small.
  for (const std::uint64_t size : {std::uint64_t{1} << 32, (std::uint64_t{1} << 32) + 1}) {
    TensorBytes tensor;
    tensor.field("ndf").shape = {size, size};
    EXPECT_THAT(message(tensor.bytes()), HasSubstr("field 'ndf' extends beyond the end of the file"));
  }
  TensorBytes unknown;
  unknown.field("sigma").type = 77;
  EXPECT_THAT(message(unknown.bytes()), HasSubstr("field 'sigma' is of the unknown type 77"));
}

TEST(Tensor, NumbersThatAreNoneAreRefused) {
  for (const char* name : {"theta_i", "ndf", "sigma", "vndf", "rgb"})
    for (const float bad : {std::nanf(""), INFINITY}) {
      TensorBytes tensor;
      std::string& data = tensor.field(name).data;
      data.replace(data.size() - 4, 4, TensorBytes::floats({bad}));
      EXPECT_THAT(message(tensor.bytes()),
                  HasSubstr(std::string("field \"") + name + "\" holds a value that is not"));
    }
  TensorBytes equal;
  equal.field("theta_i").data = TensorBytes::floats({0.5f, 0.5f});
  EXPECT_THAT(message(equal.bytes()), HasSubstr("the sizes of the fields are inconsistent"));
}

// Found by fuzzing: an array without values was copied from and to a null pointer.
TEST(Tensor, ArraysOfNoValuesAreRefused) {
  TensorBytes tensor;
  tensor.field("theta_i").shape = {0};
  tensor.field("theta_i").data.clear();
  EXPECT_THAT(message(tensor.bytes()), HasSubstr("the sizes of the fields are inconsistent"));
}

TEST(Tensor, DirectionsWithoutAValueAreLeftOutAndCounted) {
  TensorBytes tensor;
  tensor.field("vndf").data = TensorBytes::floats(std::vector<float>(8, 0));
  EXPECT_THAT(message(tensor.bytes()), HasSubstr("holds no finite value"));
  tensor.field("vndf").data = TensorBytes::floats({1, 2, 3, 4, 0, 0, 0, 0});
  const SampleTable table = read(tensor.bytes());
  EXPECT_GT(table.rows(), 0u);
  EXPECT_GT(table.skipped, 0u);
  EXPECT_THAT(table.warnings.back(), HasSubstr("directions left out, because the value is undefined"));
  expect_same(read(written(table)), table);
}

TEST(Merl, DamagedFilesAreRefusedAsWhatTheyAre) {
  const std::int32_t cells[3] = {90, 90, 180}, other[3] = {90, 90, 360};
  const auto header = [](const std::int32_t* n) { return std::string(reinterpret_cast<const char*>(n), 12); };
  const std::string whole = header(cells) + std::string(3 * merl::kCells * sizeof(double), '\0');
  EXPECT_EQ(message(whole), "accepted");
  EXPECT_THAT(
      message(whole.substr(0, whole.size() - 1)),
      HasSubstr("file: the MERL file has 34992011 bytes, but 90 x 90 x 180 x 3 cells require 34992012"));
  EXPECT_THAT(message(whole + "x"), HasSubstr("the MERL file has 34992013 bytes, but"));
  EXPECT_THAT(message(header(cells)), HasSubstr("the MERL file has 12 bytes, but"));
  EXPECT_THAT(message(header(other) + whole),
              HasSubstr("the MERL file has 90 x 90 x 360 cells, not 90 x 90 x 180"));
  EXPECT_THAT(message(header(cells).substr(0, 11)), HasSubstr("contains a NUL byte"));
}

TEST(Merl, ValuesTooLargeForItsScaleAreRefused) {
  const io::TemporaryFolder folder;
  const SampleTable table = read(replaced(kHeader, ",f", ",r,g,b") + replaced(kRow, "5,1", "5,1,1,1e306"));
  EXPECT_THAT(message_of([&] { merl::write(folder.path() / "m.binary", table); }),
              HasSubstr("outside the range of a MERL file"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "m.binary"));
}

TEST(ExrTable, CommentsNamedAsOpenExrsOwnKeepAPrefix) {
  const io::TemporaryFolder folder;
  SampleTable table = read(kHeader + replaced(kRow, ",1\n", ",1e300\n"));
  table.metadata = {{"type", "deepscanline"}, {"tiles", "x"}, {"channels", "y"}, {"sample", "z"}};
  const std::vector<std::string> lost = write_exr_table(folder.path() / "t.exr", table);
  EXPECT_THAT(lost, testing::Contains("1 numbers above 3.4e38, which become infinite in 32-bit float"));
  std::ifstream in(folder.path() / "t.exr", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  for (const char* name : {"comment.type", "comment.tiles", "comment.channels", "sample"})
    EXPECT_THAT(bytes, HasSubstr(std::string(name) + '\0' + "string")) << name;
}

// A write error of the device is not a fault of the input, whichever format is written.
TEST(ExrTable, AFullDeviceIsTheEnvironmentsFault) {
  const io::TemporaryFolder folder;
  std::filesystem::create_symlink("/dev/full", folder.path() / "t.exr");
  EXPECT_THROW(write_exr_table(folder.path() / "t.exr", read(kHeader + std::string(kRow))), EnvironmentError);
}

TEST(TableRules, CommentsAreLimited) {
  constexpr std::size_t kMost = 100'000;
  const std::string table = std::string(kHeader) + kRow;
  EXPECT_EQ(read(repeated("#\n", kMost) + table).metadata.size(), kMost);
  EXPECT_THAT(message(repeated("#\n", kMost + 1) + table),
              testing::HasSubstr("has more than 100000 comments"));
}

}  // namespace
}  // namespace brdf::io
