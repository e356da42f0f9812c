#include "work/unit.h"

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/output.h"
#include "io/files/temporary.h"

namespace brdf::work {
namespace {

namespace fs = std::filesystem;

// Returns the files in a folder, sorted by their names relative to the folder.
std::vector<UnitFile> files_in(const fs::path& folder) {
  std::vector<UnitFile> out;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      out.push_back({entry.path().lexically_relative(folder).string(), io::read_result(entry.path()).bytes});
  std::ranges::sort(out, [](const auto& a, const auto& b) { return a.name < b.name; });
  return out;
}

template <class Number>
std::string bytes_of(const std::vector<Number>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Number)};
}

// Precondition: the file was made by bytes_of().
template <class Number>
std::vector<Number> values_in(const UnitFile& file) {
  std::vector<Number> values(file.bytes.size() / sizeof(Number));
  std::memcpy(values.data(), file.bytes.data(), file.bytes.size());
  return values;
}

std::vector<UnitFile> files_of(const texel::Planes& planes) {
  std::vector<UnitFile> files;
  for (std::size_t k = 0; k < planes.names.size(); ++k)
    files.push_back({planes.names[k], bytes_of(planes.values[k])});
  return files;
}

texel::Planes planes_of(const std::vector<UnitFile>& files, const texel::Region& region) {
  texel::Planes planes{region.width, region.height, {}, {}};
  for (const UnitFile& file : files) {
    if (file.bytes.size() != region.size() * sizeof(float))
      throw InputError(file.name + ": the size differs from the size of the unit");
    planes.names.push_back(file.name);
    planes.values.push_back(values_in<float>(file));
  }
  return planes;
}

const maps::Normals* known(const StackTask& task) {
  return task.normals ? &*task.normals : nullptr;
}

std::vector<UnitFile> fit_texels(const Task& task, const texel::Region& region, std::uint64_t memory) {
  const StackTask stack = task.stack();
  return files_of(maps::fit_unit(stack.stack, stack.settings, known(stack), region, memory));
}

// A failure of the environment, which is not a fault of the sample, ends the unit. The unit is then done
// again.
std::vector<UnitFile> fit_tables(const Task& task, const texel::Region& region, const Caller& caller) {
  const io::TemporaryFolder scratch(task.job());
  const FileFits files{task.samples(), scratch.path(), 1, !task.options().no_pictures,
                       region.x,       region.width};
  const auto rows = fit_files(files, task.options().choice,
                              fit_options(task.options().choice, 2, caller.interrupted), caller);
  for (const fit::BatchRow& row : rows)
    if (row.environment_failed) throw EnvironmentError(row.error);
  return files_in(scratch.path());
}

std::vector<UnitFile> study_tables(const Task& task, const texel::Region& region, const Caller& caller) {
  const io::TemporaryFolder scratch(task.job());
  study::StudyOptions options =
      study_options(task.options().choice, !task.options().no_pictures, scratch.path(), 2, caller);
  options.jobs = 1;
  options.first = region.x;
  options.count = region.width;
  for (const study::Row& row : study::study(task.samples(), options))
    if (row.fault == study::Fault::environment) throw EnvironmentError(row.json["error"].get<std::string>());
  return files_in(scratch.path());
}

// Solves refits. Refit number k of a table gets the name "k"; its parameters are stored as doubles of this
// machine.
std::vector<UnitFile> solve_refits(const Task& task, const texel::Region& region, const Caller& caller) {
  const fit::FitOptions options = fit_options(task.options().choice, 2, caller.interrupted);
  const fit::RefitSolutions solutions =
      fit::solve_refits(samples_to_fit(task.samples()[0], options, caller).table,
                        fit::models_of(task.options().choice.form), options, region.x, region.width);
  std::vector<UnitFile> files;
  for (std::size_t k = 0; k < solutions.size(); ++k)
    files.push_back({std::to_string(region.x + k), bytes_of(solutions[k])});
  return files;
}

}  // namespace

void do_unit(const Task& task, std::size_t unit, std::uint64_t memory, bool check, const Caller& caller) {
  const Plan& plan = task.plan();
  if (state_of(task.job(), plan, unit) == UnitState::done) return;
  const texel::Region region = plan.units()[unit];
  const bool of_stack = !plan.stack.empty();
  for (std::size_t k = 0; k < plan.inputs.size(); ++k)
    if (of_stack || task.of_refits() || (k >= region.x && k < region.x + region.width))
      check_input(plan.inputs[k], check || !of_stack);
  const std::vector<UnitFile> files = of_stack             ? fit_texels(task, region, memory)
                                      : task.of_refits()   ? solve_refits(task, region, caller)
                                      : plan.verb == "fit" ? fit_tables(task, region, caller)
                                                           : study_tables(task, region, caller);
  if (!caller.stops()) write_unit(task.job(), plan, unit, files);
}

fit::RefitSolutions refits_of(const Task& task) {
  fit::RefitSolutions solutions;
  for (std::size_t k = 0; k < task.plan().units().size(); ++k)
    if (const auto content = read_unit(task.job(), task.plan(), k))
      for (const UnitFile& file : *content) solutions.push_back(values_in<double>(file));
  return solutions;
}

texel::Planes maps_of(const Task& task, const StackTask& stack) {
  texel::Planes maps = maps::empty_maps(stack.stack, stack.settings);
  const std::vector<texel::Region> units = task.plan().units();
  for (std::size_t k = 0; k < units.size(); ++k)
    if (const auto content = read_unit(task.job(), task.plan(), k))
      maps::put(planes_of(*content, units[k]), units[k], maps);
  return maps;
}

void unpack_units(const Task& task, const fs::path& folder) {
  for (const Input& input : task.plan().inputs) check_input(input, true);
  io::check_folder_target({"-o", folder}, {}, {});
  for (std::size_t k = 0; k < task.plan().units().size(); ++k) {
    const auto files = read_unit(task.job(), task.plan(), k);
    for (std::size_t q = 0; files && q < files->size(); ++q) {
      const fs::path target = folder / (*files)[q].name;
      io::make_folder(target.parent_path());
      io::write_file_atomically(target, (*files)[q].bytes);
    }
  }
}

}  // namespace brdf::work
