// Tests the folders of a study: their names, and when their content can be reused.
#include "study/folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "io/files/content.h"
#include "io/files/temporary.h"

namespace brdf::study {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

TEST(FolderNames, AreTheFilesWithoutSuffixAndNeverTheSame) {
  EXPECT_THAT(folder_names({"a/copper.csv", "b/brass.bsdf"}), ElementsAre("copper", "brass"));
  EXPECT_THAT(folder_names({"a/copper.csv", "b/copper.csv", "copper.bsdf", "c/copper.csv"}),
              ElementsAre("copper", "copper.csv", "copper.bsdf", "copper.csv-2"));
  EXPECT_THAT(folder_names({"index.html.csv", "study.json"}), ElementsAre("index.html.csv", "study"));
  EXPECT_THAT(folder_names({"..csv", "in/...csv"}),
              ElementsAre("..csv", "...csv"));  // neither this folder nor the one above
  EXPECT_THAT(folder_names({"study.json.csv", "study.json.csv"}),
              ElementsAre("study.json.csv", "study.json.csv-2"));
}

class Published : public testing::Test {
 protected:
  void write(std::initializer_list<const char*> names, const std::string& key) {
    std::vector<File> files;
    for (const char* name : names) files.push_back({name, std::string("content of ") + name});
    publish(folder_, files, {{"results", {1, 2}}}, key);
  }
  void edit(const char* what, const io::Json& value) {
    io::Json results = io::Json::parse(io::read_content(folder_ / kResults).bytes);
    results[what] = value;
    std::ofstream(folder_ / kResults) << results;
  }
  io::TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path() / "new" / "sample";
};

TEST_F(Published, IsKeptWhereNothingHasChanged) {
  write({"a.json", "index.html"}, "key");
  const auto results = kept(folder_, "key");
  ASSERT_TRUE(results);
  EXPECT_EQ(results->at("results"), io::Json({1, 2}));
  EXPECT_EQ(io::read_content(folder_ / "a.json").bytes, "content of a.json");
  EXPECT_FALSE(kept(folder_, "another key"));
}

TEST_F(Published, IsNotKeptWhereAFileIsMissingOrOther) {
  write({"a.json", "index.html"}, "key");
  std::ofstream(folder_ / "a.json") << "content of b.json";
  EXPECT_FALSE(kept(folder_, "key"));
  write({"a.json", "index.html"}, "key");
  EXPECT_TRUE(kept(folder_, "key"));
  fs::remove(folder_ / "index.html");
  EXPECT_FALSE(kept(folder_, "key"));
}

TEST_F(Published, IsNotKeptWithoutItsLastFile) {
  write({"a.json"}, "key");
  fs::remove(folder_ / kResults);  // killed before it was written
  EXPECT_FALSE(kept(folder_, "key"));
}

TEST_F(Published, RemovesWhatItWroteEarlierAndNothingElse) {
  write({"old.png", "index.html"}, "key");
  std::ofstream(folder_ / "notes.txt") << "the user's";
  write({"index.html"}, "key 2");
  EXPECT_FALSE(fs::exists(folder_ / "old.png"));
  EXPECT_TRUE(fs::exists(folder_ / "notes.txt"));
  EXPECT_TRUE(kept(folder_, "key 2"));
}

TEST_F(Published, TrustsNoForeignDocument) {
  std::ofstream(temporary_.path() / "precious") << "kept";
  for (const char* text : {"{", "[]", R"({"files": 3, "key": "key"})"}) {
    fs::create_directories(folder_);
    std::ofstream(folder_ / kResults) << text;
    EXPECT_FALSE(kept(folder_, "key")) << text;
    write({"a.json"}, "key");
    EXPECT_TRUE(kept(folder_, "key")) << text;
  }
  for (const char* files : {"3", R"({"../precious": "x"})", R"({"": "x"})"}) {
    edit("files", io::Json::parse(files));
    EXPECT_FALSE(kept(folder_, "key")) << files;
    write({"a.json"}, "key");
  }
  edit("results", {"a row of somebody's own"});
  EXPECT_FALSE(kept(folder_, "key"));
  std::ofstream(folder_ / kResults) << R"({"files": {"../../precious": "x"}})";
  write({"a.json"}, "key");
  EXPECT_TRUE(fs::exists(temporary_.path() / "precious"));
}

}  // namespace
}  // namespace brdf::study
