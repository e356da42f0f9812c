#include "io/page/marks.h"

namespace brdf::io {
namespace {

constexpr std::array kLooks{
    MarkLook{Mark::none, "", "", "", ""},
    MarkLook{Mark::good, "good", "\u2713", "border-radius: 50%; color: var(--back); background: var(--good)",
             "\x1b[32m"},
    MarkLook{Mark::unknown, "unknown", "?", "border-radius: 50%; border: 1.5px dashed var(--dim)",
             "\x1b[90m"},
    MarkLook{Mark::warn, "warning", "!",
             "clip-path: polygon(50% 0, 100% 100%, 0 100%); padding-top: .16em; color: var(--back); "
             "background: var(--warn)",
             "\x1b[33m"},
    MarkLook{Mark::bad, "bad", "\u2717", "color: var(--back); background: var(--bad)", "\x1b[31m"},
    MarkLook{Mark::absent, "not applicable", "\u2013", "", ""}};
constexpr bool is_in_order() {
  for (std::size_t k = 0; k < kLooks.size(); ++k)
    if (kLooks[k].mark != Mark(k)) return false;
  return kLooks.size() == kNames<Mark>.size();
}
static_assert(is_in_order());

}  // namespace

const MarkLook& look_of(Mark mark) {
  return kLooks[std::size_t(mark)];
}

std::string mark_style() {
  std::string css;
  for (const MarkLook& look : kLooks) {
    if (look.sign.empty()) continue;
    // The text after the slash is read aloud in place of the sign; older browsers take the first line.
    const std::string rule = "." + std::string(kNames<Mark>[std::size_t(look.mark)]) + "::before { ",
                      sign = "content: \"" + std::string(look.sign) + "\"";
    css += rule + sign + "; " + sign + " / \"" + std::string(look.word) + ": \"; " + std::string(look.shape) +
           " }\n";
  }
  return css;
}

std::string mark_legend() {
  std::string html = "<p class=\"marks\">Marks:";
  for (const MarkLook& look : kLooks)
    if (!look.sign.empty() && look.mark != Mark::absent)
      html += " <span class=\"" + std::string(kNames<Mark>[std::size_t(look.mark)]) + "\">" +
              std::string(look.word) + "</span>";
  return html + "</p>\n";
}

}  // namespace brdf::io
