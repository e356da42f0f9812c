#include "render/viewer/sliders.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "io/files/numbers.h"
#include "render/viewer/typing.h"

namespace brdf::render {
namespace {

// If a value lies above the usual maximum, its slider ends at this multiple of the value.
constexpr double kBeyond = 1.5;

// Returns the upper end of the slider, which stays constant while the slider is held.
double upper_end(const ParameterInfo& p, double value, const SliderMarks& marks, float held) {
  if (held > 0) return double(held);
  double end = p.usual_max;
  if (value > end) end = kBeyond * value;
  if (marks.in_file) end = std::max(end, *marks.in_file);
  return std::min(end, p.max);
}

// Returns the lower end of the slider: the usual minimum, or a multiple of a value below it.
double lower_end(const ParameterInfo& p, double value) {
  return value < usual_min(p) ? std::max(p.min, kBeyond * value) : usual_min(p);
}

// Returns the position of a value along the slider, from 0 to 1.
float along(double value, double low, double high, bool logarithmic) {
  const double t = logarithmic ? std::log(std::max(value, low) / low) / std::log(high / low)
                               : (value - low) / (high - low);
  return float(std::clamp(t, 0.0, 1.0));
}

// Draws the interval at the lower edge of the last item, a slider of this width; the ends lie at the places
// that the middle of the knob would have.
void draw_interval(const std::pair<double, double>& known, double low, double high, bool logarithmic,
                   float width) {
  // Dear ImGui's distance between the end of a slider and its knob.
  constexpr float kFrame = 2;
  const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax();
  const float knob = ImGui::GetStyle().GrabMinSize;
  const float first = a.x + kFrame + knob / 2, way = width - 2 * kFrame - knob;
  const float left = first + way * along(known.first, low, high, logarithmic);
  const float right = std::max(first + way * along(known.second, low, high, logarithmic), left + 2);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImU32 color = IM_COL32(120, 220, 140, 255);
  list->AddRectFilled(ImVec2(left, b.y - 3), ImVec2(right, b.y), color);
}

// Returns the format of a slider's number, with spaces that move the number away from the knob.
std::string format_beside_knob(const char* format, double value, float share, float width) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  const float knob_width = ImGui::GetStyle().GrabMinSize;
  const float knob = 2 + knob_width / 2 + share * (width - 4 - knob_width);
  // The width of several spaces, because Dear ImGui rounds widths up to whole pixels.
  constexpr int kSpaces = 16;
  const float space = (ImGui::CalcTextSize(std::string(kSpaces, ' ').c_str()).x - 1) / kSpaces;
  const int spaces = spaces_beside_knob(width, knob, knob_width, ImGui::CalcTextSize(text).x, space);
  const std::string room(std::size_t(std::abs(spaces)), ' ');
  return spaces > 0 ? format + room : room + format;
}

}  // namespace

int spaces_beside_knob(float width, float knob, float knob_width, float text, float space) {
  const float left = (width - text) / 2, right = left + text, room = knob_width / 2 + 2;
  if (knob + room <= left || knob - room >= right) return 0;
  // n spaces after the text move its middle to the left by half their width.
  const bool to_left = knob >= width / 2;
  const float way = to_left ? right - (knob - room) : knob + room - left;
  const int spaces = int(std::ceil(2 * way / space));
  return to_left ? spaces : -spaces;
}

bool float_slider(const char* label, float& value, float low, float high, const char* format) {
  const float share = along(double(value), double(low), double(high), false);
  const std::string beside = format_beside_knob(format, double(value), share, ImGui::CalcItemWidth());
  return ImGui::SliderFloat(label, &value, low, high, beside.c_str());
}

bool parameter_slider(const std::string& label, const ParameterInfo& p, double& value,
                      const SliderMarks& marks) {
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  const ImGuiID place = ImGui::GetID((label + "/end").c_str());
  const double low = lower_end(p, value), high = upper_end(p, value, marks, storage.GetFloat(place, 0));
  const bool logarithmic = p.log_scale && low > 0;
  double shown = value;
  const float width = ImGui::CalcItemWidth();  // before the slider consumes it
  const std::string format = format_beside_knob("%.4g", value, along(value, low, high, logarithmic), width);
  bool moved = ImGui::SliderScalar(label.c_str(), ImGuiDataType_Double, &shown, &low, &high, format.c_str(),
                                   logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
  static Typing typing;
  const ImGuiID field = ImGui::GetItemID();
  const bool open = ImGui::TempInputIsActive(field);
  const auto number =
      typing.follow(field, open, moved && open ? std::optional(shown) : std::nullopt, ImGui::GetTime());
  if (number) shown = *number;
  moved = number || (moved && !open);
  storage.SetFloat(place, ImGui::IsItemActive() ? float(high) : 0);
  if (moved) value = std::clamp(nearest_value(p, shown), p.min, p.max);
  if (marks.known) draw_interval(*marks.known, low, high, logarithmic, width);
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) {
    std::string words = std::string(p.name) + ": " + std::string(p.doc);
    if (marks.known)
      words += "\n95 % interval: " + io::short_number(marks.known->first, 4) + " to " +
               io::short_number(marks.known->second, 4);
    words += "\nCtrl-click: type a number; right-click: default and value of the file";
    ImGui::SetTooltip("%s", words.c_str());
  }
  bool chosen = false;
  if (ImGui::BeginPopupContextItem((label + "/menu").c_str())) {
    const auto offer = [&](const std::string& words, double offered) {
      if (!ImGui::MenuItem((words + " " + io::short_number(offered, 4)).c_str())) return;
      value = offered;
      chosen = true;
    };
    offer("default", p.initial);
    if (marks.in_file) offer("in the file", *marks.in_file);
    ImGui::EndPopup();
  }
  return moved || chosen;
}

}  // namespace brdf::render
