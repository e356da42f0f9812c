// The quantity that a file's comments and titles, or the caller, state for all of its values.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/columns/quantities.h"
#include "io/columns/supplied.h"

namespace brdf::io {

struct StatedQuantity {
  enum class By { comment, title, option } by;
  Quantity quantity;
  std::string words;  // as they were written
  std::string where;  // "line 3"; empty of an option
};

// The words behind `quantity:` in a comment, in any case, also `quantity = ...` and behind several `#`;
// std::nullopt if the comment states no quantity. `text` is without its first `#`.
std::optional<std::string_view> quantity_in_comment(std::string_view text);

// The quantity of an option; throws InputError for unknown words and for what is no f_r. std::nullopt of
// empty words.
std::optional<StatedQuantity> stated_by_option(const std::string& words);

// A format that states f_r and its directions itself: throws InputError where the caller states anything
// else. `name` opens the message.
void require_f_r(const std::string& name, const Supplied& supplied);

// Collects what a file states. Throws InputError, which `where` opens ("FILE, line 3"), if two statements
// contradict, and for quantities that are unknown or no f_r.
class StatedQuantities {
 public:
  explicit StatedQuantities(std::optional<StatedQuantity> option) : option_(std::move(option)) {}

  void add_comment(std::string_view words, std::size_t line, const std::string& where);
  void add_title(std::string_view title, std::size_t line, const std::string& where);
  // A comment that is free text states nothing, but may name a quantity.
  void add_free_text(std::string_view text, std::size_t line);
  // A comment's statement, else the title's, else the caller's.
  const std::optional<StatedQuantity>& result() const { return found_ ? found_ : option_; }
  // What has to be said of values whose column names no quantity, while nothing is stated: a comment names
  // one. Throws InputError if a title names one that f_r cannot be made of.
  std::string word_on_unnamed() const;

 private:
  void add(StatedQuantity stated, const std::string& where);

  std::optional<StatedQuantity> option_, found_;
  std::string refusal_, hint_;
};

}  // namespace brdf::io
