// Reads XML as a sequence of elements.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/content.h"

namespace brdf::io {

// An element of XML. Names have no prefix ("xs:Layer" is "Layer").
struct XmlElement {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::string text;  // without the text of elements inside and without blanks at its ends
  std::size_t line = 0;

  // Returns the value of an attribute, or an empty text.
  std::string_view attribute(std::string_view key) const;
};

// Returns the name of the first element of a text that begins like XML, or an empty text. Only the
// beginning of the text is inspected.
std::string_view xml_root(std::string_view text);

// Calls `begins` at the beginning of each element, with its name, and `ends` at its end, with its text.
// Throws InputError with file and line if the text is not well-formed, declares entities, is nested more
// than kDeepestJson levels deep, or holds an element with more than 128 MiB of text. The text must be UTF-8.
void read_xml(const Content& content, const std::function<void(std::string_view name)>& begins,
              const std::function<void(const XmlElement&)>& ends);

}  // namespace brdf::io
