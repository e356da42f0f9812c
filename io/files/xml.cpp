#include "io/files/xml.h"

#include <expat.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <optional>

#include "io/files/error.h"

namespace brdf::io {
namespace {

constexpr std::size_t kLongestXmlText = std::size_t{1} << 27;  // bytes of an element

std::string_view local_name(std::string_view name) {
  return name.substr(name.rfind(':') + 1);  // rfind() returns npos without a colon, and npos + 1 is 0
}

std::string_view without_white(std::string_view text) {
  constexpr std::string_view kWhite = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kWhite);
  if (first == text.npos) return "";
  return text.substr(first, text.find_last_not_of(kWhite) - first + 1);
}

class XmlParser {
 public:
  XmlParser(const Content& content, const std::function<void(std::string_view)>& begins,
            const std::function<void(const XmlElement&)>& ends)
      : content_(content), begins_(begins), ends_(ends), parser_(XML_ParserCreate("UTF-8"), XML_ParserFree) {
    if (!parser_) throw EnvironmentError("no memory for reading XML");
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), on_start, on_end);
    XML_SetCharacterDataHandler(parser_.get(), on_text);
    XML_SetEntityDeclHandler(parser_.get(), on_entity);
  }

  void parse() {
    constexpr std::size_t kPiece = 1 << 20;
    const std::string& bytes = content_.bytes;
    // A declaration may be at the beginning only, but blanks before it are common.
    for (std::size_t at = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()); at <= bytes.size();
         at += kPiece) {
      const std::size_t size = std::min(kPiece, bytes.size() - at);
      const bool is_last = at + size == bytes.size();
      const XML_Status status = XML_Parse(parser_.get(), bytes.data() + at, static_cast<int>(size), is_last);
      if (error_) std::rethrow_exception(error_);
      if (status != XML_STATUS_OK) refuse(XML_ErrorString(XML_GetErrorCode(parser_.get())));
      if (is_last) return;
    }
  }

 private:
  std::size_t line() const { return XML_GetCurrentLineNumber(parser_.get()); }
  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(content_.name + ", line " + std::to_string(line()) + ": is not readable XML: " + what);
  }

  // Exceptions must not pass through the functions of the library.
  template <class Action>
  static void guarded(void* self, const Action& action) {
    auto& parser = *static_cast<XmlParser*>(self);
    if (parser.error_) return;
    try {
      action(parser);
    } catch (...) {
      parser.error_ = std::current_exception();
      XML_StopParser(parser.parser_.get(), XML_FALSE);
    }
  }

  static void on_start(void* self, const char* name, const char** attributes) {
    guarded(self, [&](XmlParser& p) {
      if (p.open_.size() == kDeepestJson)
        p.refuse("is nested more than " + std::to_string(kDeepestJson) + " levels deep");
      XmlElement& element = p.open_.emplace_back();
      element.name = local_name(name);
      element.line = p.line();
      for (; *attributes; attributes += 2)
        element.attributes.emplace_back(local_name(attributes[0]), attributes[1]);
      p.begins_(element.name);
    });
  }
  static void on_end(void* self, const char*) {
    guarded(self, [&](XmlParser& p) {
      XmlElement element = std::move(p.open_.back());
      p.open_.pop_back();
      element.text = std::string(without_white(element.text));
      p.ends_(element);
    });
  }
  static void on_text(void* self, const char* text, int size) {
    guarded(self, [&](XmlParser& p) {
      if (p.open_.empty()) return;
      std::string& all = p.open_.back().text;
      if (all.size() + static_cast<std::size_t>(size) > kLongestXmlText)
        p.refuse("an element has more than " + std::to_string(kLongestXmlText >> 20) + " MiB of text");
      all.append(text, static_cast<std::size_t>(size));
    });
  }
  static void on_entity(void* self, const char* name, int, const char*, int, const char*, const char*,
                        const char*, const char*) {
    guarded(self, [&](XmlParser& p) { p.refuse("declares the entity '" + std::string(name) + "'"); });
  }

  const Content& content_;
  const std::function<void(std::string_view)>& begins_;
  const std::function<void(const XmlElement&)>& ends_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  std::vector<XmlElement> open_;
  std::exception_ptr error_;
};

}  // namespace

std::string_view XmlElement::attribute(std::string_view key) const {
  for (const auto& [known, value] : attributes)
    if (known == key) return value;
  return "";
}

std::string_view xml_root(std::string_view text) {
  constexpr std::size_t kBeginning = 1 << 16;
  text = text.substr(0, kBeginning);
  for (std::size_t at = text.find('<'); at != text.npos; at = text.find('<', at + 1)) {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("<!--")) {
      at = std::min(text.find("-->", at), text.size());
      continue;
    }
    const char next = rest.size() > 1 ? rest[1] : '?';
    if (next == '?' || next == '!') continue;
    const std::size_t end = std::min(text.find_first_of(" \t\r\n/>", at + 1), text.size());
    return local_name(text.substr(at + 1, end - at - 1));
  }
  return "";
}

void read_xml(const Content& content, const std::function<void(std::string_view name)>& begins,
              const std::function<void(const XmlElement&)>& ends) {
  XmlParser(content, begins, ends).parse();
}

}  // namespace brdf::io
