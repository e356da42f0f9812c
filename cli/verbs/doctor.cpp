#include <unistd.h>
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <tuple>

#include "cli/options/terminal.h"
#include "cli/verb.h"
#include "io/files/error.h"
#include "io/files/provenance.h"
#include "io/material/info_json.h"
#include "io/page/chart.h"
#ifdef BRDF_HAS_RENDER
#include "render/text/font.h"
#include "render/vulkan/device.h"
#endif
#ifdef BRDF_HAS_VIEWER
#include "render/viewer/window.h"
#endif

namespace brdf::cli {
namespace {

// A thing of the environment, and the verbs that need it.
struct Part {
  std::string name, enables;
  bool is_there = false;
  std::string found = {};  // a phrase: the thing that was found, or the reason why it was not
  std::string remedy = {};
};

[[maybe_unused]] constexpr const char* kOwnBuild = "build it with all packages of tools/setup build";

// Calls `look`, which returns a phrase on the thing that it found, and reports its absence by an exception.
template <class Look>
Part part(std::string name, std::string enables, std::string remedy, const Look& look) {
  Part out{std::move(name), std::move(enables)};
  try {
    out.found = look();
    out.is_there = true;
  } catch (const std::exception& error) {
    out.found = error.what();
    out.remedy = std::move(remedy);
  }
  return out;
}

// Returns the path of a program that the shell would start. The program is not started.
std::string in_path(const std::string& program) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path file = std::filesystem::path(folder.empty() ? "." : folder) / program;
    std::error_code ignored;
    if (std::filesystem::is_regular_file(file, ignored) && access(file.c_str(), X_OK) == 0)
      return file.string() + ", which was not started";
  }
  throw EnvironmentError("no program " + program + " in PATH");
}

std::vector<Part> parts() {
  std::vector<Part> out;
#ifdef BRDF_HAS_RENDER
  out.push_back(part("Vulkan driver", "render, lobes, parity, validate --gpu, view",
                     "install a driver; mesa-vulkan-drivers has one without hardware",
                     [] { return render::Device().name(); }));
  out.push_back(part("Vulkan doubles", "synth --gpu",
                     "install a driver that computes in double; mesa-vulkan-drivers has one without hardware",
                     [] { return render::Device({.doubles = true}).name(); }));
  out.push_back(part("fonts", "labels in pictures of render, and view", "install fonts-dejavu-core", [] {
    render::Font plain(render::Font::plain()), bold(render::Font::bold());
    return render::Font::plain().string();
  }));
#else
  for (const auto& [name, enables] :
       {std::pair{"Vulkan driver", "render, lobes, parity, validate --gpu, view"},
        {"Vulkan doubles", "synth --gpu"}})
    out.push_back({name, enables, false, "this program was built without the renderer", kOwnBuild});
#endif
#ifdef BRDF_HAS_VIEWER
  out.push_back(part("display", "windows of view; view --screenshot works without one",
                     "log in on a desktop, or start the command by xvfb-run", [] {
                       render::Window window(64, 64, "brdf doctor");
                       return std::string("a window was opened and closed");
                     }));
#else
  out.push_back(
      {"display", "windows of view", false, "this program was built without the viewer", kOwnBuild});
#endif
  out.push_back(part("Chart.js", "HTML reports of study, fit, validate and trade", "install libjs-chart.js",
                     [] { return io::chart_file_for_reports().string(); }));
#ifdef BRDF_HAS_SHADER
  out.push_back({"shader compiler", "--shader and check-shader", true, "part of this program"});
#else
  out.push_back({"shader compiler", "--shader and check-shader", false,
                 "this program was built without a compiler of shaders", kOwnBuild});
#endif
  for (const auto& [name, enables, program, package] :
       {std::tuple{"Blender", "scripts of export --to blender", "blender", "blender"},
        {"GNU parallel", "units of plan on several cores or hosts", "parallel", "parallel"},
        {"Slurm", "units of plan on a cluster, by brdf-array.sbatch", "sbatch", "slurm-client"}})
    out.push_back(part(name, enables, std::string("install ") + package, [&] { return in_path(program); }));
  return out;
}

void print(const std::vector<Part>& parts) {
  PlainText out;
  out << "brdf " << io::provenance().version << '\n';
  for (const Part& p : parts) {
    out << "  " << std::left << std::setw(16) << p.name << (p.is_there ? "found    " : "missing  ") << p.found
        << "\n      enables: " << p.enables << '\n';
    if (!p.remedy.empty()) out << "      remedy: " << p.remedy << '\n';
  }
}

void print_json(const std::vector<Part>& parts) {
  io::Json list = io::Json::array();
  for (const Part& p : parts) {
    io::Json row{{"name", p.name}, {"found", p.is_there}, {"detail", p.found}, {"enables", p.enables}};
    if (!p.remedy.empty()) row["remedy"] = p.remedy;
    list.push_back(std::move(row));
  }
  std::cout << io::to_text(io::Json{{"parts", list}, {"provenance", io::to_json(io::provenance())}});
}

}  // namespace

void add_doctor(CLI::App& app) {
  auto json = std::make_shared<bool>(false);
  CLI::App* verb = add_verb(app, Purpose::begin, "doctor",
                            "Look which parts of the environment are there, and what they enable");
  verb->add_flag("--json", *json, "JSON on stdout");
  verb->footer(
      "Creates a Vulkan device and opens a window for a moment; other programs are searched in PATH and not\n"
      "started. A missing part is no failure: fits, checks, proofs and exports need none of them.\n"
      "Examples: brdf doctor\n"
      "          brdf doctor --json");
  on_run(*verb, [json] {
    const std::vector<Part> found = parts();
    *json ? print_json(found) : print(found);
    return Exit::good;
  });
}

}  // namespace brdf::cli
