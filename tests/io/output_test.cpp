#include "io/output.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "io/error.h"
#include "io/provenance.h"
#include "tests/io/temporary_folder.h"

namespace brdf::io {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::ptrdiff_t entries(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

TEST(Output, ReplacesTheOldFileAndLeavesNoTemporary) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.txt";
  write_file_atomically(path, "old");
  write_file_atomically(path, "new");
  EXPECT_EQ(content(path), "new");
  EXPECT_EQ(entries(folder.path()), 1);
}

TEST(Output, KeepsTheOldFileWhenWritingThrows) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.txt";
  write_file_atomically(path, "old");
  const auto broken = [](std::ostream& out) {
    out << "half";
    throw std::runtime_error("broken");
  };
  EXPECT_THROW(write_file_atomically(path, broken), std::runtime_error);
  EXPECT_EQ(content(path), "old");
  EXPECT_EQ(entries(folder.path()), 1);
}

TEST(Output, FollowsLinks) {
  const TemporaryFolder folder;
  fs::create_symlink(folder.path() / "real.txt", folder.path() / "link.txt");
  write_file_atomically(folder.path() / "link.txt", "x");
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link.txt"));
  EXPECT_EQ(content(folder.path() / "real.txt"), "x");
}

TEST(Output, AMissingFolderIsBadInputAndAFullDeviceAnEnvironmentError) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_file_atomically(folder.path() / "no" / "a.txt", "x"), InputError);
  EXPECT_THROW(write_file_atomically("/dev/full", "x"), EnvironmentError);
  EXPECT_FALSE(fs::is_regular_file("/dev/full"));
}

TEST(Provenance, HoldsTheOptionsButNotTheOutputPath) {
  const char* const argv[] = {"/usr/bin/brdf", "synth", "--set", "a=1", "-o", "x.csv", "it's"};
  record_command_line(7, argv);
  const auto fields = provenance_fields(provenance(3));
  ASSERT_EQ(fields.size(), 3u);
  EXPECT_EQ(fields[0].second, BRDF_VERSION);
  EXPECT_EQ(fields[1].second, "brdf synth --set a=1 'it'\\''s'");
  EXPECT_EQ(fields[2].second, "3");
}

}  // namespace
}  // namespace brdf::io
