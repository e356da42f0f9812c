// Tables of a report, and terms that explain themselves.
#include <algorithm>
#include <cctype>

#include "io/files/text.h"
#include "io/page/glossary.h"
#include "io/page/html_markup.h"
#include "io/page/html_report.h"

namespace brdf::io {
namespace {

constexpr std::size_t kMostColumns = 8;  // of a matrix

bool is_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

// Returns the CSS class of a cell. Short text that begins with a number stays on one line ("22.1 %"); a
// sentence gets more room.
const char* css_class(const Cell& cell) {
  constexpr std::size_t kShort = 24, kSentence = 40;
  double value;
  const std::string_view first = std::string_view(cell.text).substr(0, cell.text.find(' '));
  if (cell.text.size() <= kShort && parse_number(first, value)) return "number";
  return cell.text.size() + cell.note.size() > kSentence ? "long" : "";
}

bool applies(const Matrix::Property& row) {
  return std::ranges::any_of(row.cells, [](const Cell& c) { return c.mark != Mark::absent; });
}

// Exchanges rows and columns: a row per subject, a column per property.
std::vector<Matrix::Property> turned(const Matrix& m, const std::vector<Matrix::Property>& rows) {
  std::vector<Matrix::Property> out;
  for (std::size_t s = 0; s < m.subjects.size(); ++s) {
    out.push_back({m.subjects[s], {}});
    for (const Matrix::Property& row : rows) out.back().cells.push_back(row.cells[s]);
  }
  return out;
}

}  // namespace

void HtmlReport::explain(std::string term, std::string meaning) {
  own_terms_.emplace_back(std::move(term), std::move(meaning));
}

const std::string* HtmlReport::meaning(std::string_view word) const {
  for (auto own = own_terms_.rbegin(); own != own_terms_.rend(); ++own)
    if (own->first == word) return &own->second;
  const GlossaryTerm* found = glossary_term(word);
  return found ? &found->meaning : nullptr;
}

std::string HtmlReport::term(std::string_view word) {
  const std::string* const found = meaning(word);
  if (!found) return html_escaped(word);
  auto at = std::ranges::find_if(used_terms_, [&](const auto& t) { return t.first == word; });
  if (at == used_terms_.end()) at = used_terms_.insert(at, {std::string(word), *found});
  const std::string number = std::to_string(at - used_terms_.begin());
  return "<button type=\"button\" class=\"term\" popovertarget=\"term" + number + "\" title=\"" +
         html_escaped(*found) + "\">" + html_escaped(word) + "</button>";
}

std::string HtmlReport::running_text(std::string_view text) {
  std::string html;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && is_of_word(text[end])) ++end;
    if (end == at) ++end;
    const std::string_view word = text.substr(at, end - at);
    const GlossaryTerm* found = glossary_term(word);
    const bool symbol = found ? found->in_text : false;
    const bool first = symbol && !met_.contains(word);
    if (first && open_folds_ == 0) met_.insert(std::string(word));
    html += first ? term(word) : html_escaped(word);
    at = end;
  }
  return html;
}

std::string HtmlReport::cell_of(const Cell& cell, bool fold_note) {
  std::string text;
  if (cell.code && !cell.text.empty())
    text = "<code>" + html_escaped(cell.text) + "</code>";
  else if (!cell.text.empty())
    text = cell.link.empty() ? running_text(cell.text) : linked(cell.link, html_escaped(cell.text));
  if (!cell.png.empty())
    text = linked(cell.link, image(cell.png, cell.alt.empty() ? cell.text : cell.alt)) + text;
  if (!cell.picture_file.empty())
    text = linked(cell.link, "<img loading=\"lazy\" alt=\"" + html_escaped(cell.alt) + "\" src=\"" +
                                 html_escaped(cell.picture_file) + "\">") +
           text;
  const bool fold = fold_note && !cell.note.empty() && cell.mark != Mark::warn && cell.mark != Mark::bad;
  const std::string said = fold ? html_escaped(cell.note) : running_text(cell.note);
  const std::string note = said.empty() ? "" : "<span class=\"note\">" + said + "</span>";
  const std::string_view mark = fold ? "" : css_class(cell.mark), kind = css_class(cell);
  const std::string classes = std::string(mark) + (mark.empty() ? std::string(kind) : after_space(kind));
  if (fold)
    text = "<details><summary><span" + class_of(cell.mark) + ">" + text + "</span></summary>" + note +
           "</details>";
  else
    text += note;
  if (!cell.command.empty())
    text += "<details class=\"commands\"><summary>command</summary><pre>" + html_escaped(cell.command) +
            "</pre></details>";
  return "<td" + (classes.empty() ? "" : " class=\"" + classes + "\"") +
         (cell.sorted_by ? " data-value=\"" + to_text(*cell.sorted_by) + "\"" : "") + ">" + text + "</td>";
}

void HtmlReport::table(const std::vector<std::string>& header, const std::vector<Row>& rows, bool sortable) {
  body_ += std::string("<div class=\"scroll\"><table") + (sortable ? " class=\"sortable\"" : "") + ">";
  if (!header.empty()) body_ += "<thead><tr>";
  // An empty heading would be read aloud as a heading.
  for (const std::string& h : header) body_ += h.empty() ? "<td></td>" : "<th>" + term(h) + "</th>";
  body_ += std::string(header.empty() ? "" : "</tr></thead>") + "<tbody>\n";
  for (const Row& row : rows) {
    body_ += "<tr>";
    for (const Cell& cell : row) body_ += cell_of(cell);
    body_ += "</tr>\n";
  }
  body_ += "</tbody></table></div>\n";
}

void HtmlReport::append_matrix(const std::string& corner, const std::vector<std::string>& columns,
                               const std::vector<Matrix::Property>& rows, bool fold_notes) {
  body_ += "<div class=\"scroll\"><table class=\"matrix\"><thead><tr>" +
           (corner.empty() ? "<td></td>" : "<th>" + term(corner) + "</th>");
  for (const std::string& column : columns) body_ += "<th>" + term(column) + "</th>";
  body_ += "</tr></thead><tbody>\n";
  for (const Matrix::Property& row : rows) {
    body_ += "<tr><th scope=\"row\">" + term(row.name) + "</th>";
    for (const Cell& cell : row.cells) body_ += cell_of(cell, fold_notes);
    body_ += "</tr>\n";
  }
  body_ += "</tbody></table></div>\n";
}

void HtmlReport::matrix(const Matrix& m) {
  std::vector<Matrix::Property> apply, rest;
  for (const Matrix::Property& row : m.rows) (applies(row) ? apply : rest).push_back(row);
  const auto append = [&](const std::vector<Matrix::Property>& rows) {
    if (m.subjects.size() <= kMostColumns)
      return append_matrix(m.properties, m.subjects, rows, m.fold_notes && m.subjects.size() > 2);
    std::vector<std::string> names;
    for (const Matrix::Property& row : rows) names.push_back(row.name);
    append_matrix("", names, turned(m, rows), m.fold_notes);
  };
  if (!apply.empty()) append(apply);
  if (rest.empty()) return;
  begin_fold("not applicable: " + std::to_string(rest.size()), Paper::left_out);
  append(rest);
  end_fold();
}

void HtmlReport::append_terms(std::string& html) const {
  if (used_terms_.empty()) return;
  for (std::size_t k = 0; k < used_terms_.size(); ++k)
    html += "<div popover id=\"term" + std::to_string(k) + "\"><strong>" +
            html_escaped(used_terms_[k].first) + "</strong>: " + html_escaped(used_terms_[k].second) +
            "</div>\n";
  html += "<details class=\"part screen\"><summary>Glossary</summary><dl>\n";
  for (const auto& [word, meaning] : used_terms_)
    html += "<dt>" + html_escaped(word) + "</dt><dd>" + html_escaped(meaning) + "</dd>\n";
  html += "</dl></details>\n";
}

}  // namespace brdf::io
