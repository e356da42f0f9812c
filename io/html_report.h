// One HTML file that opens without a network and prints on paper: text, tables, verdicts, plots, pictures.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/provenance.h"

namespace brdf::io {

// A line of a plot. Points with a value that is not finite (or not positive on a logarithmic axis) are gaps.
struct Series {
  std::string label;
  std::vector<double> x, y;
  enum class Style { line, dashed, points, faint, faint_points } style = Style::line;
  std::vector<double> low = {}, high = {};  // edges of a band about the line; empty: none
  int colour = -1;                          // of the palette; -1: the next one. Equal ones belong together
};

// Drawn by Chart.js, which is embedded in the file.
struct Plot {
  std::string title, x_label, y_label;
  std::vector<Series> series;
  bool log_x = false, log_y = false;
  bool equal_axes = false;  // square, both axes alike: polar lobes
  std::string caption;
  std::string command;  // that prints the same numbers
};

enum class Mark { none, good, warn, bad };

struct Cell {
  std::string text;
  Mark mark = Mark::none;
  bool code = false;
  std::string command = {};  // shown beneath
};

// How values become colours: dark to bright, readable in print and without colour vision, or, for values with
// a sign, blue over white to red.
enum class Colours { sequential, diverging };

// A picture whose pixels are values over two axes, colours by map_colour().
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
  void paragraph(std::string_view text);
  // One line that says how it stands, in colour.
  void verdict(Mark mark, std::string_view text);
  void table(const std::vector<std::string>& header, const std::vector<std::vector<Cell>>& rows);
  void plot(const Plot& plot);
  // `png` holds a PNG file's bytes.
  void picture(std::string_view png, std::string_view caption, std::string_view command = {});
  void map(const HeatMap& map);
  void command(std::string_view text);

  // The whole document. Throws EnvironmentError where Chart.js is not installed and a plot needs it.
  std::string document(const Provenance& made) const;

 private:
  std::string title_, body_, plots_;
  int count_ = 0;
};

// The palette's number for the curve of each channel: reddish, green and blue for those that are these colours.
std::vector<int> channel_palette(const std::vector<std::string>& channels);

std::string html_escaped(std::string_view text);

// A PNG (8 bits, RGB) of row-major pixels, top row first: heat maps.
std::string png_of_pixels(std::size_t width, std::size_t height, const std::vector<unsigned char>& rgb);

// The colour of x in [0, 1] (beyond it: of the nearer end).
void map_colour(double x, unsigned char rgb[3], Colours colours = Colours::sequential);

}  // namespace brdf::io
