// The template of every report: one HTML file that opens without a network, on a phone, in dark mode and by
// keyboard, and prints on paper. docs/validation.md gives the rules for the content of a page.
//
// A page is written from top to bottom: first verdict(), then the facts in the order in which readers need
// them. Details for few readers go into a fold. Terms of the glossary (io/page/glossary.h) explain
// themselves: in every header of a table or axis, and, for symbols, at the first occurrence in running
// text. Custom blocks take their colours from the variables of io/page/html_page.css and redraw themselves
// at the document's event "scheme".
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/files/provenance.h"
#include "io/page/body.h"
#include "io/page/marks.h"

namespace brdf::io {

// A line of a plot. Points with a value that is not finite, or not positive on a logarithmic axis, are
// gaps.
struct Series {
  std::string label;  // empty: not in the legend
  std::vector<double> x, y;
  enum class Style { line, dashed, points, faint, faint_points } style = Style::line;
  std::vector<double> low = {}, high = {};  // edges of a band about the line; empty: no band
  int colour = -1;                          // of the palette; -1: the next one. Equal numbers belong together
  std::vector<std::string> names = {};      // of the points: in tooltips, and as labels unless faint
  std::string role = {};                    // in tooltips and files, before the label: "measured", "fitted"
  bool hidden = false;                      // not drawn until the reader switches it on in the legend
};

// The bottom edge of a logarithmic axis. It holds exact values, that is, 0 or rounding errors. They are
// drawn a decade below all other values, with a word instead of a number.
struct BottomEdge {
  std::string label;     // "exact"
  double below = 1e-15;  // values up to this
};

// A plot, drawn by Chart.js, which is embedded in the file. The entries of the legend are buttons that switch
// their curves. The legend has at most 16 entries. If there are more, no legend is drawn, and names of points
// or a table must identify the series. Readers can save a plot as SVG and its numbers as CSV.
struct Plot {
  std::string title, x_label, y_label;
  std::vector<Series> series;
  bool log_x = false, log_y = false;
  bool equal_axes = false;  // the same scale on both axes: polar lobes
  double reach = 0;         // with equal_axes: the least extent of the axes, for one scale of several plots
  std::optional<std::pair<double, double>> range_y{};  // of a linear y axis; std::nullopt: from the values
  // The kind of the labelled curves and how many there are altogether, if not all of them are drawn: the plot
  // then states "4 of 5 angles of incidence shown". `counted` is a plural.
  std::string counted{};
  std::size_t all = 0;
  std::string caption;
  std::string command;                      // prints the same numbers; folded
  std::optional<BottomEdge> bottom_edge{};  // of a logarithmic y axis
};

struct Cell {
  std::string text;
  Mark mark = Mark::none;
  bool code = false;
  std::string command = {};       // folded, below the text
  std::string note = {};          // small, below the text; in a matrix folded unless the mark is warn or bad
  std::string link = {};          // the page that the text leads to, relative to this page
  std::string png = {};           // a small picture above the text: the bytes of the file
  std::string alt = {};           // alternative text of the picture; empty: the text serves
  std::string picture_file = {};  // in place of png: the address of the picture, relative to this page
  std::optional<double> sorted_by =
      {};  // in a sortable table; std::nullopt: the number or word that begins the text
};

using Row = std::vector<Cell>;

// A table with a row per property and a column per subject (or channel). Properties that apply to no
// subject are folded. With more than 8 subjects, rows and columns are exchanged.
struct Matrix {
  std::string properties;  // the kind of the rows: "property"
  std::vector<std::string> subjects;
  struct Property {
    std::string name;
    Row cells;  // one per subject
  };
  std::vector<Property> rows;
  bool fold_notes = true;  // with more than two columns, unless the mark is warn or bad
};

// A fact about the subject of a page.
struct Fact {
  std::string name;   // "instrument"; empty if the value needs no name
  std::string value;  // empty: not stated
};

// A sentence with its mark.
struct Remark {
  Mark mark = Mark::none;
  std::string text;
};

// One picture of a row.
struct Figure {
  std::string png;  // the bytes of the file
  std::string title;
  std::string text = {};  // one line
  Mark mark = Mark::none;
  std::string link = {};          // the page that the picture leads to
  std::string command = {};       // folded
  std::optional<Body> body = {};  // turns in place of the picture if the browser runs scripts
};

// Colour scales for values: dark to bright, readable in print and without colour vision; or, for values
// with a sign, blue over white to red.
enum class Colours { sequential, diverging };

// A picture with values over two axes as pixels, coloured by map_colour(). Transparent pixels have no value
// and are hatched.
struct HeatMap {
  std::string png;  // the bytes of the file, first row on top
  std::string x_label, y_label;
  std::vector<std::string> x_ticks, y_ticks;  // evenly spaced, from the left and from the bottom
  std::string low, high;                      // the meaning of the colours at both ends
  std::string caption, command;
  Colours colours = Colours::sequential;
};

// What a printed page shows of a fold.
enum class Paper { open, left_out };

class HtmlReport {
 public:
  explicit HtmlReport(std::string title) : title_(std::move(title)) {}

  void heading(std::string_view text);
  void subheading(std::string_view text);
  void paragraph(std::string_view text);
  // Adds one line with facts about the subject; "not stated" in grey for a fact without a value.
  void facts(const std::vector<Fact>& facts);
  // Adds one line with the overall assessment, in colour and with a sign.
  void verdict(Mark mark, std::string_view text);
  // Adds further facts that readers must know at once, one line each; nothing if the list is empty.
  void remarks(const std::vector<Remark>& remarks);
  // Adds a table, without a header row if `header` is empty. Sortable: a control in the header of each
  // column sorts by it, and a box above a table of more than five rows filters by the text of the rows.
  void table(const std::vector<std::string>& header, const std::vector<Row>& rows, bool sortable = false);
  void matrix(const Matrix& matrix);
  void plot(const Plot& plot);
  // Adds a picture. `png` holds the bytes of a PNG file.
  void picture(std::string_view png, std::string_view caption, std::string_view command = {});
  // Adds pictures side by side as far as there is room; on a phone one below the other.
  void pictures(const std::vector<Figure>& row);
  void map(const HeatMap& map);
  // Adds a command, folded because most readers do not need it.
  void command(std::string_view text);

  // The content between the two calls is folded under one line. Folds may contain folds. On paper a fold is
  // open, or it is left out. end_fold() throws std::logic_error if no fold is open.
  void begin_fold(std::string_view summary, Paper paper = Paper::open);
  void end_fold();
  // Adds an explanation of a term to this page from here on, in addition to the glossary or in place of its
  // entry.
  void explain(std::string term, std::string meaning);

  // Adds a custom block: HTML without escaping, a style, and a script that runs after the whole page is
  // loaded. None of them may refer to anything outside the file. Repeated styles and scripts are included
  // once.
  void raw(std::string_view html);
  void style(std::string_view css);
  void script(std::string_view js);
  // Adds a line at the end of the page: the origin of something, with its path.
  void footnote(std::string_view key, std::string_view text);

  // Returns the whole document. Throws EnvironmentError if a plot needs Chart.js and it is not installed,
  // and std::logic_error if a fold is open.
  std::string document(const Provenance& made) const;

 private:
  std::string term(std::string_view word);          // with its explanation, if there is one
  std::string running_text(std::string_view text);  // explains symbols at their first occurrence
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

// Returns the number in the palette for the curve of each channel: reddish, green and blue for channels of
// these colours.
std::vector<int> channel_palette(const std::vector<std::string>& channels);

// Escapes <, >, & and double quotes for HTML.
std::string html_escaped(std::string_view text);

// Returns "copper.csv" for "/data/copper.csv", for use in titles. The path belongs in a footnote.
std::string file_name(std::string_view path);

// Computes the colour of x in [0, 1]; values outside are clamped.
void map_colour(double x, unsigned char rgb[3], Colours colours = Colours::sequential);

}  // namespace brdf::io
