#include "study/study.h"

#include <algorithm>
#include <mutex>
#include <new>

#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/fingerprint.h"
#include "io/files/output.h"
#include "io/files/text.h"
#include "study/overview.h"

namespace brdf::study {
namespace {

namespace fs = std::filesystem;
using io::Json;

// Part of the key of kept results. It changes whenever a row of study.json gets other members.
constexpr const char* kRowFormat = "row 2\n";

// A check of earlier results takes about a thirtieth of the time of the shortest study.
constexpr std::size_t kChecksBetweenStudies = 8;

class Study {
 public:
  Study(const std::vector<std::string>& samples, const StudyOptions& options)
      : options_(options), names_(folder_names(samples)), earlier_(options.against) {
    const std::size_t first = std::min(options.first, samples.size());
    names_.erase(names_.begin(), names_.begin() + std::ptrdiff_t(first));
    names_.resize(std::min(options.count, names_.size()));
    alone_ = samples.size() == 1;
    is_part_ = names_.size() < samples.size();
    rows_.resize(names_.size());
    is_done_.resize(names_.size());
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      rows_[k].file = samples[first + k];
      rows_[k].folder = alone() ? options.folder : options.folder / names_[k];
    }
    check_outputs();
    set_order();
  }

  std::vector<Row> run() {
    io::parallel_for(
        rows_.size(),
        [this](std::size_t k) {
          work(order_[k]);
          hand_over(order_[k]);
        },
        options_.jobs);
    if (is_part_) return std::move(rows_);
    const auto unreadable = [](const Row& row) { return row.fault == Fault::input; };
    if (std::ranges::all_of(rows_, unreadable)) {
      const std::string first = rows_.front().json["error"];
      throw InputError(alone() ? first : "no sample can be used: " + first);
    }
    if (!alone()) write_overview(rows_, options_.folder, options_.against);
    return std::move(rows_);
  }

 private:
  bool alone() const { return alone_; }

  // Throws InputError if a folder cannot be written, or if a result would overwrite one of the samples.
  void check_outputs() const {
    std::vector<fs::path> inputs;
    for (const Row& row : rows_) inputs.emplace_back(row.file);
    const io::Inputs read(inputs);
    io::check_folder_target({"-o", options_.folder}, {kPage, kResults}, read);
    const std::vector<std::string> names(kSampleFiles.begin(), kSampleFiles.end());
    io::parallel_for(
        rows_.size(),
        [&](std::size_t k) {
          if (!options_.sample.fit.stop())  // otherwise each sample reports the interruption
            io::check_folder_target({"-o", rows_[k].folder}, names, read);
        },
        options_.jobs);
  }

  // Puts checks of earlier results between the studies of samples without results.
  void set_order() {
    std::vector<std::size_t> checks;
    std::size_t checked = 0;
    const auto check = [&](std::size_t most) {
      for (std::size_t k = 0; k < most && checked < checks.size(); ++k) order_.push_back(checks[checked++]);
    };
    std::vector<std::size_t> studies;
    for (std::size_t k = 0; k < rows_.size(); ++k)
      (has_results(rows_[k].folder) ? checks : studies).push_back(k);
    for (const std::size_t k : studies) {
      order_.push_back(k);
      check(kChecksBetweenStudies);
    }
    check(checks.size());
  }

  // Calls options.finished for all rows that are due.
  void hand_over(std::size_t k) {
    if (!options_.finished) return;
    const std::lock_guard lock(mutex_);
    is_done_[k] = true;
    is_one_readable_ |= rows_[k].fault != Fault::input;
    for (; is_one_readable_ && handed_over_ < rows_.size() && is_done_[handed_over_]; ++handed_over_)
      options_.finished(rows_[handed_over_], handed_over_, rows_.size());
  }

  void work(std::size_t k) {
    Row& row = rows_[k];
    int steps = 0;
    const auto step = [&] {
      ++steps;
      advance(1);
    };
    const auto fail = [&](Fault fault, const std::string& why) {
      row.fault = fault;
      row.json = Json{{"name", names_[k]}, {"file", row.file}, {"error", why}, {"usable", false}};
    };
    try {
      if (options_.sample.fit.stop())
        fail(Fault::interrupted, row.file + ": interrupted");
      else if (!fill(row, names_[k], step))
        fail(Fault::interrupted, row.file + ": interrupted");
      else if (earlier_.has(names_[k])) {
        row.changes = earlier_.changes_to(row.json);
        row.compared = true;
      }
    } catch (const InputError& error) {
      fail(Fault::input, error.what());
    } catch (const std::bad_alloc&) {
      fail(Fault::environment, row.file + ": not enough memory");
    } catch (const std::exception& error) {
      fail(Fault::environment, error.what());
    }
    advance(kSteps - steps);
  }

  // Returns false if the run was interrupted.
  bool fill(Row& row, const std::string& name, const Step& step) {
    io::Content content = io::read_content(row.file);
    const std::string key =
        io::fingerprint({options_.settings, fit::constants_text(options_.sample.fit), "\n", row.file,
                         alone() ? "\nalone\n" : "\none of many\n",
                         options_.sample.pictures ? "" : "no pictures\n", tolerance_text(), kRowFormat,
                         has_lobes() ? "" : "no lobes\n", content.bytes, io::stated_budget_text(content)});
    std::optional<Json> earlier = kept(row.folder, key);
    if (earlier) {
      row.json = earlier->at("results").at(0);
      row.kept = true;
      return true;
    }
    const std::optional<Json> before =
        options_.against.empty() ? results_in(row.folder) : std::optional<Json>();
    SampleOptions options = options_.sample;
    options.alone = alone();
    SampleStudy found = study_sample(std::move(content), name, options, step);
    if (found.interrupted) return false;
    row.json = std::move(found.row);
    row.assumptions = std::move(found.assumptions);
    Json results = io::to_json(io::provenance(options.fit.seed));
    results["results"] = Json::array({row.json});
    publish(row.folder, found.files, std::move(results), key);
    if (before) row.changes = changes_from(*before, row.json);
    row.compared = !row.changes.empty();
    return true;
  }

  std::string tolerance_text() const {
    return options_.sample.tolerance ? "tolerance " + io::to_text(*options_.sample.tolerance) + "\n" : "";
  }

  void advance(int steps) {
    if (!options_.progress || steps == 0) return;
    const std::lock_guard lock(mutex_);
    options_.progress(done_ += steps, int(rows_.size()) * kSteps);
  }

  const StudyOptions& options_;
  std::vector<std::string> names_;  // of the folders of the samples that are studied
  // alone_: there is only one sample. is_part_: only some of the samples are studied.
  bool alone_ = false, is_part_ = false;
  const Earlier earlier_;  // of options.against
  std::vector<Row> rows_;
  std::vector<std::size_t> order_;  // in which the rows are worked on
  std::mutex mutex_;
  int done_ = 0;
  // Of the calls of options.finished.
  std::vector<bool> is_done_;
  std::size_t handed_over_ = 0;
  bool is_one_readable_ = false;
};

}  // namespace

Json to_json(const Row& row) {
  Json json = row.json;
  if (row.fault == Fault::none) json["changes"] = row.compared ? to_json(row.changes) : Json(nullptr);
  return json;
}

std::vector<Row> study(const std::vector<std::string>& samples, const StudyOptions& options) {
  return Study(samples, options).run();
}

}  // namespace brdf::study
