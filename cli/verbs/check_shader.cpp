#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "cli/options/fit_options.h"
#include "cli/options/options.h"
#include "cli/options/progress.h"
#include "cli/options/terminal.h"
#include "cli/steps/shader_subject.h"
#include "cli/verb.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/json.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/files/text.h"
#include "validate/report/continuous.h"
#include "validate/report/report.h"

namespace brdf::cli {
namespace {

namespace fs = std::filesystem;
using validate::Finding;
using validate::Outcome;

struct CheckShaderCall {
  std::vector<std::string> paths, defines, include_folders, textures;
  std::string baseline, junit, sarif, effort = "quick";
  bool update = false, json = false;
  double seconds = 0;
  std::uint64_t seed = 1;
};

// Returns the files, those of a folder in the order of their names, each once. Hidden folders are left out. A
// file that is named itself may have any suffix.
std::vector<std::string> shader_files(const std::vector<std::string>& paths) {
  const std::vector<std::string> suffixes = shader_suffixes();
  const auto may_be_shader = [&](const fs::path& file) {
    return std::ranges::find(suffixes, io::lower_case(file.extension().string())) != suffixes.end();
  };
  std::vector<std::string> files;
  const auto add = [&](const std::string& file) {
    if (std::ranges::find(files, file) == files.end()) files.push_back(file);
  };
  for (const std::string& path : paths) {
    std::error_code error;
    if (!fs::exists(path, error)) throw InputError(path + ": is neither a folder nor a file");
    if (!fs::is_directory(path, error)) {
      add(fs::path(path).lexically_normal().string());
      continue;
    }
    std::vector<std::string> found;
    for (fs::recursive_directory_iterator at(path, fs::directory_options::skip_permission_denied), end;
         at != end; ++at) {
      const fs::path& file = at->path();
      if (at->is_directory() && file.filename().string().starts_with('.')) at.disable_recursion_pending();
      if (at->is_regular_file() && may_be_shader(file)) found.push_back(file.lexically_normal().string());
    }
    if (found.empty())
      throw InputError(path + ": holds no shader; shaders have the suffixes " + io::joined(suffixes));
    std::ranges::sort(found);
    for (const std::string& file : found) add(file);
  }
  return files;
}

// Judges one file. A file that cannot be judged has a finding that says why.
std::vector<Finding> findings_of(const std::string& file, const CheckShaderCall& o,
                                 const validate::CheckOptions& options) {
  Finding readable{.subject = file, .check = std::string(validate::kReadable)};
  std::vector<Finding> findings;
  try {
    ShaderOptions choice{.file = file};
    choice.defines = o.defines;
    choice.include_folders = o.include_folders;
    choice.textures = o.textures;
    choice.shares_textures = true;
    const auto shader = load(choice, "check-shader", true);
    readable.statement = "read as a reflectance";
    findings = validate::run_checks({subject_of(*shader, file)}, options);
  } catch (const InputError& error) {
    readable.outcome = Outcome::fail;
    readable.statement = error.what();
  }
  findings.insert(findings.begin(), readable);
  return findings;
}

void print_file(const std::string& file, const std::vector<Finding>& findings,
                const validate::Baseline& accepted) {
  PlainText out(TextStream::out);
  out << file << ": " << validate::summary(findings) << '\n';
  for (const Finding& f : findings) {
    if (f.outcome != Outcome::fail && f.outcome != Outcome::undecided) continue;
    const char* const kind = f.outcome == Outcome::undecided ? "undecided"
                             : accepted.accepts(f)           ? "accepted"
                                                             : "new";
    out << "  " << kind << "  " << f.check << ": " << f.statement << '\n';
    if (validate::is_new(f, accepted) && f.witness && !f.witness->command.empty())
      out << "    $ " << f.witness->command << '\n';
  }
}

io::Json to_json(const std::vector<Finding>& findings, const validate::Baseline& accepted,
                 const std::vector<validate::Baseline::Entry>& obsolete) {
  io::Json rows = io::Json::array(), gone = io::Json::array();
  for (const Finding& f : findings) {
    rows.push_back(validate::to_json(f));
    rows.back()["new"] = validate::is_new(f, accepted);
  }
  for (const auto& [file, check] : obsolete) gone.push_back({{"file", file}, {"check", check}});
  return {{"findings", rows}, {"no_longer", gone}};
}

void write_reports(const CheckShaderCall& o, const std::vector<Finding>& findings,
                   const validate::Baseline& accepted) {
  if (!o.junit.empty()) io::write_file_atomically(o.junit, validate::to_junit(findings, accepted));
  if (!o.sarif.empty())
    io::write_file_atomically(o.sarif, io::to_text(validate::to_sarif(findings, accepted)));
}

validate::Baseline accepted_in(const CheckShaderCall& o) {
  if (o.update && o.baseline.empty())
    throw InputError("--update-baseline: needs --baseline FILE, which it writes");
  std::error_code ignored;
  if (o.baseline.empty() || (o.update && !fs::exists(o.baseline, ignored))) return {};
  return validate::Baseline(
      io::read_json(o.update ? io::read_result(o.baseline) : io::read_content(o.baseline)), o.baseline);
}

Exit run_check_shader(const CheckShaderCall& o) {
  const validate::Baseline before = accepted_in(o);
  const std::vector<std::string> files = shader_files(o.paths);
  std::vector<io::Target> targets{{"--junit", o.junit}, {"--sarif", o.sarif}};
  if (o.update) targets.push_back({"--baseline", o.baseline});
  io::check_targets(targets, {files.begin(), files.end()});
  validate::CheckOptions options;
  options.effort = o.effort == "full" ? validate::Effort::full : validate::Effort::quick;
  options.seed = o.seed;
  options.seconds = o.seconds / double(validate::check_names().size());
  const auto progress = progress_line("brdf check-shader: files");
  std::vector<Finding> findings;
  watch_for_interrupt();
  for (std::size_t k = 0; k < files.size(); ++k) {
    if (was_interrupted())
      throw InputError("interrupted: " + io::plural(files.size() - k, "file") +
                       " not judged, and no report is written");
    progress(int(k), int(files.size()));
    const std::vector<Finding> own = findings_of(files[k], o, options);
    erase_progress();
    if (!o.json) print_file(files[k], own, o.update ? before.updated(own) : before);
    findings.insert(findings.end(), own.begin(), own.end());
  }
  progress(int(files.size()), int(files.size()));
  const validate::Baseline accepted = o.update ? before.updated(findings) : before;
  const std::vector<validate::Baseline::Entry> obsolete = before.obsolete(findings);
  write_reports(o, findings, accepted);
  if (o.update) io::write_file_atomically(o.baseline, io::to_text(accepted.to_json()));
  const auto fresh =
      std::ranges::count_if(findings, [&](const Finding& f) { return validate::is_new(f, accepted); });
  if (o.json) {
    std::cout << io::to_text(to_json(findings, accepted, obsolete)) << '\n';
  } else {
    PlainText out(TextStream::out);
    if (!o.update)
      for (const auto& [file, check] : obsolete)
        out << "no longer fails: " << file << ", " << check << "; --update-baseline removes it from "
            << o.baseline << '\n';
    out << io::plural(files.size(), "file") << ", " << io::plural(std::size_t(fresh), "new finding") << '\n';
  }
  return fresh == 0 ? Exit::good : Exit::failed;
}

}  // namespace

void add_check_shader(CLI::App& app) {
  auto o = std::make_shared<CheckShaderCall>();
  CLI::App* verb = add_verb(app, Purpose::judge, "check-shader",
                            "Judge all shaders of a project, for continuous integration");
  verb->add_option("PATHS", o->paths, "Folders of shaders, searched with their own folders, or files")
      ->required();
  verb->add_option("--baseline", o->baseline,
                   "File of accepted findings: only findings that it does not hold fail the run");
  verb->add_flag(
      "--update-baseline", o->update,
      "Accept the findings of this run: write them to --baseline, which keeps the entries of other files");
  verb->add_option("--junit", o->junit, "Results to write as JUnit's XML");
  verb->add_option("--sarif", o->sarif, "Findings to write as SARIF 2.1.0");
  add_repeated_option(*verb, "--define", o->defines, "A macro that is defined in all files, NAME=VALUE");
  add_repeated_option(*verb, "-I,--include-folder", o->include_folders,
                      "A folder for included files, searched after each file's own folder");
  add_repeated_option(*verb, "--texture", o->textures,
                      "A texture's file for every shader with a texture of this name, NAME=FILE.exr, then "
                      ":nearest or :bilinear, and :repeat, :clamp or :mirror");
  verb->add_option("--effort", o->effort, "Effort of the search for the worst case")
      ->check(CLI::IsMember({"quick", "full"}))
      ->capture_default_str();
  verb->add_option(
          "--seconds", o->seconds,
          "Longest time of each file in seconds, in equal parts for its checks; an unfinished check is "
          "undecided")
      ->check(CLI::NonNegativeNumber);
  verb->add_option("--seed", o->seed, "Seed of the search")->capture_default_str();
  verb->add_flag("--json", o->json, "Findings as JSON on stdout");
  verb->footer(
      "A file that cannot be read as a reflectance has the finding readable. Exit code 1 if a finding is "
      "new.\n"
      "Examples: brdf check-shader shaders/ --baseline accepted.json --update-baseline\n"
      "          brdf check-shader shaders/ --baseline accepted.json --junit shaders.xml --sarif "
      "shaders.sarif\n"
      "          brdf check-shader shaders/ extra.hlsl --define QUALITY=2 -I engine/include --seconds 60\n"
      "          brdf check-shader shaders/ --texture albedoMap=grey.exr:nearest\n"
      "          brdf check-shader shaders/ --effort full --seed 2 --json");
  on_run(*verb, [o] { return run_check_shader(*o); });
}

}  // namespace brdf::cli
