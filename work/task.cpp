#include "work/task.h"

#include <utf8.h>

#include <algorithm>
#include <filesystem>

#include "fit/file_batch.h"
#include "io/columns/layout.h"
#include "io/files/error.h"
#include "io/files/json.h"
#include "io/files/provenance.h"
#include "io/files/text.h"
#include "io/formats/read.h"
#include "texel/stack.h"

namespace brdf::work {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFilesInUnit = 16, kRefitsInUnit = 64;  // defaults

// Returns the command without the word `plan`.
std::string command_at_once() {
  std::string command = io::provenance().command;
  constexpr std::string_view kVerb = " plan ";
  if (const std::size_t found = command.find(kVerb); found != std::string::npos)
    command.replace(found, kVerb.size(), " ");
  return command;
}

std::size_t count_in(std::string_view text) {
  double number = 0;
  return io::parse_number(text, number) && number >= 1 && number <= 1e9 &&
                 number == double(std::size_t(number))
             ? std::size_t(number)
             : 0;
}

// Parses "64x64", a size in whole tiles.
void divide_texels(const std::string& size, Plan& plan) {
  plan.unit_width = plan.unit_height = maps::kUnit;
  if (size.empty()) return;
  const std::size_t cross = size.find('x');
  plan.unit_width = count_in(size.substr(0, cross));
  plan.unit_height = cross == std::string::npos ? 0 : count_in(size.substr(cross + 1));
  const auto whole = [](std::size_t side) { return side > 0 && side % maps::kTile == 0; };
  if (!whole(plan.unit_width) || !whole(plan.unit_height))
    throw InputError("--unit-size " + size + ": must be WIDTHxHEIGHT for a stack, both multiples of " +
                     std::to_string(maps::kTile));
}

// Divides `all` parts into units, in one row.
void divide(std::size_t all, const std::string& size, std::size_t usual, const char* things, Plan& plan) {
  plan.width = all;
  plan.height = plan.unit_height = 1;
  plan.unit_width = size.empty() ? usual : count_in(size);
  if (plan.unit_width == 0) throw InputError("--unit-size " + size + ": " + things + ", 1 or more");
}

// Replaces the name of a layout's file by the layout, so that the units do not depend on the file. Throws
// the errors of io::read_layout().
void hold_layout(io::Supplied& supplied) {
  if (supplied.layout.empty()) return;
  io::read_layout(supplied.layout);
  supplied.layout = io::to_line(io::parse_json(io::layout_text(supplied.layout), supplied.layout));
}

// Divides the refits of one table.
void divide_fit(const std::string& file, const std::string& size, const TaskOptions& options, Plan& plan) {
  if (options.no_pictures)
    throw InputError("--no-pictures applies to several sample files; the fit of one file draws no pictures");
  const auto models = fit::models_of(options.choice.form);
  if (models.empty())
    throw InputError("--form " + options.choice.form +
                     ": chooses by consecutive fits, which cannot be divided; name a form");
  const fit::FitOptions fit = fit_options(options.choice, 1, nullptr);
  const std::size_t refits = fit::count_refits(
      fit::arranged(io::read_samples(file, io::supplied_for(fit.supplied, fit.arrangement)), fit).table,
      models.size(), fit);
  if (refits == 0)
    throw InputError(file + ": has one direction and therefore no folds: there is no work to divide");
  divide(refits, size, kRefitsInUnit, "must be a number of refits for one table", plan);
}

std::vector<std::string> files_of(const texel::Stack& stack, const std::string& normals) {
  std::vector<std::string> files{(stack.folder / texel::kLightsFile).string()};
  for (const fs::path& image : stack.images) files.push_back(image.string());
  if (!stack.mask.empty()) files.push_back((stack.folder / texel::kMaskFile).string());
  if (!normals.empty()) files.push_back(normals);
  return files;
}

StackTask stack_task(const std::string& folder, const TaskOptions& options) {
  StackTask out{texel::open_stack(folder),
                settings_of(options.stack, options.choice, fit_options(options.choice, 1, nullptr)),
                {}};
  if (const std::string given = normals_file(options.stack); !given.empty())
    out.normals = maps::read_normals(given, out.stack);
  return out;
}

}  // namespace

Plan plan_of(const std::string& verb, const std::vector<std::string>& named, const std::string& unit_size,
             TaskOptions options) {
  const bool is_fit = verb == "fit";
  Plan plan{.verb = verb, .command = command_at_once(), .directory = fs::current_path().string()};
  std::vector<std::string> files;
  if (is_fit && named.size() == 1 && texel::is_stack(named[0])) {
    if (options.no_pictures) throw InputError("--no-pictures applies to tables, not to a stack");
    plan.stack = named[0];
    divide_texels(unit_size, plan);
    const StackTask task = stack_task(named[0], options);
    options.choice.options.metric =
        maps::choose_metric(task.stack, task.settings, task.normals ? &*task.normals : nullptr);
    plan.width = task.stack.width;
    plan.height = task.stack.height;
    files = files_of(task.stack, normals_file(options.stack));
  } else {
    if (options.stack.normals != StackOptions().normals)
      throw InputError("--normals applies to a stack of photographs");
    fit_options(options.choice, 1, nullptr);
    fit::models_of(options.choice.form);
    hold_layout(options.choice.options.supplied);
    files = sample_files(named);
    if (!is_fit && options.choice.options.bootstrap > 0) throw InputError("--bootstrap applies to fit");
    if (is_fit && files.size() == 1 && !names_folder(named)) {
      divide_fit(files[0], unit_size, options, plan);
    } else {
      if (files.size() < 2)
        throw InputError(files[0] + ": a single table cannot be divided; use brdf " + verb);
      if (is_fit) fit::batch_names(files);
      divide(files.size(), unit_size, kFilesInUnit, "must be a number of files for tables", plan);
    }
  }
  for (const std::string& file : files)
    if (!utf8::is_valid(file))
      throw InputError(io::shown(file) + ": the names of planned inputs must be UTF-8");
  plan.options = arguments_of(options);
  return completed(std::move(plan), files);
}

std::string absolute(const std::string& path) {
  return path.empty() ? "" : fs::absolute(path).lexically_normal().string();
}

Task::Task(const std::string& job, const std::function<TaskOptions(const std::vector<std::string>&)>& read)
    : job_(absolute(job)), plan_(read_plan(job_)), options_(read(plan_.options)) {}

StackTask Task::stack() const {
  return stack_task(plan_.stack, options_);
}

std::vector<std::string> Task::samples() const {
  std::vector<std::string> files;
  for (const Input& input : plan_.inputs) files.push_back(input.file);
  return files;
}

}  // namespace brdf::work
