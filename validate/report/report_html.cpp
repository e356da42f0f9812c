#include <algorithm>
#include <array>
#include <set>

#include "io/files/numbers.h"
#include "io/page/glossary.h"
#include "io/page/sphere/page.h"
#include "validate/report/report.h"
#include "validate/report/report_plots.h"

namespace brdf::validate {
namespace {

io::Mark mark_of(Outcome outcome) {
  constexpr std::array marks{io::Mark::good, io::Mark::warn, io::Mark::bad, io::Mark::absent, io::Mark::warn};
  return marks[std::size_t(outcome)];
}

io::Mark mark_of(const std::vector<Finding>& findings) {
  io::Mark mark = io::Mark::good;
  for (const Finding& f : findings)
    if (f.outcome != Outcome::not_applicable) mark = std::max(mark, mark_of(f.outcome));
  return mark;
}

std::vector<Finding> findings_of(const std::vector<Finding>& all, const std::string& subject) {
  std::vector<Finding> own;
  std::copy_if(all.begin(), all.end(), std::back_inserter(own),
               [&](const Finding& f) { return f.subject == subject; });
  return own;
}

// Returns "copper" for "/data/copper.material.json" and for "copper.png".
std::string stem(const std::string& path) {
  const std::string name = io::file_name(path);
  return name.substr(0, name.find('.', 1));
}

// Describes the model: "cook_torrance, surface roughness 0.2".
std::string model_text(const Material& m) {
  std::vector<std::string> words;
  for (const Term& term : m.terms) {
    const ReflectanceInfo& form = info(term.form);
    words.emplace_back(form.name);
    const auto [along, across] = form.axes();
    for (std::size_t k = 0; k < form.shape.size(); ++k) {
      const bool one =
          across >= 0 && term.shape.front()[std::size_t(along)] == term.shape.front()[std::size_t(across)];
      if (one && int(k) == across) continue;
      const std::string name = int(k) == across ? "across" : io::plain_name(form, form.shape[k], one);
      words.push_back(name + " " + io::short_number(term.shape.front()[k], 2));
    }
  }
  return io::joined(words);
}

// Lists the properties that fail or are known to be violated, or reports that no violation was found.
std::string state_text(const std::vector<Finding>& findings) {
  std::vector<std::string> failed, known;
  for (const Finding& f : findings) {
    if (f.outcome == Outcome::fail) failed.push_back(f.check);
    if (f.outcome == Outcome::known_violation) known.push_back(f.check);
  }
  if (failed.empty() && known.empty()) return "no violation found";
  std::string text = failed.empty() ? "" : "fails: " + io::joined(failed);
  if (!known.empty())
    text += (text.empty() ? "known to violate: " : "; known to violate: ") + io::joined(known);
  return text;
}

// Each picture's line describes the subject whose file has the same name.
void add_pictures(io::HtmlReport& report, const ReportContent& content) {
  std::vector<io::Figure> row;
  for (const Picture& p : content.pictures) {
    io::Figure figure{p.png, stem(p.name)};
    for (const Subject& s : content.subjects)
      if (stem(s.name()) == figure.title) {
        const std::vector<Finding> own = findings_of(content.findings, s.name());
        const auto fit = content.fits.find(s.name());
        figure.text = model_text(s.own()) + (fit == content.fits.end() ? "" : "; " + fit->second) + "; " +
                      state_text(own);
        figure.mark = mark_of(own);
        break;
      }
    row.push_back(std::move(figure));
  }
  if (!row.empty()) report.pictures(row);
}

std::string title_of(const ReportContent& content) {
  const std::size_t count = content.subjects.size() + content.tables.size();
  if (count > 1) return std::to_string(count) + " subjects";
  if (!content.tables.empty()) return io::file_name(content.tables.front().table.source);
  if (!content.subjects.empty()) return io::file_name(content.subjects.front().name());
  // Findings of functions come without a subject that could be drawn.
  return content.findings.empty() ? "0 subjects" : content.findings.front().subject;
}

// Adds one sphere per subject. A page with many subjects has no spheres, since each one adds a shader and a
// picture.
void add_spheres(io::HtmlReport& report, const ReportContent& content) {
  constexpr std::size_t kMost = 6;
  if (content.subjects.size() > kMost) return;
  report.raw("<div class=\"row\">");
  for (const Subject& s : content.subjects)
    if (const Material m = s.own(); io::sphere::obstacle(m).empty())
      io::sphere::add(report, {.title = io::file_name(s.name()), .fitted = m});
  report.raw("</div>");
}

}  // namespace

std::string_view check_meaning(std::string_view check) {
  const auto* const found = std::ranges::find(kChecks, check, &Check::name);
  return found == std::end(kChecks) ? sheet::check_meaning(check) : found->meaning;
}

void add_properties(io::HtmlReport& report, const std::vector<Finding>& findings) {
  io::Matrix matrix{.properties = "", .subjects = {}, .rows = {}};
  std::vector<std::string> names;
  for (const Finding& f : findings)
    if (std::ranges::find(names, f.subject) == names.end()) names.push_back(f.subject);
  std::multiset<std::string> files;
  for (const std::string& name : names) files.insert(io::file_name(name));
  for (const std::string& name : names)
    matrix.subjects.push_back(files.count(io::file_name(name)) > 1 ? name : io::file_name(name));
  for (const Finding& f : findings) {
    report.explain(f.check, std::string(check_meaning(f.check)));
    auto row = std::ranges::find(matrix.rows, f.check, &io::Matrix::Property::name);
    if (row == matrix.rows.end())
      row = matrix.rows.insert(row, {f.check, io::Row(names.size(), {.text = "", .mark = io::Mark::absent})});
    std::string outcome(name_of(f.outcome));
    std::ranges::replace(outcome, '_', ' ');
    row->cells[std::size_t(std::ranges::find(names, f.subject) - names.begin())] = {
        .text = outcome,
        .mark = mark_of(f.outcome),
        .command = shows_witness(f) ? f.witness->command : "",
        .note = said(f)};
  }
  report.matrix(matrix);
}

std::string to_html(const ReportContent& content) {
  io::HtmlReport report("Validation of " + title_of(content));
  report.verdict(mark_of(content.findings), summary(content.findings));
  add_pictures(report, content);
  add_spheres(report, content);
  std::vector<Finding> of_subjects, of_tables = content.findings;
  if (content.subjects.empty() && content.tables.empty()) of_subjects.swap(of_tables);
  for (const Subject& subject : content.subjects) {
    const std::vector<Finding> own = findings_of(content.findings, subject.name());
    of_subjects.insert(of_subjects.end(), own.begin(), own.end());
    std::erase_if(of_tables, [&](const Finding& f) { return f.subject == subject.name(); });
    if (!subject.of_form()) report.footnote("material", subject.name());
  }
  if (!of_subjects.empty()) report.heading("Properties");
  add_properties(report, of_subjects);
  if (!of_tables.empty()) report.heading("Data check of the measurements");
  add_properties(report, of_tables);
  for (const MeasuredTable& measured : content.tables) {
    report.heading(io::file_name(measured.table.source));
    sheet::add_to_report(report, measured.table, measured.sheet);
    report.footnote("samples", measured.table.source);
  }
  const double reach = lobe_reach(content.subjects);
  constexpr std::size_t kOpen = 2;  // with more subjects the plots are folded
  for (const Subject& subject : content.subjects) {
    if (content.subjects.size() > kOpen)
      report.begin_fold("Plots of " + io::file_name(subject.name()));
    else
      report.heading(io::file_name(subject.name()));
    add_subject_plots(report, subject, content.findings, content.max_theta, reach);
    if (content.subjects.size() > kOpen) report.end_fold();
  }
  return report.document(io::provenance());
}

}  // namespace brdf::validate
