// Tests studies of one or more samples: their pages, the overview, and the reuse of finished results.
#include "study/study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "io/csv/csv.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/temporary.h"
#include "io/formats/read.h"
#include "io/material/material_file.h"
#include "study/folder.h"
#include "study/overview.h"
#include "study/spheres.h"
#include "synth/instrument.h"

namespace brdf::study {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class StudyOfFiles : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "in");
    for (int k = 0; k < 3; ++k)
      files_.push_back(write_sample("s" + std::to_string(k) + ".csv", 0.1 + 0.05 * k));
    options_.folder = folder_ / "out";
    options_.sample.models = {{*find_form("ward")}};
    options_.settings = "settings";
    options_.jobs = 2;
    options_.sample.pictures = false;  // they take most of the time
  }

  std::string write_sample(const std::string& name, double width) {
    Material truth = make_material(*find_form("ward"), {"f"});
    truth.terms[0].shape[0] = {width, width};
    synth::Instrument instrument;
    instrument.grid.parts = {"hemisphere"};
    instrument.grid.step = 15;
    instrument.grid.theta_i = {10, 30, 60};
    instrument.noise = 0.02;
    const fs::path file = folder_ / "in" / name;
    fs::create_directories(file.parent_path());
    io::write_samples(file, synth::measure(truth, instrument));
    return file.string();
  }
  std::vector<Row> run() { return study(files_, options_); }
  std::size_t kept_of(const std::vector<Row>& rows) {
    return std::size_t(std::count_if(rows.begin(), rows.end(), [](const Row& row) { return row.kept; }));
  }
  std::string text(const fs::path& file) { return io::read_content(options_.folder / file).bytes; }

  const io::TemporaryFolder temporary_;
  const fs::path folder_ = temporary_.path();
  std::vector<std::string> files_;
  StudyOptions options_;
};

TEST_F(StudyOfFiles, KeepsWhatIsFinishedAndRedoesTheRest) {
  for (const Row& row : run()) {
    EXPECT_FALSE(row.kept);
    EXPECT_TRUE(row.usable());
  }
  const std::string page = text("s1/index.html"), overview = text("index.html"), results = text("study.json");
  fs::remove(options_.folder / "s1" / "study.json");  // as if killed before the second was finished
  const std::vector<Row> again = run();
  EXPECT_TRUE(again[0].kept);
  EXPECT_FALSE(again[1].kept);
  EXPECT_TRUE(again[2].kept);
  EXPECT_EQ(text("s1/index.html"), page);
  EXPECT_EQ(text("index.html"), overview);
  EXPECT_EQ(text("study.json"), results);
}

TEST_F(StudyOfFiles, RedoesInputsAndSettingsThatChanged) {
  run();
  std::ofstream(files_[2], std::ios::app) << "10,180,20,0,0.3\n";
  const std::vector<Row> rows = run();
  EXPECT_TRUE(rows[0].kept);
  EXPECT_FALSE(rows[2].kept);
  options_.settings = "others";
  EXPECT_EQ(kept_of(run()), 0u);
  EXPECT_EQ(kept_of(run()), 3u);
}

// The page has the order in which a reader asks, and rarely needed parts are folded.
TEST_F(StudyOfFiles, APageTellsItsStoryInAReadersOrder) {
  options_.sample.pictures = true;
  options_.sample.models.push_back({*find_form("lambert")});
  options_.sample.fit_words = " --form ward";
  run();
  const std::string page = text("s0/index.html");
  std::size_t last = 0;
  for (const char* part :
       {"<h1>s0.csv</h1>", "class=\"verdict", "href=\"../index.html\"",
        ">Measured and fitted in the plane of incidence<", ">Residuals of the fit<", ">Parameters<",
        ">Properties of the fitted material<", ">not applicable: ", ">Albedo, lobes and reciprocity<",
        ">All forms, best first<", ">The measurements<", ">Data check<", ">Files and commands<",
        "href=\"material.json\"", "href=\"material.glsl\"", "class=\"commands\"",
        " --form ward -o material.json\nbrdf validate material.json\n"}) {
    const std::size_t at = page.find(part, last);
    ASSERT_NE(at, std::string::npos) << part
                                     << (page.find(part) < last ? " stands too early" : " is missing");
    last = at;
  }
  const std::size_t sphere = page.find("<figure class=\"sphere ");  // with and without a renderer
  EXPECT_LT(sphere, page.find(">Parameters<"));
  EXPECT_THAT(page, Not(HasSubstr("No pictures: ")));
  const std::size_t lobes = page.find(">Lobes: fitted (surface) and measured (dots)<");
  EXPECT_EQ(lobes != std::string::npos, has_lobes());
  EXPECT_EQ(page.find("No lobes: ") == std::string::npos, has_lobes());
  EXPECT_LT(std::min(lobes, sphere), page.find(">Residuals of the fit<"));
  for (const char* outside : {"http://", "https://", "file://", "src=\"/"})
    EXPECT_THAT(page, Not(HasSubstr(outside))) << outside;
}

TEST_F(StudyOfFiles, TheOverviewLeadsToEveryPageAndSorts) {
  run();
  const std::string page = text("index.html");
  for (const char* part :
       {"<h1>Study of 3 samples</h1>", "3 of 3 samples have a usable fit", "class=\"sortable\"",
        "href=\"s0/index.html\"", "href=\"s1/index.html\"", "href=\"s2/index.html\""})
    EXPECT_THAT(page, HasSubstr(part));
  EXPECT_EQ(page.find("http"), std::string::npos);
}

TEST_F(StudyOfFiles, ABrokenFileIsARowWithItsReasonAndEndsNoOther) {
  std::ofstream(files_[1]) << "theta_i,phi_i,theta_o,phi_o,f\n10,0,20,x,0.1\n";
  const std::vector<Row> rows = run();
  EXPECT_TRUE(rows[0].usable());
  EXPECT_FALSE(rows[1].usable());
  EXPECT_EQ(rows[1].fault, Fault::input);
  EXPECT_TRUE(rows[2].usable());
  const io::Json results = io::read_json(options_.folder / "study.json")["results"];
  ASSERT_EQ(results.size(), 3u);
  EXPECT_TRUE(results[0]["error"].is_null());
  EXPECT_THAT(results[1]["error"].get<std::string>(), HasSubstr("line 2"));
  EXPECT_THAT(text("index.html"), HasSubstr("line 2: column 4 ("));
  EXPECT_THAT(text("index.html"), HasSubstr("2 of 3 samples have a usable fit"));
  EXPECT_FALSE(fs::exists(options_.folder / "s1"));
}

TEST_F(StudyOfFiles, NothingIsWrittenWhereNoSampleCanBeUsed) {
  for (const std::string& file : files_) std::ofstream(file) << "1,2\n";
  EXPECT_THROW(run(), InputError);
  options_.finished = [](const Row& row, std::size_t, std::size_t) { ADD_FAILURE() << row.file; };
  EXPECT_THROW(run(), InputError);
  files_.resize(1);
  EXPECT_THROW(run(), InputError);
  EXPECT_FALSE(fs::exists(options_.folder));
}

// The rows arrive in the order of the samples while later samples are still waiting, also after a row without
// a study.
TEST_F(StudyOfFiles, ARowIsHandedOverAsSoonAsItIsFinished) {
  std::ofstream(files_[0]) << "1,2\n";
  options_.jobs = 1;
  std::size_t calls = 0;
  options_.finished = [&](const Row& row, std::size_t k, std::size_t rows) {
    EXPECT_EQ(k, calls++);
    EXPECT_EQ(rows, 3u);
    EXPECT_EQ(row.file, files_[k]);
    EXPECT_EQ(row.fault, k == 0 ? Fault::input : Fault::none);
    EXPECT_EQ(fs::exists(options_.folder / "s1" / kResults), true);
    EXPECT_EQ(fs::exists(options_.folder / "s2" / kResults), k == 2);
  };
  run();
  EXPECT_EQ(calls, 3u);
}

// Checks of many earlier results do not delay the first new result, and studies do not delay the checks.
TEST_F(StudyOfFiles, ASampleWithoutResultsIsStudiedBeforeOthersAreChecked) {
  run();
  for (const char* name : {"s1", "s2"}) fs::remove_all(options_.folder / name);
  options_.jobs = 1;
  std::size_t calls = 0;
  options_.finished = [&](const Row& row, std::size_t k, std::size_t) {
    ++calls;
    EXPECT_EQ(row.kept, k == 0);
    EXPECT_TRUE(fs::exists(options_.folder / "s1" / kResults)) << k;
    EXPECT_EQ(fs::exists(options_.folder / "s2" / kResults), k == 2);
  };
  run();
  EXPECT_EQ(calls, 3u);
}

TEST_F(StudyOfFiles, PicturesThatWereLeftOutAreDrawnOnceTheyAreWanted) {
  files_.resize(1);
  EXPECT_EQ(run()[0].json["no_pictures"], "disabled by --no-pictures");
  EXPECT_FALSE(fs::exists(options_.folder / "fitted.png"));
  EXPECT_THAT(text("index.html"), HasSubstr("No pictures: disabled by --no-pictures."));
  options_.sample.pictures = true;
  EXPECT_EQ(kept_of(run()), 0u);
  EXPECT_TRUE(fs::exists(options_.folder / "fitted.png"));
}

// The picture files are drawn like the pictures of the page, from the material that is stored next to them.
TEST_F(StudyOfFiles, PictureFilesAreThePagesPictures) {
  files_.resize(1);
  options_.sample.pictures = true;
  run();
  const auto pairs = io::sphere::fitted_pairs(io::read_material(options_.folder / kMaterial));
  const double exposure = io::sphere::exposure_of(pairs);
  EXPECT_EQ(text(kFitted), io::sphere::still_pictures(pairs, {}, exposure, 360).fitted);
  EXPECT_NE(text(kMeasured), text(kFitted));
  const Material material = io::read_material(options_.folder / kMaterial);
  EXPECT_EQ(text(kStudio),
            io::sphere::studio_pictures(material, io::sphere::studio_exposure(material), 224).whole);
  EXPECT_NE(text(kDifference), text(kMeasured));
}

// Each passed property that can be proved says how it is known, on the page and in the file. The largest
// albedo of a material is searched in a grid of directions, so that its sentence must not say "proved".
TEST_F(StudyOfFiles, PropertiesSayWhetherTheyAreProved) {
  files_.resize(1);
  run();
  std::map<std::string, std::string> known;
  const io::Json properties = io::Json::parse(text("properties.json"));
  for (const io::Json& f : properties["findings"])
    if (f.contains("proof")) known[f["check"]] = f["proof"];
  EXPECT_EQ(known, (std::map<std::string, std::string>{{"energy", "sampled"},
                                                       {"finite", "proved"},
                                                       {"non_negative", "proved"},
                                                       {"reciprocity", "proved"}}));
  EXPECT_THAT(text("index.html"), AllOf(HasSubstr("every value is finite; proved"), HasSubstr("; sampled")));
  EXPECT_THAT(text("index.html"), Not(HasSubstr("at the pairs tried; proved")));
}

TEST_F(StudyOfFiles, OneSampleIsThePageItself) {
  files_.resize(1);
  const std::vector<Row> rows = run();
  EXPECT_EQ(rows[0].folder, options_.folder);
  for (const char* file : {"index.html", "study.json", "sheet.json", "fit.json", "properties.json",
                           "material.json", "material.glsl"})
    EXPECT_TRUE(fs::exists(options_.folder / file)) << file;
  EXPECT_FALSE(fs::exists(options_.folder / "s0"));
  EXPECT_EQ(kept_of(run()), 1u);
}

// The files of a single sample are removed when the folder receives the overview of several samples.
TEST_F(StudyOfFiles, AnOverviewTakesThePlaceOfAPage) {
  const std::vector<std::string> all = files_;
  files_.resize(1);
  run();
  files_ = all;
  run();
  EXPECT_FALSE(fs::exists(options_.folder / "material.json"));
  EXPECT_TRUE(fs::exists(options_.folder / "s0" / "material.json"));
  EXPECT_THAT(text("index.html"), HasSubstr("3 samples"));
}

TEST_F(StudyOfFiles, SamplesOfOneNameGetFoldersOfTheirOwn) {
  files_ = {files_[0], write_sample("other/s0.csv", 0.3)};
  const std::vector<Row> rows = run();
  EXPECT_NE(rows[0].folder, rows[1].folder);
  EXPECT_NE(text("s0/material.json"), text("s0.csv/material.json"));
  EXPECT_EQ(kept_of(run()), 2u);
}

TEST_F(StudyOfFiles, NoResultReplacesASample) {
  options_.folder = folder_ / "in";
  const fs::path place = folder_ / "in" / "s0" / "fit.json";
  fs::create_directories(place.parent_path());
  fs::copy_file(files_[1], place);
  files_[1] = place.string();
  EXPECT_THROW(run(), InputError);
  EXPECT_NO_THROW(io::read_samples(place));
}

TEST_F(StudyOfFiles, WhatWasInterruptedIsNotWritten) {
  std::atomic<bool> interrupted = false;
  options_.sample.fit.interrupted = &interrupted;
  options_.jobs = 1;
  options_.progress = [&](int done, int) { interrupted = done >= kSteps; };  // the first is finished
  const std::vector<Row> rows = run();
  EXPECT_EQ(rows[0].fault, Fault::none);
  EXPECT_EQ(rows[1].fault, Fault::interrupted);
  EXPECT_EQ(rows[2].fault, Fault::interrupted);
  EXPECT_EQ(rows[2].json["error"], rows[2].file + ": interrupted");
  EXPECT_FALSE(fs::exists(options_.folder / "s1"));
  interrupted = false;
  options_.progress = {};
  EXPECT_EQ(kept_of(run()), 1u);
}

// Returns the places of the samples' links in the overview, in the order of the samples.
std::vector<std::size_t> places(const std::string& page, std::size_t count) {
  std::vector<std::size_t> at;
  for (std::size_t k = 0; k < count; ++k) at.push_back(page.find(">s" + std::to_string(k) + "<"));
  return at;
}

TEST_F(StudyOfFiles, TheOverviewBeginsWithTheWorst) {
  std::ofstream(files_[1]) << "theta_i,phi_i,theta_o,phi_o,f\n10,0,20,x,0.1\n";
  run();
  const std::string page = text("index.html");
  EXPECT_THAT(page, HasSubstr("Worst: s1 (error)"));
  const std::string table = page.substr(page.find("<tbody>"));
  EXPECT_LT(table.find("s1"), table.find(">s0<"));
  EXPECT_LT(table.find("s1"), table.find(">s2<"));
}

TEST_F(StudyOfFiles, AToleranceMovesTheSamplesThatMissItToTheTop) {
  std::vector<Row> rows = run();
  std::vector<double> errors;
  for (const Row& row : rows) {
    EXPECT_TRUE(row.json["within_tolerance"].is_null());
    errors.push_back(row.json["median_relative_error"]);
  }
  EXPECT_THAT(text("index.html"), Not(HasSubstr("outside the tolerance")));
  const std::size_t worst = std::size_t(std::ranges::max_element(errors) - errors.begin());
  std::vector<double> sorted = errors;
  std::ranges::sort(sorted);
  options_.sample.tolerance = 0.5 * (sorted[1] + sorted[2]);
  rows = run();
  EXPECT_EQ(kept_of(rows), 0u);  // the pages state the tolerance
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(rows[k].misses_tolerance(), k == worst);
  const std::string page = text("index.html");
  EXPECT_THAT(page, HasSubstr("; 1 outside the tolerance."));
  const std::vector<std::size_t> at = places(page.substr(page.find("<tbody>")), 3);
  EXPECT_EQ(std::size_t(std::ranges::min_element(at) - at.begin()), worst);
  EXPECT_THAT(text("s" + std::to_string(worst) + "/index.html"),
              HasSubstr("<output class=\"bad\">Outside the tolerance: "));
}

// The results in the folder are compared with the new ones before they are replaced.
TEST_F(StudyOfFiles, AnotherRunShowsTheParametersThatMoved) {
  run();
  EXPECT_THAT(text("index.html"), Not(HasSubstr("Compared with")));
  write_sample("s1.csv", 0.3);
  const std::vector<Row> rows = run();
  EXPECT_TRUE(rows[0].changes.empty());
  ASSERT_FALSE(rows[1].changes.empty());
  const auto width = std::ranges::find(rows[1].changes, "alpha", &Change::what);
  ASSERT_NE(width, rows[1].changes.end());
  EXPECT_TRUE(width->is_beyond);
  EXPECT_THAT(text("index.html"),
              HasSubstr("1 sample has another form, or a parameter outside its older 95 % interval."));
  EXPECT_THAT(text("index.html"), HasSubstr("alpha from " + width->before + " to " + width->after));
  EXPECT_TRUE(io::read_json(options_.folder / "study.json")["results"][1]["changes"].is_array());
  run();
  EXPECT_THAT(text("index.html"), Not(HasSubstr("Compared with")));
}

TEST_F(StudyOfFiles, ParametersThatMovedAreFoundWithoutAnOverview) {
  run();
  fs::remove(options_.folder / "study.json");  // as after a run that was killed
  write_sample("s1.csv", 0.3);
  const std::vector<Row> rows = run();
  EXPECT_FALSE(rows[0].compared);
  EXPECT_TRUE(rows[1].compared);
  EXPECT_TRUE(std::ranges::any_of(rows[1].changes, [](const Change& c) { return c.what == "alpha"; }));
}

TEST_F(StudyOfFiles, AnOlderFolderCanBeNamed) {
  run();
  const fs::path older = options_.folder;
  options_.folder = folder_ / "newer";
  options_.against = older;
  const std::vector<Row> rows = run();
  for (const Row& row : rows) {
    EXPECT_TRUE(row.compared);
    EXPECT_TRUE(row.changes.empty());
  }
  EXPECT_THAT(text("index.html"),
              HasSubstr("every form is the same, and every parameter is within its older 95 % interval."));
  options_.against = folder_ / "in";
  EXPECT_THROW(run(), InputError);
}

TEST(Changes, CountFormsParametersAndIntervals) {
  const auto row = [](const std::string& form, const io::Json& estimates) {
    return io::Json{{"name", "s"}, {"form", form}, {"estimates", estimates}};
  };
  const auto estimate = [](const char* name, double value, double low, double high) {
    return io::Json{{"name", name}, {"channel", ""}, {"value", value}, {"low", low}, {"high", high}};
  };
  const io::Json older =
      row("ward", io::Json::array({estimate("alpha", 0.2, 0.19, 0.21), estimate("kd", 0.5, 0.4, 0.6)}));
  EXPECT_TRUE(changes_between(older, older).empty());
  const io::Json newer =
      row("ward", io::Json::array({estimate("alpha", 0.25, 0.2, 0.3), estimate("kd", 0.55, 0.4, 0.6)}));
  const std::vector<Change> moved = changes_between(older, newer);
  ASSERT_EQ(moved.size(), 2u);
  EXPECT_TRUE(moved[0].is_beyond);
  EXPECT_FALSE(moved[1].is_beyond);
  EXPECT_EQ(moved[0].before, "0.2");
  EXPECT_EQ(moved[0].after, "0.25");
  const std::vector<Change> form = changes_between(older, row("phong", io::Json::array()));
  ASSERT_EQ(form.size(), 1u);
  EXPECT_EQ(form[0].what, "form");
  EXPECT_TRUE(form[0].is_beyond);
  const std::vector<Change> lost =
      changes_between(older, row("ward", io::Json::array({estimate("kd", 0.5, 0.4, 0.6)})));
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_EQ(lost[0].after, "not identifiable");
}

TEST(Changes, ARowIsComparedWithTheOneOfItsNameThatHasValues) {
  const io::Json now = io::Json::parse(R"({"name": "s", "form": "ward", "estimates": []})");
  const auto changes = [&](const char* older) { return changes_from(io::Json::parse(older), now).size(); };
  EXPECT_EQ(changes(R"({"results": [{"name": "s", "form": "phong", "estimates": []}]})"), 1u);
  EXPECT_EQ(changes(R"({"results": [{"name": "t", "form": "phong", "estimates": []}]})"), 0u);
  EXPECT_EQ(changes(R"({"results": [{"name": "s", "error": "a fault"}]})"), 0u);
  for (const char* edited :
       {"{}", R"({"results": [3]})", R"({"results": [{"name": "s", "form": "ward", "estimates": [{}]}]})"})
    EXPECT_EQ(changes(edited), 0u) << edited;
}

// 200 samples whose thumbnails weigh as much as those of a real study.
TEST_F(StudyOfFiles, AnOverviewOfManySamplesIsLight) {
  files_.resize(1);
  options_.sample.pictures = true;
  Row row = run()[0];
  row.folder = options_.folder;
  for (const std::size_t count : {40u, 200u}) {
    write_overview(std::vector<Row>(count, row), folder_ / "many");
    const std::string page = io::read_content(folder_ / "many" / kPage).bytes;
    EXPECT_LT(page.size(), 3'000'000u) << count;
    EXPECT_EQ(page.find("src=\"s0/studio_small.png\"") == page.npos, count == 40);
    EXPECT_EQ(page.find("data:image/png") == page.npos, count == 200);
  }
}

TEST_F(StudyOfFiles, CountsItsStepsToTheEnd) {
  int last = 0, total = 0;
  std::ofstream(files_[1]) << "1,2\n";
  options_.progress = [&](int done, int all) {
    EXPECT_GT(done, last);
    last = done;
    total = all;
  };
  run();
  EXPECT_EQ(total, 3 * kSteps);
  EXPECT_EQ(last, total);
}

}  // namespace
}  // namespace brdf::study
