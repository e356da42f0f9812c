// The quantity that the comments and titles of a file, or the caller, state for all values.
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
  std::string words;  // as in the file or option
  std::string where;  // "line 3"; empty for an option
};

// Returns the words after `quantity:` in a comment, in any case, also after `quantity =`, after several
// `#`, and after `quantity` and a blank if the words are a known quantity. Returns std::nullopt if the
// comment states no quantity. `text` is the comment without its first `#`.
std::optional<std::string_view> quantity_in_comment(std::string_view text);

// Returns the quantity of an option, or std::nullopt if `words` is empty. Throws InputError for unknown
// words and for quantities that cannot be converted to f_r.
std::optional<StatedQuantity> stated_by_option(const std::string& words);

// Checks the caller's statements about a format that states f_r and its directions itself. Throws
// InputError if the caller states anything else. `name` opens the message.
void require_f_r(const std::string& name, const Supplied& supplied);
// Throws InputError if the caller states the mirror side of a table whose directions are known. `name` opens
// the message, `why` ends it.
void refuse_mirror_side(const std::string& name, const Supplied& supplied,
                        std::string_view why = "this table has azimuths");

// Collects the statements of a file. Throws InputError if two statements contradict each other, and for
// quantities that are unknown or cannot be converted to f_r. `where` opens the message ("FILE, line 3").
class StatedQuantities {
 public:
  explicit StatedQuantities(std::optional<StatedQuantity> option) : option_(std::move(option)) {}

  // Adds the quantity that a comment states. `line`: the number of the line, from 1.
  void add_comment(std::string_view words, std::size_t line, const std::string& where);
  // Adds a title, which may name a quantity.
  void add_title(std::string_view title, std::size_t line, const std::string& where);
  // Adds a comment that is free text. Such a comment states nothing, but may name a quantity.
  void add_free_text(std::string_view text, std::size_t line);
  // Adds a comment, which may give the values a scale without stating a quantity.
  void add_scale(const std::string& text, std::size_t line);
  // Returns a note if a comment seems to give the values a scale and no comment states a quantity; otherwise
  // an empty string.
  std::string word_on_scale() const;
  // Returns the statement of a comment, otherwise that of a title, otherwise that of the caller.
  const std::optional<StatedQuantity>& result() const { return found_ ? found_ : option_; }
  // Returns a note for values whose column names no quantity, if no quantity is stated but a comment names
  // one; otherwise an empty string. Throws InputError if a title names a quantity that cannot be converted
  // to f_r.
  std::string word_on_unnamed() const;

 private:
  void add(StatedQuantity stated, const std::string& where);

  std::optional<StatedQuantity> option_, found_;
  std::string refusal_, hint_, scale_;
};

}  // namespace brdf::io
