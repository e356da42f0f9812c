// Tests that files, pipes and text are read once, within limits, and refused by name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <thread>

#include "io/files/content.h"
#include "io/files/temporary.h"
#include "io/files/text.h"
#include "io/formats/read.h"
#include "io/material/material_file.h"
#include "tests/io/reading.h"
#include "tests/io/tensor_bytes.h"
#include "tests/thorough.h"

namespace brdf::io {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(Pipes, AreReadOnceIntoMemoryInEveryFormat) {
  const io::TemporaryFolder folder;
  const std::filesystem::path pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string big = repeated(kRow, 20000);  // more than the buffer of a pipe holds
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
  const io::TemporaryFolder folder;
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

TEST(Limits, NamesOfColumnsAreShort) {
  EXPECT_EQ(message(repeated("ab/c_d[e]", 100) + ",f\n1,2\n"),
            "file, line 1: the name of column 1 has 900 bytes, which exceed the limit of 500");
  // Names below the limit are searched for units at each separator: a whole line of them is still read.
  EXPECT_NE(message(repeated("ab/c_d[e]", 55) + ",f\n1,2\n").find("column 'theta_i' is missing"),
            std::string::npos);
}

TEST(Limits, LinesRowsAndColumnsAreCounted) {
  BRDF_LONG_UNDER_SANITIZERS();
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
              HasSubstr("line 1: 4097 channels exceed the limit of 4096"));
  EXPECT_THAT(message("VARS theta_i,phi_i,theta_s,phi_s" + rows),
              HasSubstr("4097 channels exceed the limit of 4096"));
  const Material material =
      make_material(catalogue().front(), std::vector<std::string>(kMostChannels + 1, "c"));
  EXPECT_THAT(message_of([&] { check_material(material, "m.json"); }),
              HasSubstr("m.json: $.channels: 4097 channels exceed the limit of 4096"));
}

TEST(Limits, AzimuthsAreWithinAMillionDegrees) {
  const std::string rule = " must be between -1e6 and 1e6 degrees";
  EXPECT_EQ(message(kHeader + replaced(kRow, "180", "1e300")), "file, line 2: phi_i 1e+300" + rule);
  EXPECT_EQ(message(kHeader + replaced(kRow, "5,1", "-1000001,1")), "file, line 2: phi_o -1000001" + rule);
  EXPECT_EQ(message(kHeader + replaced(kRow, "180", "1e6")), "accepted");
  EXPECT_EQ(message(replaced(kAstm, "180", "1e308")), "file, line 2: phi_i 1e+308" + rule);
  // Radians: the limit of a million applies after the conversion to degrees. A value that overflows in the
  // conversion is refused as an angle, too.
  const std::string radians = "ANGLE_UNIT radians\n" + replaced(replaced(kAstm, "30", ".3"), "60", ".6");
  EXPECT_EQ(message(replaced(radians, "180", "17454")), "file, line 3: phi_i 1000040.5356213389" + rule);
  EXPECT_EQ(message(replaced(radians, "180", "1e308")), "file, line 3: phi_i inf" + rule);
  EXPECT_THAT(message(replaced(kLens, "Azimuth 1\n0", "Azimuth 1\n1e300")),
              HasSubstr("line 10: angle 1e+300" + rule));
  EXPECT_THAT(message(replaced(kLens, "Rotation 1\n0", "Rotation 1\n-1e9")),
              HasSubstr("line 6: angle -1e+09" + rule));
}

TEST(Encoding, TextThatIsNotUtf8IsTakenForLatin1AndSaidSo) {
  const SampleTable table =
      read("# Probe: gr\xfcn, 20 \xb0\x43\n" + replaced(kHeader, ",f", ",gr\xfcn") + kRow);
  EXPECT_THAT(table.channels, ElementsAre("gr\xc3\xbcn"));
  EXPECT_EQ(table.find_metadata("Probe"), "gr\xc3\xbcn, 20 \xc2\xb0\x43");
  EXPECT_THAT(table.warnings, ElementsAre("line 1 is not UTF-8: the text is read as Latin-1"));
  expect_same(read(written(table)), table);
  EXPECT_THAT(read("# gr\xc3\xbcn\n" + std::string(kHeader) + kRow).warnings, ElementsAre());
}

TEST(Encoding, WhatIsNoTextIsRefusedWithItsLine) {
  EXPECT_EQ(message(kHeader + std::string("# \x93quoted\x94\n") + kRow),
            "file, line 2: is neither UTF-8 nor Latin-1 text (save the file as UTF-8)");
  EXPECT_EQ(message(kHeader + std::string("1\0,2", 4)),
            "file, line 2: contains a NUL byte: neither text nor a supported binary format");
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
  EXPECT_THAT(json_message(nested(101)), HasSubstr("is nested more than 100 levels deep"));
  EXPECT_THAT(json_message(nested(1000000)), HasSubstr("is nested more than 100 levels deep"));
  EXPECT_THAT(json_message(repeated("{\"a\":", 101) + "1" + repeated("}", 101)), HasSubstr("$.a.a"));
}

TEST(JsonText, NamesThePlaceOfANumberBeyondTheRange) {
  EXPECT_EQ(json_message("{\"a\": [0, {\"b\": [1, 2, 1e400]}]}"),
            "m.json: $.a[1].b[2]: '1e400' exceeds the range of numbers");
  EXPECT_EQ(json_message("{\"a\": [1, {\"b\": [2, 3, {\"c\": 1, \"c\": 2}]}]}"),
            "m.json: $.a[1].b[2]: key \"c\" is given twice");
  EXPECT_EQ(json_message("-1e999"), "m.json: $: '-1e999' exceeds the range of numbers");
}

TEST(JsonText, HoldsNoNulByte) {
  EXPECT_EQ(json_message(std::string("{}\n\0garbage", 11)), "m.json, line 2: contains a NUL byte");
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

}  // namespace
}  // namespace brdf::io
