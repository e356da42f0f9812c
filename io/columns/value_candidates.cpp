#include "io/columns/value_candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "io/columns/angle_names.h"
#include "io/columns/metadata_names.h"
#include "io/columns/polarisation_names.h"
#include "io/columns/value_names.h"
#include "io/columns/wavelengths.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

using Rank = ValueCandidate::Rank;
using Says = NamedQuantity::Says;
using Use = QuantityKind::Use;

class Ranking {
 public:
  Ranking(std::vector<ValueCandidate>& candidates, Columns& header, bool is_format)
      : candidates_(candidates), header_(header), is_format_(is_format) {}

  void rank() {
    // Points, runs, places and texts are not values if other columns hold values.
    for (ValueCandidate& c : candidates_)
      if (c.is_perhaps) c.rank = Rank::aside;
    const bool has_others = any(candidates_, Rank::values) || any(candidates_, Rank::neutral) ||
                            any(candidates_, Rank::asked) || any(candidates_, Rank::refused);
    for (ValueCandidate& c : candidates_)
      if (c.is_perhaps && !has_others) c.rank = Rank::neutral;
    // "(s)" means seconds, unless another column has the other polarisation.
    const bool has_p = std::ranges::any_of(candidates_, [](const ValueCandidate& c) {
      const auto of = polarised_name(c.column->name).of;
      return of && *of != Polarisation::s;
    });
    for (ValueCandidate& c : candidates_)
      if (c.rank == Rank::neutral && !has_p &&
          (c.column->name.ends_with("(s)") || c.column->name.ends_with("[s]")))
        c.rank = Rank::aside;
    if (!is_format_) rank_tristimulus();
    if (!is_format_) rank_cielab();
    rank_mueller();
    rank_stokes();
  }

 private:
  ValueCandidate* named(std::string_view name) {
    const auto at =
        std::ranges::find_if(candidates_, [&](const ValueCandidate& c) { return c.column->name == name; });
    return at == candidates_.end() ? nullptr : &*at;
  }

  void rank_tristimulus() {
    std::array<ValueCandidate*, 3> xyz{named("X"), named("Y"), named("Z")};
    if (std::ranges::any_of(xyz, [](const ValueCandidate* c) { return !c; })) return;
    for (ValueCandidate* c : xyz) {
      c->rank = Rank::asked;
      c->refusal =
          "is, with X, Y and Z, a tristimulus value: if the three are f_r weighted by the CIE observer, give "
          "--quantity f_r; values of a colour instrument lack the geometry and the scale";
    }
  }

  // Refuses L, a, b and L, C, h, which instruments for colours write without asterisks.
  void rank_cielab() {
    for (const auto& names : {std::array{"L", "a", "b"}, std::array{"L", "C", "h"}}) {
      std::array<ValueCandidate*, 3> lab{named(names[0]), named(names[1]), named(names[2])};
      if (std::ranges::any_of(lab, [](const ValueCandidate* c) { return !c || c->rank != Rank::neutral; }))
        continue;
      for (ValueCandidate* c : lab) {
        c->rank = Rank::asked;
        c->refusal = "is, with " + std::string(names[0]) + ", " + names[1] + " and " + names[2] +
                     ", a colour coordinate (CIELAB): if the three are channels of f_r, give --quantity f_r; "
                     "colour coordinates lack the geometry and the spectrum: export reflectance factors for "
                     "each wavelength";
      }
    }
  }

  // Recognises f_r11, f_r12/f_r11, ...; m11, m12, ...: the first element is f_r of unpolarised light.
  void rank_mueller() {
    std::vector<ValueCandidate*> elements;
    ValueCandidate* first = nullptr;
    counts_from_zero_ = std::ranges::any_of(
        candidates_, [](const ValueCandidate& c) { return mueller_place(c.column->name) == "00"; });
    for (ValueCandidate& c : candidates_) {
      const std::string element = element_of(c.column->name);
      if (element == "11") first = &c;
      if (!element.empty()) elements.push_back(&c);
    }
    if (elements.size() < 4) return;
    for (ValueCandidate* c : elements) {
      c->rank = c == first ? Rank::values : Rank::aside;
      if (c == first) c->named.quantity = {&quantity_kinds()[0]};
    }
    if (!first) return;
    note_mueller(*first);
    header_.assume(std::to_string(elements.size()) + " elements of a Mueller matrix: " +
                   shown(first->column->name) + ", f_r of unpolarised light, is read");
  }

  // Returns the element, "11" to "44", that the name of a column denotes, or an empty string. Some tables
  // count rows and columns of the matrix from 0.
  std::string element_of(const std::string& name) const {
    std::string place = mueller_place(name);
    for (char& c : place) {
      c = static_cast<char>(c + counts_from_zero_);
      if (c < '1' || c > '4') return "";
    }
    return place;
  }

  // Recognises the Stokes vector of the scattered light. Only its first element is a value of f_r.
  void rank_stokes() {
    for (const auto& names : {std::array{"S0", "S1", "S2", "S3"}, std::array{"I", "Q", "U", "V"}}) {
      if (!named(names[0]) || !named(names[1]) || !named(names[2])) continue;
      for (const char* name : {names[1], names[2], names[3]})
        if (ValueCandidate* const c = named(name)) c->rank = Rank::aside;
      header_.assume("the columns are a Stokes vector: " + shown(names[0]) + ", the intensity, is read");
    }
  }

  // Elements are divided by the first one if their names say so ("f_r12/f_r11"), or if their names differ
  // from the first one in more than the place (fr11, m12).
  void note_mueller(const ValueCandidate& first) {
    MuellerColumns found;
    std::size_t count = 0;
    const char* const of_numbers = counts_from_zero_ ? "00" : "11";
    const std::string of_first = first.column->name.substr(0, first.column->name.find(of_numbers));
    for (std::size_t k = 0; k < header_.columns.size(); ++k) {
      const std::string& name = header_.columns[k].name;
      const std::string element = element_of(name);
      std::size_t* const place = element == "12"   ? &found.m12
                                 : element == "21" ? &found.m21
                                 : element == "22" ? &found.m22
                                                   : nullptr;
      if (!place) continue;
      *place = k;
      ++count;
      found.is_divided = found.is_divided || name.find('/') != name.npos ||
                         name.substr(0, name.find(mueller_place(name))) != of_first;
    }
    if (count == 3) header_.mueller = found;
  }

  std::vector<ValueCandidate>& candidates_;
  Columns& header_;
  const bool is_format_;
  bool counts_from_zero_ = false;  // the elements of a Mueller matrix
};

}  // namespace

bool any(const std::vector<ValueCandidate>& candidates, Rank rank) {
  return std::ranges::any_of(candidates, [&](const ValueCandidate& c) { return c.rank == rank; });
}

ValueCandidate candidate_of(Columns& header, std::size_t k, const HeaderFacts& facts) {
  Column& column = header.columns[k];
  ValueCandidate c{&column, quantity_of_column(column.name), Rank::neutral, ""};
  const bool is_text = k < facts.is_text.size() && facts.is_text[k] && !wavelength_of(column.name);
  if (c.named.says == Says::quantity) {
    const QuantityKind& kind = *c.named.quantity.kind;
    c.rank = kind.use == Use::converted ? Rank::values : kind.use == Use::asked ? Rank::asked : Rank::refused;
    if (kind.use != Use::converted) c.refusal = refusal_of(kind);
    if (c.named.quantity.is_other_fraction())
      c.refusal =
          "is in parts of " + to_text(std::round(1 / c.named.quantity.factor)) +
          ", of a quantity that the name does not state: for reflectance factors give --quantity BRF, "
          "or a line '# quantity: BRF' above the header row";
  } else if (c.named.says == Says::contradicts) {
    c.rank = Rank::asked;
    c.refusal = c.named.reason;
    c.is_derived = c.named.is_derived;
  }
  const NoValues no_values = holds_no_values(column.name);
  const bool is_angle = facts.is_plain && c.rank == Rank::neutral && angle_named(c.named.name).has_value() &&
                        !angle_named(c.named.name)->is_weak;
  if (c.named.says == Says::no_values || is_angle || (no_values == NoValues::yes && c.rank != Rank::values))
    c.rank = Rank::aside;
  const bool is_capital = column.name == "X" || column.name == "Y" || column.name == "Z";
  const bool is_open = c.rank == Rank::neutral || (is_text && c.named.says == Says::contradicts);
  c.is_perhaps = ((no_values == NoValues::perhaps && !is_capital) || is_text) && is_open;
  return c;
}

void rank_by_neighbours(std::vector<ValueCandidate>& candidates, Columns& header, bool is_format) {
  Ranking(candidates, header, is_format).rank();
}

}  // namespace brdf::io
