// What is read is read once, within limits, and can be written and read back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <thread>

#include "io/error.h"
#include "io/exr_table.h"
#include "io/material_json.h"
#include "io/merl.h"
#include "io/samples.h"
#include "io/table_rules.h"
#include "io/text.h"
#include "tests/io/temporary_folder.h"
#include "tests/io/tensor_bytes.h"

namespace brdf::io {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::Pair;

constexpr const char* kHeader = "theta_i,phi_i,theta_o,phi_o,f\n";
constexpr const char* kRow = "30,180,60,5,1\n";
constexpr const char* kAstm = "VARS theta_i,phi_i,theta_s,phi_s,Y\n30,180,60,5,1\n";
constexpr const char* kLens =
    "Source Measured\nSymmetry PlaneSymmetrical\nSpectralContent Monochrome\nScatterType BRDF\n"
    "SampleRotation 1\n0\nAngleOfIncidence 1\n30\nScatterAzimuth 1\n0\nScatterRadial 2\n0 10\nMonochrome\n"
    "DataBegin\nTIS 0.5\n1 2\nDataEnd\n";

std::string repeated(const std::string& text, std::size_t count) {
  std::string all;
  for (std::size_t k = 0; k < count; ++k) all += text;
  return all;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

SampleTable read(const std::string& bytes) {
  return read_samples(Content{"file", bytes});
}

template <class Read>
std::string message_of(Read read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::string message(const std::string& bytes) {
  return message_of([&] { read(bytes); });
}

std::string json_message(const std::string& text) {
  return message_of([&] { parse_json(text, "m.json"); });
}

std::string written(const SampleTable& table) {
  std::ostringstream out;
  write_samples(out, table);
  return out.str();
}

void expect_same(const SampleTable& a, const SampleTable& b) {
  EXPECT_EQ(a.channels, b.channels);
  EXPECT_EQ(a.metadata, b.metadata);
  EXPECT_EQ(a.theta_i, b.theta_i);
  EXPECT_EQ(a.phi_i, b.phi_i);
  EXPECT_EQ(a.theta_o, b.theta_o);
  EXPECT_EQ(a.phi_o, b.phi_o);
  EXPECT_EQ(a.values, b.values);
  EXPECT_EQ(a.sigma, b.sigma);
}

TEST(Pipes, AreReadOnceIntoMemoryInEveryFormat) {
  const TemporaryFolder folder;
  const std::filesystem::path pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string big = repeated(kRow, 20000);  // more than a pipe holds
  for (const std::string& bytes :
       {kHeader + big, std::string(kAstm), std::string(kLens), TensorBytes().bytes()}) {
    std::thread writer([&] { std::ofstream(pipe, std::ios::binary) << bytes; });
    const SampleTable table = read_samples(pipe);
    writer.join();
    expect_same(table, read(bytes));
  }
}

TEST(Files, DevicesAndFoldersAreRefusedByName) {
  EXPECT_EQ(message_of([] { read_samples("/dev/zero"); }), "/dev/zero: is a device");
  EXPECT_EQ(message_of([] { read_directions("/dev/zero"); }), "/dev/zero: is a device");
  EXPECT_EQ(message_of([] { read_material("/dev/zero"); }), "/dev/zero: is a device");
  EXPECT_EQ(message_of([] { read_samples("/"); }), "/: is a folder");
}

TEST(Files, AreRefusedBeyondTheirLimitBeforeTheyAreRead) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "sparse", pipe = folder.path() / "pipe";
  std::ofstream(file) << "{";
  std::filesystem::resize_file(file, kLargestFile + 1);  // occupies a block
  EXPECT_THAT(message_of([&] { read_samples(file); }), HasSubstr("sparse: is larger than 1024 MiB"));
  std::filesystem::resize_file(file, kLargestJson + 1);
  EXPECT_THAT(message_of([&] { read_json(file); }), HasSubstr("sparse: is larger than 64 MiB"));
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << repeated("x", (1 << 20) + 1); });
  EXPECT_THAT(message_of([&] { read_content(pipe, 1 << 20); }), HasSubstr("pipe: is larger than 1 MiB"));
  writer.join();
}

TEST(Limits, LinesRowsAndColumnsAreCounted) {
  EXPECT_EQ(message("# " + repeated("x", kLongestLine) + "\n" + kHeader + kRow),
            "file, line 1: is longer than 16 MiB");
  EXPECT_EQ(message(kHeader + repeated("0,0,0,0,1\n", kMostRows + 1)),
            "file, line 4000002: more than 4000000 rows");
  std::string names, values;
  for (std::size_t k = 0; k <= kMostChannels; ++k) {
    names += ",c" + std::to_string(k);
    values += ",1";
  }
  const std::string rows = names + "\n1,2,3,4" + values + "\n";
  EXPECT_THAT(message("theta_i,phi_i,theta_o,phi_o" + rows),
              HasSubstr("line 1: 4097 channels are more than 4096"));
  EXPECT_THAT(message("VARS theta_i,phi_i,theta_s,phi_s" + rows),
              HasSubstr("VARS names 4101 columns, more than"));
  const Material material =
      make_material(catalogue().front(), std::vector<std::string>(kMostChannels + 1, "c"));
  EXPECT_THAT(message_of([&] { check_material(material, "m.json"); }),
              HasSubstr("m.json: $.channels: 4097 channels are more than 4096"));
}

TEST(Limits, AzimuthsAreWithinAMillionDegrees) {
  const std::string rule = " must be between -1e6 and 1e6 degrees";
  EXPECT_EQ(message(kHeader + replaced(kRow, "180", "1e300")), "file, line 2: phi_i 1e+300" + rule);
  EXPECT_EQ(message(kHeader + replaced(kRow, "5,1", "-1000001,1")), "file, line 2: phi_o -1000001" + rule);
  EXPECT_EQ(message(kHeader + replaced(kRow, "180", "1e6")), "accepted");
  EXPECT_EQ(message(replaced(kAstm, "180", "1e308")), "file, line 2: phi_i 1e+308" + rule);
  // Radians: the million counts after the conversion, and what overflows in it is no angle either.
  const std::string radians = replaced(replaced(kAstm, "30", ".3"), "60", ".6");
  EXPECT_EQ(message(replaced(radians, "180", "17454")), "file, line 2: phi_i 1000040.5356213389" + rule);
  EXPECT_EQ(message(replaced(radians, "180", "1e308")), "file, line 2: phi_i inf" + rule);
  EXPECT_THAT(message(replaced(kLens, "Azimuth 1\n0", "Azimuth 1\n1e300")),
              HasSubstr("line 10: angle 1e+300" + rule));
  EXPECT_THAT(message(replaced(kLens, "Rotation 1\n0", "Rotation 1\n-1e9")),
              HasSubstr("line 6: angle -1e+09" + rule));
}

TEST(Values, ThatTheCosineMakesInfiniteAreRefused) {
  EXPECT_EQ(
      message("# quantity: f_r*cos_o\n" + std::string(kHeader) + "30,180,89.99999999999999,0,1e300\n"),
      "file, line 3: 1e+300 divided by the cosine 2.4802620430283604e-16 is beyond the range of numbers");
}

// Names that a header row would not give back.
TEST(ChannelNames, AreOneRuleInEveryReaderAndTheWriter) {
  const std::vector<std::pair<std::string, std::string>> bad = {
      {"", "must not be empty"},
      {"theta_i", "must not be an angle's name"},
      {"phi_o", "must not be an angle's name"},
      {"12", "must not be a number"},
      {"inf", "must not be a number"},
      {"sigma_Y", "must not begin with sigma_"},
      {"a,b", "must not hold a comma"},
      {"a\nb", "must not hold control characters"},
      {"\x1b[31m", "must not hold control characters"},
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
    if (name == "\xff") continue;  // cannot be said in JSON
    EXPECT_THAT(message_of([&] { check_material(material, "m"); }), HasSubstr("m: $.channels: channel"))
        << name;
    if (name.find_first_of(",\n") != name.npos || name == " a") continue;  // cannot be said in one field
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
  // A table that was made in memory: the file is as safe.
  SampleTable table = read(std::string(kHeader) + kRow);
  table.metadata = {{"quantity", "f_r*cos_i"}, {"quantity ", "f_r*cos_i"},  {"quantity:f_r", "x"},
                    {"a\nquantity", "b"},      {"", "quantity: f_r*cos_o"}, {"", "x\nquantity: f_r*cos_o"}};
  EXPECT_EQ(read(written(table)).values, table.values);
}

TEST(Comments, WithAColonStayFreeText) {
  const SampleTable table =
      read("# : see: there\n#\n# plain\n# a: b: c\n# :: d\n" + std::string(kHeader) + kRow);
  EXPECT_THAT(table.metadata, ElementsAre(Pair("", "see: there"), Pair("", ""), Pair("", "plain"),
                                          Pair("a", "b: c"), Pair("", ": d")));
  expect_same(read(written(table)), table);
}

TEST(Encoding, TextThatIsNotUtf8IsTakenForLatin1AndSaidSo) {
  const SampleTable table =
      read("# Probe: gr\xfcn, 20 \xb0\x43\n" + replaced(kHeader, ",f", ",gr\xfcn") + kRow);
  EXPECT_THAT(table.channels, ElementsAre("gr\xc3\xbcn"));
  EXPECT_EQ(table.find_metadata("Probe"), "gr\xc3\xbcn, 20 \xc2\xb0\x43");
  EXPECT_THAT(table.warnings, ElementsAre("line 1 is not UTF-8: the text is taken for Latin-1"));
  expect_same(read(written(table)), table);
  EXPECT_THAT(read("# gr\xc3\xbcn\n" + std::string(kHeader) + kRow).warnings, ElementsAre());
}

TEST(Encoding, WhatIsNoTextIsRefusedWithItsLine) {
  EXPECT_EQ(message(kHeader + std::string("# \x93quoted\x94\n") + kRow),
            "file, line 2: is neither UTF-8 nor Latin-1 text (save the file as UTF-8)");
  EXPECT_EQ(message(kHeader + std::string("1\0,2", 4)),
            "file, line 2: holds a NUL byte: neither text nor a binary format that is read");
  EXPECT_THAT(json_message("{\"a\": \"gr\xfcn\"}"), HasSubstr("m.json: parse error at line 1"));
}

TEST(Encoding, ANameThatIsNotUtf8CostsALetterNotTheReport) {
  const Json json = {{"file", "gr\xfcn.csv"}, {"list", {1, "\xff"}}};
  EXPECT_THAT(to_text(json), HasSubstr("gr\xef\xbf\xbdn.csv"));
  EXPECT_THAT(to_line(json), HasSubstr("gr\xef\xbf\xbdn.csv"));
}

TEST(JsonText, IsNestedAHundredDeepAtMost) {
  const auto nested = [](std::size_t depth) { return repeated("[", depth) + repeated("]", depth); };
  EXPECT_EQ(json_message(nested(100)), "accepted");
  EXPECT_THAT(json_message(nested(101)), HasSubstr("m.json: $[0][0]"));
  EXPECT_THAT(json_message(nested(101)), HasSubstr("is nested more than 100 deep"));
  EXPECT_THAT(json_message(nested(1000000)), HasSubstr("is nested more than 100 deep"));
  EXPECT_THAT(json_message(repeated("{\"a\":", 101) + "1" + repeated("}", 101)), HasSubstr("$.a.a"));
}

TEST(JsonText, NamesThePlaceOfANumberBeyondTheRange) {
  EXPECT_EQ(json_message("{\"a\": [0, {\"b\": [1, 2, 1e400]}]}"),
            "m.json: $.a[1].b[2]: '1e400' is beyond the range of numbers");
  EXPECT_EQ(json_message("-1e999"), "m.json: $: '-1e999' is beyond the range of numbers");
}

TEST(JsonText, HoldsNoNulByte) {
  EXPECT_EQ(json_message(std::string("{}\n\0garbage", 11)), "m.json, line 2: holds a NUL byte");
}

TEST(Messages, CutLongTokensAndShowNoControlCharacters) {
  const std::string key = repeated("k", 1 << 20);
  for (const std::string& text :
       {"{\"" + key + "\": 1, \"" + key + "\": 2}", "{\"a\": " + key + "}", "\"" + key})
    EXPECT_LT(json_message(text).size(), 500u);
  const Json json = parse_json("{\"\\u001b[31m" + key + "\": 1}", "m.json");
  const std::string unknown = message_of([&] { JsonPlace(json, "m.json").allow_keys({"a"}); });
  EXPECT_THAT(unknown, AllOf(HasSubstr("\\x1b[31mkkk"), Not(HasSubstr("\x1b"))));
  EXPECT_LT(unknown.size(), 200u);
  EXPECT_THAT(message(kHeader + replaced(kRow, ",1\n", ",\x1b]0;x\x07" + key + "\n")),
              AllOf(HasSubstr("'\\x1b]0;x\\x07kkk"), HasSubstr("...' is not a number")));
  EXPECT_EQ(printable("gr\xc3\xbcn\tx"), "gr\xc3\xbcn\\x09x");
  EXPECT_EQ(printable("\xc2\x9b\x31m"), "\\xc2\\x9b1m");  // U+009B begins a terminal's commands
  EXPECT_EQ(printable("gr\xfcn"), "gr\\xfcn");
  EXPECT_EQ(printable("a\xc3\xbc", 2), "a...");
}

TEST(Tensor, ArraysBeyondTheFilesEndAreRefused) {
  EXPECT_EQ(message(TensorBytes().bytes()), "accepted");
  const std::string whole = TensorBytes().bytes();
  EXPECT_THAT(message(whole.substr(0, whole.size() - 1)),
              HasSubstr("field 'rgb' reaches beyond the file's end"));
  // Products of the shape that wrap around 64 bits: to 0, and to something small.
  for (const std::uint64_t size : {std::uint64_t{1} << 32, (std::uint64_t{1} << 32) + 1}) {
    TensorBytes tensor;
    tensor.field("ndf").shape = {size, size};
    EXPECT_THAT(message(tensor.bytes()), HasSubstr("field 'ndf' reaches beyond the file's end"));
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
  EXPECT_THAT(message(equal.bytes()), HasSubstr("sizes do not belong together"));
}

TEST(Tensor, DirectionsWithoutAValueAreLeftOutAndCounted) {
  TensorBytes tensor;
  tensor.field("vndf").data = TensorBytes::floats(std::vector<float>(8, 0));
  EXPECT_THAT(message(tensor.bytes()), HasSubstr("holds no finite value"));
  tensor.field("vndf").data = TensorBytes::floats({1, 2, 3, 4, 0, 0, 0, 0});
  const SampleTable table = read(tensor.bytes());
  EXPECT_GT(table.rows(), 0u);
  EXPECT_GT(table.skipped, 0u);
  EXPECT_THAT(table.warnings.back(), HasSubstr("directions left out: their value is undefined"));
  expect_same(read(written(table)), table);
}

TEST(Merl, DamagedFilesAreRefusedAsWhatTheyAre) {
  const std::int32_t cells[3] = {90, 90, 180}, other[3] = {90, 90, 360};
  const auto header = [](const std::int32_t* n) { return std::string(reinterpret_cast<const char*>(n), 12); };
  const std::string whole = header(cells) + std::string(3 * merl::kCells * sizeof(double), '\0');
  EXPECT_EQ(message(whole), "accepted");
  EXPECT_THAT(
      message(whole.substr(0, whole.size() - 1)),
      HasSubstr("file: the MERL file has 34992011 bytes where its 90 x 90 x 180 x 3 cells take 34992012"));
  EXPECT_THAT(message(whole + "x"), HasSubstr("the MERL file has 34992013 bytes where"));
  EXPECT_THAT(message(header(cells)), HasSubstr("the MERL file has 12 bytes where"));
  EXPECT_THAT(message(header(other) + whole),
              HasSubstr("the MERL file has 90 x 90 x 360 cells, not 90 x 90 x 180"));
  EXPECT_THAT(message(header(cells).substr(0, 11)), HasSubstr("holds a NUL byte"));
}

TEST(Merl, ValuesTooLargeForItsScaleAreRefused) {
  const TemporaryFolder folder;
  const SampleTable table = read(replaced(kHeader, ",f", ",r,g,b") + replaced(kRow, "5,1", "5,1,1,1e306"));
  EXPECT_THAT(message_of([&] { merl::write(folder.path() / "m.binary", table); }),
              HasSubstr("beyond what a MERL file can hold"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "m.binary"));
}

TEST(ExrTable, CommentsNamedAsOpenExrsOwnKeepAPrefix) {
  const TemporaryFolder folder;
  SampleTable table = read(kHeader + replaced(kRow, ",1\n", ",1e300\n"));
  table.metadata = {{"type", "deepscanline"}, {"tiles", "x"}, {"channels", "y"}, {"sample", "z"}};
  const std::vector<std::string> lost = write_exr_table(folder.path() / "t.exr", table);
  EXPECT_THAT(lost, testing::Contains("1 numbers beyond 3.4e38: infinite in a 32-bit float"));
  std::ifstream in(folder.path() / "t.exr", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  for (const char* name : {"comment.type", "comment.tiles", "comment.channels", "sample"})
    EXPECT_THAT(bytes, HasSubstr(std::string(name) + '\0' + "string")) << name;
}

}  // namespace
}  // namespace brdf::io
