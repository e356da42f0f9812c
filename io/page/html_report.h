// The template of every report: one HTML file that opens without a network, on a phone, in the dark, by
// keyboard, and prints on paper. docs/validation.md says by what rules a page is told.
//
// A page is written from top to bottom: verdict(), then what a reader asks next. What few ask for goes into a
// fold. Words of the glossary (io/page/glossary.h) explain themselves: every header of a table or axis, and
// in running text where a symbol stands first. Blocks of one's own take their colours from the variables of
// io/page/html_page.css and draw anew at the document's event "scheme".
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brdf/names.h"
#include "io/files/provenance.h"

namespace brdf::io {

// A line of a plot. Points with a value that is not finite (or not positive on a logarithmic axis) are gaps.
struct Series {
  std::string label;  // empty: not in the legend
  std::vector<double> x, y;
  enum class Style { line, dashed, points, faint, faint_points } style = Style::line;
  std::vector<double> low = {}, high = {};  // edges of a band about the line; empty: none
  int colour = -1;                          // of the palette; -1: the next one. Equal ones belong together
  std::vector<std::string> names = {};  // of the points: in the tooltip, and beside those that are not faint
};

// Where a logarithmic axis ends below: what is exact, 0 or nothing but rounding. It is drawn at the bottom
// edge, a decade below all else, with a word in place of a number.
struct BottomEdge {
  std::string label;     // "exact"
  double below = 1e-15;  // values up to this
};

// Drawn by Chart.js, which is embedded in the file. The legend has at most 8 entries; where there are more,
// none is drawn, and names of points or a table must say what is what.
struct Plot {
  std::string title, x_label, y_label;
  std::vector<Series> series;
  bool log_x = false, log_y = false;
  bool equal_axes = false;  // square, both axes alike: polar lobes
  std::string caption;
  std::string command;                      // that prints the same numbers, folded away
  std::optional<BottomEdge> bottom_edge{};  // of a logarithmic y axis
};

// unknown: nothing says whether it is good; absent: does not apply. Each but none has a sign beside its
// colour. In the order of what outweighs what.
enum class Mark { none, good, unknown, warn, bad, absent };

}  // namespace brdf::io

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 6> kNames<io::Mark>{"none", "good", "unknown",
                                                                  "warn", "bad",  "absent"};

}  // namespace brdf

namespace brdf::io {

struct Cell {
  std::string text;
  Mark mark = Mark::none;
  bool code = false;
  std::string command = {};  // folded beneath
  std::string note = {};     // small, beneath; in a matrix folded unless the mark is warn or bad
  std::string link = {};     // the page that the text leads to, relative to this one
  std::string png = {};      // a small picture above the text: the file's bytes
  std::string alt = {};      // what it shows; empty: the text says it
  std::optional<double> sorted_by =
      {};  // in a sortable table; none: the number or word that the text begins with
};

using Row = std::vector<Cell>;

// A row for each property, a column for each subject (or channel). Properties that apply to no subject are
// folded away. More than 8 subjects are written downwards, a column for each property.
struct Matrix {
  std::string properties;  // what the rows are: "property"
  std::vector<std::string> subjects;
  struct Property {
    std::string name;
    Row cells;  // one for each subject
  };
  std::vector<Property> rows;
  bool fold_notes = true;  // of more than two columns, unless the mark is warn or bad
};

// A sentence with its mark.
struct Remark {
  Mark mark = Mark::none;
  std::string text;
};

// One picture of a row.
struct Figure {
  std::string png;  // the file's bytes
  std::string title;
  std::string text = {};  // one line
  Mark mark = Mark::none;
  std::string link = {};     // the page that the picture leads to
  std::string command = {};  // folded away
};

// How values become colours: dark to bright, readable in print and without colour vision, or, for values with
// a sign, blue over white to red.
enum class Colours { sequential, diverging };

// A picture whose pixels are values over two axes, colours by map_colour(). Transparent pixels are hatched:
// no value.
struct HeatMap {
  std::string png;  // the file's bytes, first row on top
  std::string x_label, y_label;
  std::vector<std::string> x_ticks, y_ticks;  // evenly spaced, from the left and from the bottom
  std::string low, high;                      // what the colours at both ends mean
  std::string caption, command;
  Colours colours = Colours::sequential;
};

class HtmlReport {
 public:
  explicit HtmlReport(std::string title) : title_(std::move(title)) {}

  void heading(std::string_view text);
  void subheading(std::string_view text);
  void paragraph(std::string_view text);
  // One line that says how it stands, in colour and with a sign.
  void verdict(Mark mark, std::string_view text);
  // What else must be known at once, one line each; nothing where there is none.
  void remarks(const std::vector<Remark>& remarks);
  // An empty header is left out. Sortable: a sign in each column's head sorts by it.
  void table(const std::vector<std::string>& header, const std::vector<Row>& rows, bool sortable = false);
  void matrix(const Matrix& matrix);
  void plot(const Plot& plot);
  // `png` holds a PNG file's bytes.
  void picture(std::string_view png, std::string_view caption, std::string_view command = {});
  // Side by side as far as there is room, on a phone one below the other.
  void pictures(const std::vector<Figure>& row);
  void map(const HeatMap& map);
  // Folded away: most readers need none.
  void command(std::string_view text);

  // What comes between the two is folded away under one line. Folds may hold folds; all are open on paper.
  // end_fold() throws std::logic_error where none is open.
  void begin_fold(std::string_view summary, bool open = false);
  void end_fold();
  // A page's own explanation of a word, beside the glossary's or in place of it, from here on.
  void explain(std::string term, std::string meaning);

  // A block of one's own: HTML as it stands, style and a script that runs after the whole page is there.
  // Neither may refer to anything outside the file. Style and script stand once, however often they are
  // given.
  void raw(std::string_view html);
  void style(std::string_view css);
  void script(std::string_view js);
  // A line at the page's end: where something comes from, with its path.
  void footnote(std::string_view key, std::string_view text);

  // The whole document. Throws EnvironmentError where Chart.js is not installed and a plot needs it,
  // std::logic_error where a fold is open.
  std::string document(const Provenance& made) const;

 private:
  std::string term(std::string_view word);          // with its explanation, if it has one
  std::string running_text(std::string_view text);  // symbols that stand first explained
  std::string cell_of(const Cell& cell, bool fold_note = false);
  void append_matrix(const std::string& corner, const std::vector<std::string>& columns,
                     const std::vector<Matrix::Property>& rows, bool fold_notes);
  void append_terms(std::string& html) const;
  const std::string* meaning(std::string_view word) const;

  std::string title_, body_, plots_, style_, script_, footer_;
  std::vector<std::pair<std::string, std::string>> own_terms_;
  std::vector<std::pair<std::string, std::string>> used_terms_;  // in the order of the page
  std::set<std::string, std::less<>> met_;                       // in running text
  int count_ = 0, open_folds_ = 0;
};

// The palette's number for the curve of each channel: reddish, green and blue for those that are these
// colours.
std::vector<int> channel_palette(const std::vector<std::string>& channels);

std::string html_escaped(std::string_view text);

// "copper.csv" of "/data/copper.csv": what a title shows. The path belongs into a footnote.
std::string file_name(std::string_view path);

// The colour of x in [0, 1] (beyond it: of the nearer end).
void map_colour(double x, unsigned char rgb[3], Colours colours = Colours::sequential);

}  // namespace brdf::io
