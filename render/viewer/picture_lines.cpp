// Draws names, numbers and messages round the picture.
#include <imgui.h>

#include <cmath>

#include "io/files/numbers.h"
#include "render/viewer/panels.h"

namespace brdf::render {
namespace {

constexpr ImU32 kWhite = IM_COL32(240, 240, 240, 255), kRed = IM_COL32(255, 130, 120, 255),
                kGround = IM_COL32(33, 33, 38, 255), kVeil = IM_COL32(0, 0, 0, 170);

float text_width(const std::string& words) {
  return ImGui::CalcTextSize(words.c_str()).x;
}

// Returns the words, cut if they do not fit.
std::string fitting(const std::string& words, float width) {
  if (text_width(words) <= width) return words;
  std::string cut = words;
  while (!cut.empty() && text_width(cut + "...") > width) {
    cut.pop_back();
    while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0) == 0x80) cut.pop_back();
  }
  return cut + "...";
}

class Lines {
 public:
  explicit Lines(const Layout& layout)
      : list_(ImGui::GetBackgroundDrawList()),
        layout_(layout),
        pad_(6 * layout.scale),
        height_(ImGui::GetFontSize()) {}

  // Draws a docked line: words at the left, numbers at the right.
  void line(const Area& area, const std::string& left, const std::string& right, ImU32 color) {
    list_->AddRectFilled(ImVec2(area.x, area.y), ImVec2(area.x + area.width, area.y + area.height), kGround);
    const float y = area.y + (area.height - height_) / 2, room = area.width - 3 * pad_;
    const std::string end = fitting(right, room / 2);
    put(area.x + area.width - pad_ - text_width(end), y, end, kWhite);
    put(area.x + pad_, y, fitting(left, room - text_width(end)), color);
  }
  // Draws words on the picture, over a translucent ground; (x, y) is the left or the right end of the
  // words.
  void tag(float x, float y, const std::string& words, bool right_end = false) {
    const float width = text_width(words), left = right_end ? x - width : x;
    list_->AddRectFilled(ImVec2(left - pad_ / 2, y - 2), ImVec2(left + width + pad_ / 2, y + height_ + 2),
                         kVeil);
    put(left, y, words, kWhite);
  }
  float bottom() const { return layout_.picture.y + layout_.picture.height - height_ - pad_; }
  float pad() const { return pad_; }

 private:
  void put(float x, float y, const std::string& words, ImU32 color) {
    list_->AddText(ImVec2(x, y), color, words.c_str());
  }

  ImDrawList* list_;
  const Layout& layout_;
  float pad_, height_;
};

void tags(Lines& lines, const Session& session, const Layout& layout) {
  const ViewState& state = session.state();
  const Area& p = layout.picture;
  if (state.display == Display::gbuffer) {
    for (int k = 0; k <= kTargetCount; ++k)
      lines.tag(p.x + p.width * float(k % 3) / 3 + lines.pad(),
                p.y + p.height * float(k / 3 + 1) / 3 - 1.5f * ImGui::GetFontSize(),
                k < kTargetCount ? std::string(name_of(Target(k))) : "lighting");
  } else if (state.display == Display::split) {
    const float line = p.x + p.width * state.split;
    lines.tag(line - 2 * lines.pad(), lines.bottom(), "A", true);
    lines.tag(line + 2 * lines.pad(), lines.bottom(), "B");
  } else if (state.display == Display::flip) {
    lines.tag(p.x + p.width / 2, lines.bottom(), "B");
  }
}

std::string numbers(const PanelInfo& info) {
  std::string out;
  if (info.pictures->samples_drawn() > 0) {
    out = io::plural(std::size_t(info.pictures->samples_drawn()), "sample");
    if (info.pictures->noise() >= 0) out += ", noise " + io::percent(info.pictures->noise(), 2);
    out += ", ";
  }
  return out + (info.coarse ? "coarse, " : "") + std::to_string(std::lround(info.frame_ms)) + " ms";
}

void probe_tooltip(const PanelInfo& info) {
  if (!info.probe) return;
  ImGui::SetNextWindowPos(ImVec2(info.probe_at.x + 14, info.probe_at.y + 14));
  ImGui::BeginTooltip();
  for (const std::string& line : probe_lines(*info.probe)) ImGui::TextUnformatted(line.c_str());
  ImGui::EndTooltip();
}

}  // namespace

std::vector<std::string> probe_lines(const Shown::Probe& probe) {
  std::vector<std::string> out = lines(probe.a);
  if (!probe.a.hit) return out;
  // The last line of a hit is f_r.
  out.back() = "A: " + out.back();
  if (!probe.b) return out;
  const auto number = [](float value) { return io::short_number(double(value), 5); };
  const glm::vec3& f = probe.b->value;
  out.push_back("B: f_r (" + number(f.x) + ", " + number(f.y) + ", " + number(f.z) + ") 1/sr" +
                (probe.b->known ? "" : ", not measured here"));
  return out;
}

void picture_lines(const Session& session, const Layout& layout, const PanelInfo& info) {
  Lines lines(layout);
  const ImU32 color = info.is_error ? kRed : kWhite;
  probe_tooltip(info);
  if (!session.state().show_ui) {  // only errors are shown
    if (!info.is_error) return;
    const Area& p = layout.picture;
    return lines.line({p.x, p.height - 26 * layout.scale, p.width, 26 * layout.scale}, info.message, "",
                      color);
  }
  const ViewState& state = session.state();
  lines.line(layout.head, "A: " + session.name_of_a(), "B: " + info.pictures->other_name(state), kWhite);
  lines.line(layout.status, info.message, numbers(info), color);
  tags(lines, session, layout);
}

}  // namespace brdf::render
