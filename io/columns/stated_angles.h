// Polar angles that lines above a table state for all its rows, such as "Incidence angle: 45 deg".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/columns/column_names.h"

namespace brdf::io {

struct StatedAngle {
  Column column;      // a polar angle; its name is that of the line
  double number = 0;  // as written, in the column's unit
  std::size_t line = 0;

  double degrees() const { return column.converted(number); }
};

// Returns the polar angle that a line states: a name of such an angle, a separator (`:`, `=`, `,`, `;`, a tab
// or a blank), a number, and its unit if the name has no unit. Returns std::nullopt for other lines, and for
// names that have other meanings, too ("source").
std::optional<StatedAngle> stated_angle(std::string_view text);

// The statements of a file.
class StatedAngles {
 public:
  // Adds the angle that a line states, if the line states one.
  void add(std::string_view text, std::size_t line);
  bool is_empty() const { return all_.empty(); }
  // Returns whether a line states the angle with this index of kAngleNames.
  bool has(std::size_t angle) const;
  // Returns the statement of the angle with this index of kAngleNames, or a null pointer if no line states
  // the angle. Throws InputError if two lines state different angles, and for angles beyond 90 degrees.
  // `where` opens the message.
  const StatedAngle* find(std::size_t angle, const std::string& where) const;

 private:
  std::vector<StatedAngle> all_;
};

}  // namespace brdf::io
