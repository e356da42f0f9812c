#include "cli/unit.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <iostream>

#include "cli/fit_files.h"
#include "cli/fit_options.h"
#include "cli/fit_table.h"
#include "cli/study_files.h"
#include "cli/terminal.h"
#include "io/content.h"
#include "io/error.h"
#include "io/output.h"
#include "io/temporary_folder.h"

namespace brdf::cli {
namespace {

namespace fs = std::filesystem;

// The files in a folder with their names below it, in the order of these.
std::vector<maps::UnitFile> files_in(const fs::path& folder) {
  std::vector<maps::UnitFile> out;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      out.push_back({entry.path().lexically_relative(folder).string(), io::read_content(entry.path()).bytes});
  std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return out;
}

template <class Number>
std::string bytes_of(const std::vector<Number>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Number)};
}

// Precondition: made by bytes_of().
template <class Number>
std::vector<Number> values_in(const maps::UnitFile& file) {
  std::vector<Number> values(file.bytes.size() / sizeof(Number));
  std::memcpy(values.data(), file.bytes.data(), file.bytes.size());
  return values;
}

std::vector<maps::UnitFile> files_of(const texel::Planes& planes) {
  std::vector<maps::UnitFile> files;
  for (std::size_t k = 0; k < planes.names.size(); ++k)
    files.push_back({planes.names[k], bytes_of(planes.values[k])});
  return files;
}

texel::Planes planes_of(const std::vector<maps::UnitFile>& files, const texel::Region& region) {
  texel::Planes planes{region.width, region.height, {}, {}};
  for (const maps::UnitFile& file : files) {
    if (file.bytes.size() != region.size() * sizeof(float))
      throw InputError(file.name + ": not of the unit's size");
    planes.names.push_back(file.name);
    planes.values.push_back(values_in<float>(file));
  }
  return planes;
}

const maps::Normals* known(const StackTask& task) {
  return task.normals ? &*task.normals : nullptr;
}

std::vector<maps::UnitFile> fit_texels(const Task& task, const texel::Region& region, std::uint64_t memory) {
  const StackTask stack = task.stack();
  return files_of(maps::fit_unit(stack.stack, stack.settings, known(stack), region, memory));
}

// What is no fault of a sample ends the unit: it is done again.
std::vector<maps::UnitFile> fit_tables(const Task& task, const texel::Region& region) {
  const io::TemporaryFolder scratch(task.job());
  const FileFits files{task.samples(), scratch.path(), 1, !task.options().no_pictures,
                       region.x,       region.width};
  const auto rows = fit_files(files, task.options().choice, fit_options(task.options().choice, 2), {});
  for (const fit::BatchRow& row : rows)
    if (row.environment_failed) throw EnvironmentError(row.error);
  return files_in(scratch.path());
}

std::vector<maps::UnitFile> study_tables(const Task& task, const texel::Region& region) {
  const io::TemporaryFolder scratch(task.job());
  study::StudyOptions options =
      study_options(task.options().choice, !task.options().no_pictures, scratch.path(), 2);
  options.jobs = 1;
  options.first = region.x;
  options.count = region.width;
  for (const study::Row& row : study::study(task.samples(), options))
    if (row.fault == study::Fault::environment) throw EnvironmentError(row.json["error"].get<std::string>());
  return files_in(scratch.path());
}

// Refit number k of a table under the name "k", its parameters as this machine's doubles.
std::vector<maps::UnitFile> solve_refits(const Task& task, const texel::Region& region) {
  const fit::FitOptions options = fit_options(task.options().choice, 2);
  const fit::RefitSolutions solutions =
      fit::solve_refits(samples_to_fit(task.samples()[0], options).table,
                        fit::models_of(task.options().choice.form), options, region.x, region.width);
  std::vector<maps::UnitFile> files;
  for (std::size_t k = 0; k < solutions.size(); ++k)
    files.push_back({std::to_string(region.x + k), bytes_of(solutions[k])});
  return files;
}

Exit collect_refits(const Task& task, const CollectFiles& files) {
  const fit::FitOptions options = fit_options(task.options().choice, 1);
  maps::check_input(task.plan().inputs[0], true);
  io::check_targets({{"-o", files.output}, {"--report", files.report}}, {task.samples()[0]});
  const fit::Samples samples = samples_to_fit(task.samples()[0], options);
  fit::RefitSolutions solutions;
  for (std::size_t k = 0; k < task.plan().units().size(); ++k)
    if (const auto content = maps::read_unit(task.job(), task.plan(), k))
      for (const maps::UnitFile& file : *content) solutions.push_back(values_in<double>(file));
  const fit::FitResult result =
      fit::fit(samples, fit::models_of(task.options().choice.form), options, {}, &solutions);
  return write_fit(result, samples.table, options, {files.output, files.report, false});
}

Exit collect_stack(const Task& task, const CollectFiles& files) {
  const StackTask stack = task.stack();
  io::check_folder_target({"-o", files.output}, result_names());
  texel::Planes maps = maps::empty_maps(stack.stack, stack.settings);
  const std::vector<texel::Region> units = task.plan().units();
  for (std::size_t k = 0; k < units.size(); ++k)
    if (const auto content = maps::read_unit(task.job(), task.plan(), k))
      maps::put(planes_of(*content, units[k]), units[k], maps);
  const maps::Making making{stack.settings, task.options().stack.normals, task.plan().command};
  return write_results({task.plan().stack, files.output, files.report, 1, false}, stack.stack, making, maps,
                       std::nullopt);
}

// The results of samples, where the verb finds and keeps them.
void unpack_units(const Task& task, const fs::path& folder) {
  for (const maps::Input& input : task.plan().inputs) check_input(input, true);
  io::check_folder_target({"-o", folder}, {}, {});
  for (std::size_t k = 0; k < task.plan().units().size(); ++k) {
    const auto files = maps::read_unit(task.job(), task.plan(), k);
    for (std::size_t q = 0; files && q < files->size(); ++q) {
      const fs::path target = folder / (*files)[q].name;
      io::make_folder(target.parent_path());
      io::write_file_atomically(target, (*files)[q].bytes);
    }
  }
}

Exit collect_tables(const Task& task, const CollectFiles& files) {
  if (!files.report.empty()) throw InputError("--report is for a stack of photographs");
  unpack_units(task, files.output);
  const fit::FitChoice& choice = task.options().choice;
  if (task.plan().verb == "study") {
    const study::StudyOptions options = study_options(choice, !task.options().no_pictures, files.output, 1);
    return print_study(study::study(task.samples(), options), files.output, false);
  }
  const auto rows = fit_files({task.samples(), files.output, 1, !task.options().no_pictures}, choice,
                              fit_options(choice, 1), {});
  for (const fit::BatchRow& row : rows)
    if (!row.error.empty() && row.error != fit::kInterrupted) Note() << "brdf collect: " << row.error;
  return summarise(rows, files.output, false);
}

}  // namespace

void do_unit(const Task& task, std::size_t unit, std::uint64_t memory, bool check) {
  const maps::Plan& plan = task.plan();
  if (maps::state_of(task.job(), plan, unit) == maps::UnitState::done) return;
  const texel::Region region = plan.units()[unit];
  const bool of_stack = !plan.stack.empty();
  for (std::size_t k = 0; k < plan.inputs.size(); ++k)
    if (of_stack || task.of_refits() || (k >= region.x && k < region.x + region.width))
      maps::check_input(plan.inputs[k], check || !of_stack);
  const std::vector<maps::UnitFile> files = of_stack             ? fit_texels(task, region, memory)
                                            : task.of_refits()   ? solve_refits(task, region)
                                            : plan.verb == "fit" ? fit_tables(task, region)
                                                                 : study_tables(task, region);
  if (!was_interrupted()) maps::write_unit(task.job(), plan, unit, files);
}

Exit put_together(const Task& task, const CollectFiles& files) {
  if (task.of_refits()) return collect_refits(task, files);
  return task.plan().stack.empty() ? collect_tables(task, files) : collect_stack(task, files);
}

}  // namespace brdf::cli
