// ctest: style.model_docs label=style @build@/docs/model_docs --check
// Writes docs/models.md and docs/models/<form>.svg from the catalogue, the headers' comments and
// measurements. With --check, writes nothing and fails if a file is not current.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

#include "brdf/material.h"
#include "brdf/trace.h"
#include "io/files/numbers.h"

namespace {

using namespace brdf;
namespace fs = std::filesystem;

const fs::path kSource = BRDF_SOURCE_DIR;

std::string read(const fs::path& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string number(double x) {
  return io::short_number(x, 6);
}

std::string formatted(const char* format, double x) {
  char text[32];
  std::snprintf(text, sizeof text, format, x);
  return text;
}
// Returns x with the decimals that a picture needs.
std::string pixels(double x) {
  return formatted("%.1f", x);
}

// Returns the comment above `struct <form>` in one of the forms' headers.
std::string comment_of(const ReflectanceInfo& form) {
  for (const auto& header : fs::directory_iterator(kSource / "libbrdf/brdf/forms")) {
    std::istringstream in(read(header.path()));
    std::string comment;
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with("struct " + std::string(form.name) + " ")) return comment;
      if (line.starts_with("//"))
        comment += (line.size() > 3 ? line.substr(3) : "") + "\n";
      else
        comment.clear();
    }
  }
  throw std::runtime_error("no comment above " + std::string(form.name));
}

void add_parameters(std::string& text, std::span<const ParameterInfo> table, const char* kind) {
  for (const ParameterInfo& p : table)
    text += "| `" + std::string(p.name) + "` | " + kind + " | " + number(p.min) + " .. " + number(p.max) +
            " | " + number(p.initial) + " | " + std::string(p.unit) + " | " + std::string(p.doc) + " |\n";
}

// Returns the operations of the generated shader function for one RGB value of f, as a device executes them.
std::string cost_of(const Reflectance& form) {
  const std::string glsl = form->glsl();
  const std::string eval_only = glsl.substr(0, glsl.find("vec3 brdf_eval_cos_"));
  const auto count = [&](std::string_view pattern) {
    int n = 0;
    for (std::size_t at = 0; (at = eval_only.find(pattern, at)) != std::string::npos; ++at) ++n;
    return n;
  };
  std::string text = std::to_string(count(" = ")) + " operations";
  const std::vector<std::pair<int, const char*>> kinds{
      {count(" / "), "divisions"},          {count("sqrt("), "square roots"},
      {count("brdf_exp("), "exponentials"}, {count("brdf_log(") + count("brdf_log1p("), "logarithms"},
      {count("brdf_erfcx("), "erfcx"},      {count("brdf_angle("), "arc tangents"}};
  for (const auto& [n, name] : kinds)
    if (n > 0) text += ", " + std::to_string(n) + " " + name;
  return text;
}

std::string section_of(const Reflectance& form) {
  const ReflectanceInfo& f = info(form);
  const std::string name(f.name);
  std::string text = "### `" + name + "`\n\n![lobe of " + name + "](models/" + name + ".svg)\n\n```text\n" +
                     comment_of(f) +
                     "```\n\n| parameter | kind | range | default | unit | |\n|---|---|---|---|---|---|\n";
  add_parameters(text, f.weights, "weight");
  add_parameters(text, f.shape, "shape");
  text += "\nFittable: " + std::string(f.fittable() ? "yes" : "no") + ". Cost: " + cost_of(form) + ".\n";
  if (!f.violations.empty()) {
    text += "\n| known violation | | at | angle | value |\n|---|---|---|---|---|\n";
    for (const Violation& v : f.violations)
      text += "| " + std::string(v.check) + " | " + std::string(v.statement) + " | `" +
              std::string(v.witness) + "` | " + number(v.theta) + " | " + number(v.value) + " |\n";
  }
  return text + "\n";
}

// The forms that the page covers: all forms or, when checking, the forms that the page already has.
using Forms = std::vector<Reflectance>;

std::string forms_text(const Forms& forms) {
  std::string text;
  for (const Forms& family : families(forms)) {
    text += "## Family " + std::string(info(family.front()).family) + "\n\n";
    for (const Reflectance& form : family) text += section_of(form);
  }
  return text;
}

std::string accuracy_text(const Forms& forms) {
  std::string text =
      "| form | double: body | faint | tail | float: body | faint | tail |\n|---|---|---|---|---|---|---|\n";
  for (const Reflectance& form : forms) {
    text += "| `" + std::string(info(form).name) + "`";
    const Accuracy* stated = info(form).accuracy;
    for (const Accuracy::Errors Accuracy::*scalar : {&Accuracy::in_double, &Accuracy::in_float})
      for (double Accuracy::Errors::*band :
           {&Accuracy::Errors::body, &Accuracy::Errors::faint, &Accuracy::Errors::tail})
        text += !stated                      ? " | not measured"
                : stated->*scalar.*band == 0 ? " | 0"
                                             : " | " + formatted("%.1e", stated->*scalar.*band);
    text += " |\n";
  }
  return text;
}

// --- Pictures: f in the plane of incidence as a polar plot, light at 30 and 70 degrees --------------------

constexpr double kRadius = 130, kCentre = 160, kBase = 150;

std::vector<double> values_in_plane(const Material& material, double theta_i) {
  const Vec3<double> wi = direction(degrees(theta_i), radians(kPi));
  std::vector<double> values;
  for (int k = -89; k <= 89; ++k) {
    double f = 0;
    eval(material, wi, direction(degrees(std::abs(k)), radians(k < 0 ? kPi : 0)), {&f, 1});
    values.push_back(f);
  }
  return values;
}

std::string curve(const std::vector<double>& values, double scale, const char* style) {
  std::string points;
  for (int k = -89; k <= 89; ++k) {
    const double r = kRadius * std::max(0.0, values[std::size_t(k + 89)]) / scale;
    points += pixels(kCentre + r * std::sin(degrees(k).radians())) + "," +
              pixels(kBase - r * std::cos(degrees(k).radians())) + " ";
  }
  return "<polyline fill=\"none\" " + std::string(style) + " points=\"" + points + "\"/>\n";
}

std::string light(double theta_i, const char* colour) {
  return "<line x1=\"" + pixels(kCentre - 1.05 * kRadius * std::sin(degrees(theta_i).radians())) +
         "\" y1=\"" + pixels(kBase - 1.05 * kRadius * std::cos(degrees(theta_i).radians())) + "\" x2=\"" +
         number(kCentre) + "\" y2=\"" + number(kBase) + "\" stroke=\"" + colour +
         "\" stroke-dasharray=\"4 3\"/>\n";
}

std::string picture_of(const Reflectance& form) {
  const Material material = make_material(form, {"y"});
  const auto steep = values_in_plane(material, 30), flat = values_in_plane(material, 70);
  const double scale = std::max(*std::ranges::max_element(steep), *std::ranges::max_element(flat));
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"320\" height=\"180\" font-family=\"sans-serif\" "
         "font-size=\"11\">\n<rect width=\"320\" height=\"180\" fill=\"white\"/>\n"
         "<line x1=\"20\" y1=\"150\" x2=\"300\" y2=\"150\" stroke=\"black\"/>\n" +
         light(30, "#1f77b4") + light(70, "#d62728") +
         curve(steep, scale, "stroke=\"#1f77b4\" stroke-width=\"1.5\"") +
         curve(flat, scale, "stroke=\"#d62728\" stroke-width=\"1.5\"") +
         "<text x=\"20\" y=\"170\">light at 30 (blue) and 70 degrees (red); largest f " +
         io::short_number(scale, 3) + " / sr</text>\n</svg>\n";
}

// --- Files -----------------------------------------------------------------------------------------------

std::map<fs::path, std::string> all_files(const Forms& forms) {
  std::map<fs::path, std::string> files;
  std::string page = read(kSource / "docs/models.in.md");
  const auto put = [&](const std::string& mark, const std::string& text) {
    page.replace(page.find(mark), mark.size(), text);
  };
  put("@ACCURACY@\n", accuracy_text(forms));
  put("@FORMS@\n", forms_text(forms));
  files["docs/models.md"] = page;
  for (const Reflectance& form : forms)
    files["docs/models/" + std::string(info(form).name) + ".svg"] = picture_of(form);
  return files;
}

// Returns the forms that have a section, and prints the names of the others. (A form can be tried before its
// page is written.)
Forms forms_of_page() {
  const std::string page = read(kSource / "docs/models.md");
  Forms forms;
  for (const Reflectance& form : catalogue()) {
    const std::string name(info(form).name);
    if (page.find("### `" + name + "`") != std::string::npos)
      forms.push_back(form);
    else
      std::cout << "not in docs/models.md yet (run model_docs): " << name << '\n';
  }
  return forms;
}

}  // namespace

int main(int argc, char** argv) try {
  const bool check = argc > 1 && std::string(argv[1]) == "--check";
  int outdated = 0;
  const Forms forms = check ? forms_of_page() : Forms(catalogue().begin(), catalogue().end());
  for (const auto& [path, text] : all_files(forms)) {
    const fs::path full = kSource / path;
    if (check) {
      if (fs::exists(full) && read(full) == text) continue;
      std::cerr << path.string() << " is not current: run model_docs\n";
      ++outdated;
    } else {
      fs::create_directories(full.parent_path());
      std::ofstream(full) << text;
    }
  }
  return outdated == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << "model_docs: " << error.what() << '\n';
  return 1;
}
