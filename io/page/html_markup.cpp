#include "io/page/html_markup.h"

#include "io/files/base64.h"

namespace brdf::io {
namespace {

// Returns the colours of map_colour() as a CSS gradient.
std::string gradient(Colours colours) {
  std::string css = "linear-gradient(90deg";
  for (int k = 0; k <= 4; ++k) {
    unsigned char rgb[3];
    map_colour(k / 4.0, rgb, colours);
    css +=
        ", rgb(" + std::to_string(rgb[0]) + " " + std::to_string(rgb[1]) + " " + std::to_string(rgb[2]) + ")";
  }
  return css + ")";
}

}  // namespace

std::string html_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string file_name(std::string_view path) {
  const std::size_t slash = path.find_last_of('/');
  return std::string(slash == path.npos || slash + 1 == path.size() ? path : path.substr(slash + 1));
}

const char* css_class(Mark mark) {
  return mark == Mark::none ? "" : kNames<Mark>[std::size_t(mark)].data();
}

std::string class_of(Mark mark) {
  return mark == Mark::none ? "" : std::string(" class=\"") + css_class(mark) + "\"";
}

std::string after_space(std::string_view word) {
  return word.empty() ? "" : " " + std::string(word);
}

std::string linked(std::string_view address, const std::string& html) {
  return address.empty() ? html : "<a href=\"" + html_escaped(address) + "\">" + html + "</a>";
}

std::string image(std::string_view png, std::string_view alt) {
  return "<img alt=\"" + html_escaped(alt) + "\" src=\"data:image/png;base64," + base64(png) + "\">";
}

std::string colour_bar(std::string_view low, Colours colours, std::string_view high) {
  return "<div class=\"bar\"><span>" + html_escaped(low) +
         "</span><i style=\"background: " + gradient(colours) + "\"></i><span>" + html_escaped(high) +
         "</span></div>";
}

std::string within_script(std::string_view json) {
  std::string data;
  for (const char c : json) data += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return data;
}

}  // namespace brdf::io
