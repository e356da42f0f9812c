#include "io/page/html_report.h"

#include <algorithm>
#include <stdexcept>

#include "io/page/chart.h"
#include "io/page/html_files.h"
#include "io/page/html_markup.h"

namespace brdf::io {
namespace {

std::string chart_library() {
  std::string text = chart_text();
  // Remove the scheme of the addresses in the licence comments. A report refers to nothing outside the
  // file, and a search for addresses can then prove it.
  constexpr std::string_view kScheme = "https://";
  for (std::size_t comment = 0; (comment = text.find("/*!", comment)) != text.npos; ++comment)
    for (std::size_t at; (at = text.find(kScheme, comment)) < text.find("*/", comment);)
      text.erase(at, kScheme.size());
  return text;
}

// The picture of a figure and the canvas that takes its place.
std::string turning(const Figure& figure) {
  return "<canvas tabindex=\"0\" role=\"application\" aria-label=\"" + html_escaped(figure.title) +
         ". Arrow keys turn the body, Home resets it.\"></canvas>" + image(figure.png, figure.title) +
         "<script type=\"application/json\">" + within_script(body_json(*figure.body)) + "</script>";
}

}  // namespace

void HtmlReport::heading(std::string_view text) {
  body_ += "<h2>" + html_escaped(text) + "</h2>\n";
}

void HtmlReport::subheading(std::string_view text) {
  body_ += "<h3>" + term(text) + "</h3>\n";
}

void HtmlReport::paragraph(std::string_view text) {
  body_ += "<p>" + running_text(text) + "</p>\n";
}

void HtmlReport::facts(const std::vector<Fact>& facts) {
  body_ += "<ul class=\"facts\">\n";
  for (const Fact& fact : facts) {
    const std::string value = fact.value.empty() ? "<i>not stated</i>" : html_escaped(fact.value);
    body_ += "<li>" + (fact.name.empty() ? "" : html_escaped(fact.name) + ": ") +
             (fact.value.empty() ? value : "<b>" + value + "</b>") + "</li>\n";
  }
  body_ += "</ul>\n";
}

void HtmlReport::verdict(Mark mark, std::string_view text) {
  body_ += "<p class=\"verdict" + after_space(css_class(mark)) + "\">" + running_text(text) + "</p>\n";
}

void HtmlReport::remarks(const std::vector<Remark>& remarks) {
  if (remarks.empty()) return;
  body_ += "<ul class=\"remarks\">\n";
  for (const Remark& r : remarks) body_ += "<li" + class_of(r.mark) + ">" + running_text(r.text) + "</li>\n";
  body_ += "</ul>\n";
}

void HtmlReport::picture(std::string_view png, std::string_view caption, std::string_view made_by) {
  body_ += "<figure>" + image(png, caption) + "<figcaption>" + running_text(caption) + "</figcaption>";
  command(made_by);
  body_ += "</figure>\n";
}

void HtmlReport::pictures(const std::vector<Figure>& row) {
  body_ += "<div class=\"row\">\n";
  for (const Figure& f : row) {
    const std::string shown = f.body ? turning(f) : image(f.png, f.title), title = html_escaped(f.title);
    body_ += (f.body ? "<figure class=\"body\">" : "<figure>") + linked(f.link, shown) +
             "<p class=\"title\">" + linked(f.link, title) + "</p>";
    if (!f.text.empty())
      body_ += "<figcaption" + class_of(f.mark) + ">" + running_text(f.text) + "</figcaption>";
    command(f.command);
    body_ += "</figure>\n";
  }
  body_ += "</div>\n";
  if (std::ranges::any_of(row, [](const Figure& f) { return f.body.has_value(); })) script(kBodyScript);
}

void HtmlReport::command(std::string_view text) {
  if (!text.empty())
    body_ += "<details class=\"commands\"><summary>command</summary><pre>" + html_escaped(text) +
             "</pre></details>\n";
}

void HtmlReport::begin_fold(std::string_view summary, Paper paper) {
  ++open_folds_;
  body_ += std::string("<details class=\"part") + (paper == Paper::left_out ? " screen" : "") +
           "\"><summary>" + html_escaped(summary) + "</summary>\n";
}

void HtmlReport::end_fold() {
  if (open_folds_ == 0) throw std::logic_error("a report ends a fold that was not begun");
  --open_folds_;
  body_ += "</details>\n";
}

void HtmlReport::raw(std::string_view html) {
  body_ += html;
  body_ += '\n';
}

void HtmlReport::style(std::string_view css) {
  if (style_.find(css) == style_.npos) style_ += std::string(css) + '\n';
}

void HtmlReport::script(std::string_view js) {
  if (script_.find(js) == script_.npos) script_ += std::string(js) + '\n';
}

void HtmlReport::footnote(std::string_view key, std::string_view text) {
  footer_ += html_escaped(key) + ": <code>" + html_escaped(text) + "</code><br>";
}

std::string HtmlReport::document(const Provenance& made) const {
  if (open_folds_ != 0) throw std::logic_error("a fold of a report was not ended");
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
      html_escaped(title_) + "</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>" + kPageStyle +
      mark_style() + style_ + "</style></head>\n<body>\n<main>\n<h1>" + html_escaped(title_) + "</h1>\n" +
      body_;
  append_terms(html);
  html += "</main>\n<footer>" + mark_legend() + "<p>" + footer_;
  for (const auto& [key, value] : provenance_fields(made))
    html += html_escaped(key) + ": <code>" + html_escaped(value) + "</code>" +
            // A page has the same bytes wherever it is written (io/files/provenance.h).
            (key == "command" ? " (without the place of the output and the number of jobs)" : "") + "<br>";
  html += "</p></footer>\n<script>\n" + std::string(kPageScript) + "</script>\n";
  if (!plots_.empty())
    html += "<script>" + chart_library() + "</script>\n<script>\nconst plots = [\n" + within_script(plots_) +
            "\n];\n" + kChartScript + "</script>\n";
  if (!script_.empty()) html += "<script>\n" + script_ + "</script>\n";
  return html + "</body></html>\n";
}

}  // namespace brdf::io
