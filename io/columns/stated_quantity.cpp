#include "io/columns/stated_quantity.h"

#include "io/columns/comments.h"
#include "io/columns/scale_comments.h"
#include "io/files/error.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

Quantity known(std::string_view words, const std::string& opening) {
  const std::optional<Quantity> found = quantity_named(words);
  if (!found)
    throw InputError(opening + " " + shown(words) + " is unknown (known: " + known_quantities() + ")");
  if (found->kind->use != QuantityKind::Use::converted)
    throw InputError(opening + " " + shown(words) + " " + refusal_of(*found->kind));
  return *found;
}

}  // namespace

std::optional<std::string_view> quantity_in_comment(std::string_view text) {
  while (text.starts_with('#') || text.starts_with(' ') || text.starts_with('\t')) text.remove_prefix(1);
  const std::size_t size = kQuantityKey.size();
  if (text.size() <= size || lower_case(text.substr(0, size)) != kQuantityKey) return std::nullopt;
  const std::string_view rest = trimmed(text.substr(size));
  if (rest.starts_with(':') || rest.starts_with('=')) return trimmed(rest.substr(1));
  const bool is_parted = text[size] == ' ' || text[size] == '\t';  // "quantity f_r*cos_o"
  return is_parted && quantity_named(rest) ? std::optional(rest) : std::nullopt;
}

std::optional<StatedQuantity> stated_by_option(const std::string& words) {
  if (words.empty()) return std::nullopt;
  return StatedQuantity{StatedQuantity::By::option, known(words, "--quantity"), words, ""};
}

void StatedQuantities::add(StatedQuantity stated, const std::string& where) {
  const std::optional<StatedQuantity>& before = found_ ? found_ : option_;
  if (before && before->quantity != stated.quantity)
    throw InputError(where + ": " + (stated.by == StatedQuantity::By::title ? "the title" : "quantity") +
                     " " + shown(stated.words) + " contradicts " +
                     (before->by == StatedQuantity::By::option ? "--quantity" : before->where + ",") + " " +
                     shown(before->words));
  if (!found_ || found_->by == StatedQuantity::By::title) found_ = std::move(stated);
}

void require_f_r(const std::string& name, const Supplied& supplied) {
  const std::optional<StatedQuantity> stated = stated_by_option(supplied.quantity);
  if (stated && !stated->quantity.is_f_r())
    throw InputError(name + ": --quantity " + stated->words + ": values of this format are f_r");
  refuse_mirror_side(name, supplied);
}

void refuse_mirror_side(const std::string& name, const Supplied& supplied, std::string_view why) {
  if (supplied.mirror_side != MirrorSide::automatic)
    throw InputError(name + ": --mirror-side applies to tables with two angles; " + std::string(why));
}

void StatedQuantities::add_comment(std::string_view words, std::size_t line, const std::string& where) {
  add({StatedQuantity::By::comment, known(words, where + ": quantity"), std::string(words),
       "line " + std::to_string(line)},
      where);
}

void StatedQuantities::add_title(std::string_view title, std::size_t line, const std::string& where) {
  if (const std::string reason = unapplied_in_title(title); !reason.empty()) {
    if (refusal_.empty()) refusal_ = where + ": the title " + shown(title) + " " + reason;
    return;
  }
  const std::optional<Quantity> found = quantity_in_title(title);
  if (!found) return;
  if (found->kind->use != QuantityKind::Use::converted) {
    if (refusal_.empty()) refusal_ = where + ": the title " + shown(title) + " " + refusal_of(*found->kind);
    return;
  }
  add({StatedQuantity::By::title, *found, std::string(title), "line " + std::to_string(line)}, where);
}

void StatedQuantities::add_free_text(std::string_view text, std::size_t line) {
  const std::optional<Quantity> found = quantity_in_title(text);
  if (!found || found->is_f_r() || !hint_.empty()) return;
  hint_ = "the comment in line " + std::to_string(line) + " names " + found->meaning() +
          ", but is not a statement of the quantity: if the values are not f_r, write '# quantity: ...'";
}

void StatedQuantities::add_scale(const std::string& text, std::size_t line) {
  if (!scale_.empty() || !is_about_scale(parse_comment(text))) return;
  scale_ = "the comment in line " + std::to_string(line) + ", " + shown(std::string(trimmed(text))) +
           ", seems to give the values a scale or a unit, which is not applied: if they are not the quantity "
           "itself, write a line such as '# quantity: BRF %' or '# quantity: BRDF x1000'";
}

std::string StatedQuantities::word_on_scale() const {
  const bool is_stated = result() && result()->by != StatedQuantity::By::title;
  return is_stated ? "" : scale_;
}

std::string StatedQuantities::word_on_unnamed() const {
  if (result()) return "";
  if (!refusal_.empty()) throw InputError(refusal_);
  return hint_;
}

}  // namespace brdf::io
