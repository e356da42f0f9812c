#include "fit/file_batch.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <new>

#include "fit/report/html.h"
#include "fit/report/report.h"
#include "io/files/address.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/fingerprint.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/files/parallel.h"
#include "io/files/standard_input.h"
#include "io/files/text.h"
#include "io/formats/read.h"
#include "io/material/material_json.h"
#include "io/page/html_report.h"

namespace brdf::fit {
namespace {

namespace fs = std::filesystem;
using io::Json;

constexpr const char* kSummaries[] = {"summary.csv", "summary.html"};

// Returns the names of the results of a file with this name.
std::vector<std::string> outputs_of(const std::string& name) {
  return {name + ".json", name + ".fit.json", name + ".html", name + ".png"};
}

// Rejects a folder that cannot be written, or in which a result would replace one of the files.
void check_outputs(const std::vector<std::string>& files, const std::vector<std::string>& names,
                   const fs::path& folder) {
  std::vector<std::string> outputs(std::begin(kSummaries), std::end(kSummaries));
  for (const std::string& name : names)
    for (std::string& output : outputs_of(name)) outputs.push_back(std::move(output));
  io::check_folder_target({"-o", folder}, outputs, {files.begin(), files.end()});
}

// The key of a report's seal, a fingerprint of the inputs and of the report itself. A report that was
// edited is made again.
constexpr const char* kSeal = "batch_key";
std::string sealed(const std::string& key, const Json& report) {
  return io::fingerprint({key, io::to_text(report)});
}

std::string recommended_in(const Json& report) {
  const Json& form = report.at("recommended");
  return form.is_null() ? "" : form.get<std::string>();
}

// Returns whether a message begins with the name of the file. Messages of readers do, mostly followed by
// the line.
bool begins_with_name(const std::string& message, const std::string& file) {
  return message.starts_with(file + ": ") || message.starts_with(file + ", ");
}

class Batch {
 public:
  Batch(const std::vector<std::string>& files, const std::vector<std::vector<Reflectance>>& models,
        const FitOptions& options, const BatchOptions& batch)
      : files_(files), models_(models), options_(options), batch_(batch), names_(batch_names(files)) {
    first_ = std::min(batch.first, files.size());
    rows_.resize(std::min(batch.count, files.size() - first_));
    check_outputs(files_, names_, batch_.folder);
  }

  std::vector<BatchRow> run() {
    io::make_folder(batch_.folder);
    io::parallel_for(
        rows_.size(), [this](std::size_t k) { work(k); }, batch_.jobs);
    return std::move(rows_);
  }

 private:
  void work(std::size_t k) {
    BatchRow& row = rows_[k];
    row.file = files_[first_ + k];
    row.name = names_[first_ + k];
    if (options_.stop()) {
      row.error = kInterrupted;
      return;
    }
    try {
      fit_file(row);
    } catch (const InputError& error) {
      row.error = error.what();
    } catch (const std::bad_alloc&) {
      row.environment_failed = true;
      row.error = row.file + ": not enough memory";
    } catch (const std::exception& error) {
      row.environment_failed = true;
      row.error = error.what();
    }
    if (row.error != kInterrupted) say(row);
  }

  void fit_file(BatchRow& row) {
    io::Content content = io::read_content(row.file);
    const std::string key =
        io::fingerprint({batch_.settings + constants_text(options_) + (batch_.spheres ? "" : " no spheres"),
                         content.bytes, io::stated_budget_text(content)});
    const fs::path report = batch_.folder / (row.name + ".fit.json");
    if (reuse(row, report, key)) return;
    const Samples samples = arranged(
        io::read_samples(std::move(content), io::supplied_for(options_.supplied, options_.arrangement)),
        options_);
    const io::SampleTable& table = samples.table;
    row.assumptions = table.assumptions;
    const FitResult result = fit(samples, models_, options_);
    const FormFit& best = result.ranking.front();
    if (result.interrupted) {
      row.error = kInterrupted;
      return;
    }
    if (!best.solved()) {
      row.error = best.findings.front();
      return;
    }
    io::write_material_file(batch_.folder / (row.name + ".json"),
                            {best.material, material_block(best, result, table, options_)});
    io::write_file_atomically(batch_.folder / (row.name + ".html"),
                              html_report(result, table, options_, batch_.spheres));
    Json j = to_json(result, table, options_);
    j[kSeal] = sealed(key, j);
    row.best = j["ranking"][0];
    row.recommended = recommended_in(j);
    io::write_file_atomically(report, io::to_text(j));  // written last: it marks the files as complete
  }

  bool reuse(BatchRow& row, const fs::path& report, const std::string& key) const {
    for (const char* ending : {".json", ".html", ".fit.json"})
      if (!fs::exists(batch_.folder / (row.name + ending))) return false;
    Json j;
    try {
      j = io::read_json(io::read_result(report));
    } catch (const InputError&) {  // not a report of ours: written again
    }
    if (!j.is_object() || !j.contains(kSeal)) return false;
    const Json seal = j[kSeal];
    j.erase(kSeal);
    if (seal != sealed(key, j)) return false;
    row.best = j.at("ranking").at(0);
    row.recommended = recommended_in(j);
    return row.reused = true;
  }

  void say(const BatchRow& row) {
    if (!batch_.progress) return;
    const std::lock_guard lock(mutex_);
    const std::string number = "[" + std::to_string(++done_) + "/" + std::to_string(rows_.size()) + "] ";
    const std::string name = io::input_name(row.file);
    if (!row.error.empty())
      return batch_.progress(number + (begins_with_name(row.error, name) ? "" : name + ": ") + row.error);
    batch_.progress(number + name + ": " + row.best["form"].get<std::string>() + ", " +
                    row.best["verdict"].get<std::string>() + (row.reused ? " (kept)" : ""));
    for (const std::string& sentence : row.assumptions) batch_.progress(name + ": " + sentence);
  }

  const std::vector<std::string>& files_;
  const std::vector<std::vector<Reflectance>>& models_;
  const FitOptions& options_;
  const BatchOptions& batch_;
  std::vector<std::string> names_;
  std::size_t first_ = 0;  // index in names_ of the first row
  std::vector<BatchRow> rows_;
  std::mutex mutex_;
  std::size_t done_ = 0;
};

std::string number(const Json& j, const char* key) {
  return j.contains(key) && j[key].is_number() ? io::to_text(j[key].get<double>()) : "";
}

std::string first_finding(const BatchRow& row) {
  if (!row.error.empty()) return row.error;
  const Json& findings = row.best["findings"];
  return findings.empty() ? "" : findings[0].get<std::string>();
}

}  // namespace

// "copper.csv" and "copper.fit" differ only in their suffix. The whole file name is kept in such a case,
// and if a result would have the name of another file's result or of the summary.
std::vector<std::string> batch_names(const std::vector<std::string>& files) {
  std::map<std::string, std::string> taken;
  for (const char* summary : kSummaries) taken.emplace(summary, "the summary");
  const auto is_free = [&](const std::string& name) {
    const std::vector<std::string> outputs = outputs_of(name);
    return std::ranges::none_of(outputs, [&](const auto& o) { return taken.count(o) > 0; });
  };
  std::vector<std::string> names;
  for (const std::string& file : files) {
    std::string name = fs::path(file).stem().string();
    if (!is_free(name)) name = fs::path(file).filename().string();
    for (const std::string& output : outputs_of(name))
      if (const auto [it, added] = taken.emplace(output, file); !added)
        throw InputError(file + " and " + it->second + ": the results of both would have the name " + output);
    names.push_back(std::move(name));
  }
  return names;
}

std::vector<BatchRow> run_batch(const std::vector<std::string>& files,
                                const std::vector<std::vector<Reflectance>>& models,
                                const FitOptions& options, const BatchOptions& batch) {
  return Batch(files, models, options, batch).run();
}

io::Json to_json(const std::vector<BatchRow>& rows, const fs::path& folder) {
  io::Json list = io::Json::array();
  for (const BatchRow& row : rows)
    if (row.error.empty())
      list.push_back({{"file", row.file},
                      {"material", (folder / (row.name + ".json")).string()},
                      {"kept", row.reused},
                      {"best", row.best}});
    else
      list.push_back({{"file", row.file}, {"error", row.error}});
  return {{"files", list}};
}

bool usable(const BatchRow& row) {
  if (!row.error.empty()) return false;
  const auto verdict = find_named<Verdict>(row.best["verdict"].get<std::string>());
  return verdict && usable(*verdict);
}

void write_summary(const std::vector<BatchRow>& rows, const fs::path& folder) {
  std::string csv =
      "file,form,verdict,left_out,median_relative_error,cross_validated_error,bic,recommended,finding\n";
  io::HtmlReport html("Fits of " + io::plural(rows.size(), "file"));
  html.style("body { max-width: 84rem; } td:last-child { min-width: 16rem; }");
  std::vector<std::vector<io::Cell>> cells;
  io::Series in_sample{"median error (fitted)", {}, {}, io::Series::Style::points};
  io::Series left_out{"median error (held out)", {}, {}, io::Series::Style::points};
  std::size_t good = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const BatchRow& row = rows[k];
    good += usable(row);
    const bool fitted = row.error.empty();
    const std::string form = fitted ? row.best["form"].get<std::string>() : "";
    const std::string verdict = fitted ? row.best["verdict"].get<std::string>() : "error";
    const std::string error = fitted ? number(row.best, "median_relative_error") : "";
    const std::string cross = fitted ? number(row.best, "cross_validated_error") : "";
    const std::string left_out_value = fitted ? number(row.best, "left_out") : "";
    csv += io::csv_quoted(row.file) + "," + form + "," + verdict + "," + left_out_value + "," + error + "," +
           cross + "," + (fitted ? number(row.best, "bic") : "") + "," + row.recommended + "," +
           io::csv_quoted(first_finding(row)) + "\n";
    const auto share = [&](const char* key) {
      const bool known = fitted && row.best.contains(key) && row.best[key].is_number();
      return io::Cell{known ? io::percent(row.best[key].get<double>()) : "-"};
    };
    cells.push_back(
        {{.text = io::file_name(row.file), .link = fitted ? io::address_of(row.name + ".html") : ""},
         {form, io::Mark::none, true},
         {verdict, fitted ? find_named<io::Mark>(row.best["state"].get<std::string>()).value_or(io::Mark::bad)
                          : io::Mark::bad},
         share("median_relative_error"),
         share("cross_validated_error"),
         {row.recommended, io::Mark::none, true},
         {first_finding(row)}});
    if (!fitted) continue;
    in_sample.x.push_back(double(k + 1));
    left_out.x.push_back(double(k + 1));
    in_sample.y.push_back(row.best.value("median_relative_error", 0.0));
    left_out.y.push_back(row.best.value("cross_validated_error", std::nan("")));
  }
  html.verdict(good == rows.size() ? io::Mark::good : io::Mark::warn,
               std::to_string(good) + " of " + io::plural(rows.size(), "file") +
                   (good == 1 ? " has" : " have") + " a usable fit.");
  std::vector<io::Figure> pictures;
  for (const BatchRow& row : rows) {
    const fs::path picture = folder / (row.name + ".png");
    if (row.error.empty() && fs::exists(picture))
      pictures.push_back(
          {io::read_result(picture).bytes, row.name, "", io::Mark::none, io::address_of(row.name + ".html")});
  }
  if (!pictures.empty()) html.pictures(pictures);
  html.explain("median (held out)",
               "Median of the relative errors at incidences that were held out of the fit.");
  html.table({"file", "form", "verdict", "median (fitted)", "median (held out)", "recommended", "finding"},
             cells, true);
  if (!in_sample.x.empty()) {
    io::Plot plot;
    plot.title = "Median error";
    plot.x_label = "file, in the order given";
    plot.y_label = "median of |fit - value|/value";
    plot.log_y = true;
    plot.series = {in_sample, left_out};
    html.plot(plot);
  }
  for (const BatchRow& row : rows) html.footnote("samples", row.file);
  io::write_file_atomically(folder / "summary.csv", csv);
  io::write_file_atomically(folder / "summary.html", html.document(io::provenance()));
}

}  // namespace brdf::fit
