#include "work/options.h"

#include <algorithm>
#include <filesystem>

#include "io/files/error.h"
#include "io/files/parallel.h"
#include "texel/stack.h"

namespace brdf::work {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> samples_in(const fs::path& folder) {
  if (texel::is_stack(folder))
    throw InputError(folder.string() + ": is a stack of photographs, not a folder of tables; fit it alone: " +
                     "brdf fit " + folder.string() + " --form FORM -o MAPS");
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const bool is_broken = entry.is_symlink() && !fs::exists(entry.path());  // reported as a file that fails
    if ((!entry.is_regular_file() && !is_broken) || entry.path().filename().string().starts_with('.'))
      continue;
    if (entry.path().extension() == ".exr")
      throw InputError(folder.string() + ": is not a stack: the folder has images, but no lights.csv");
    files.push_back(entry.path().string());
  }
  if (files.empty()) throw InputError(folder.string() + ": the folder has no files");
  std::ranges::sort(files);
  return files;
}

}  // namespace

std::vector<std::string> arguments_of(const TaskOptions& options) {
  std::vector<std::string> words = fit::arguments_of(options.choice);
  const TaskOptions plain;
  if (options.stack.normals != plain.stack.normals)
    words.insert(words.end(), {"--normals", options.stack.normals});
  if (options.no_pictures) words.emplace_back("--no-pictures");
  return words;
}

fit::FitOptions fit_options(const fit::FitChoice& choice, unsigned jobs,
                            const std::atomic<bool>* interrupted) {
  fit::FitOptions options = fit::options_of(choice);
  options.interrupted = interrupted;
  if (jobs > 1) io::limit_threads(1);
  options.threads = io::all_processors();
  return options;
}

maps::Settings settings_of(const StackOptions& stack_options, const fit::FitChoice& choice,
                           const fit::FitOptions& options) {
  const std::vector<std::vector<Reflectance>> models = fit::models_of(choice.form);
  if (models.size() != 1)
    throw InputError("--form " + choice.form + ": a stack is fitted with one form, or a sum, for all texels");
  maps::Settings settings{models[0], options, stack_options.normals == "fit"};
  maps::check(settings);
  return settings;
}

std::string normals_file(const StackOptions& options) {
  return options.normals == "flat" || options.normals == "fit" ? "" : options.normals;
}

std::vector<std::string> sample_files(const std::vector<std::string>& named) {
  std::vector<std::string> files;
  for (const std::string& name : named) {
    if (!fs::is_directory(name)) {
      files.push_back(name);
      continue;
    }
    const std::vector<std::string> inside = samples_in(name);
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

bool names_folder(const std::vector<std::string>& named) {
  return std::ranges::any_of(named, [](const auto& name) { return fs::is_directory(name); });
}

}  // namespace brdf::work
