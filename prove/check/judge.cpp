#include "prove/check/judge.h"

#include <algorithm>
#include <array>
#include <iomanip>

#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/text.h"

namespace brdf::prove {
namespace {

constexpr std::array kVerdicts{Verdict::proved, Verdict::bounded, Verdict::refuted};

// A form, or a channel of a material (empty: all channels).
struct Subject {
  std::string name, channel;
  bool operator==(const Subject&) const = default;
};

std::string words_of(const Subject& s) {
  return s.name + (s.channel.empty() ? "" : " " + s.channel);
}

std::string_view scalar_of(const CheckedResult& r) {
  const auto property = find_named<Property>(r.property);
  return scalar_of(Claim{-1, property.value_or(Property::energy), r.precision});
}

void add(std::vector<Subject>& subjects, Subject s) {
  if (std::ranges::find(subjects, s) == subjects.end()) subjects.push_back(std::move(s));
}

void add_channels(std::vector<Subject>& subjects, const NamedMaterial& m) {
  for (const std::string& channel : m.material.channels) add(subjects, {m.file, channel});
}

// Returns all subjects of the certificate, including materials without rows.
std::vector<Subject> subjects_in(const Checked& checked) {
  std::vector<Subject> subjects;
  for (const NamedMaterial& m : checked.materials) add_channels(subjects, m);
  for (const CheckedResult& r : checked.results)
    if (std::ranges::find(checked.materials, r.subject, &NamedMaterial::file) == checked.materials.end())
      add(subjects, {r.subject, ""});
  return subjects;
}

std::vector<Subject> subjects_asked(const Asked& asked, Judged& judged) {
  if (asked.forms.empty() && asked.materials.empty()) return subjects_in(judged.checked);
  std::vector<Subject> subjects;
  for (const std::string& form : asked.forms) add(subjects, {form, ""});
  for (const NamedMaterial& m : asked.materials) {
    const auto same = [&](const NamedMaterial& held) { return held.material == m.material; };
    const auto found = std::ranges::find_if(judged.checked.materials, same);
    if (found == judged.checked.materials.end())
      judged.short_of.push_back(m.file + ": the certificate has no material with these parameters");
    else
      add_channels(subjects, *found);
  }
  return subjects;
}

bool is_about(const CheckedResult& r, const Subject& s) {
  return r.subject == s.name && (r.channel.empty() || r.channel == s.channel);
}

void require(const Subject& s, Property property, Judged& judged) {
  const bool rounded = is_of_a_precision(property);
  for (const Precision precision : {Precision::float_type, Precision::double_type}) {
    if (!rounded && precision == Precision::float_type) continue;
    const std::string what = std::string(name_of(property)) + " of " + words_of(s) +
                             (rounded ? " in " + std::string(name_of(precision)) : "") + ": ";
    const auto its = [&](const CheckedResult& r) {
      return is_about(r, s) && r.property == name_of(property) && r.precision == precision;
    };
    std::string fault = "the certificate has no such result";
    for (const CheckedResult& r : judged.checked.results)
      if (its(r))
        fault = r.fault.empty() ? std::string(name_of(r.verdict)) + ", not proved: " + r.statement : r.fault;
    // One proof is enough, unless another row refutes the property.
    const auto is = [&](Verdict v) {
      return [&, v](const CheckedResult& r) { return its(r) && r.fault.empty() && r.verdict == v; };
    };
    if (std::ranges::any_of(judged.checked.results, is(Verdict::proved)) &&
        std::ranges::none_of(judged.checked.results, is(Verdict::refuted)))
      continue;
    judged.short_of.push_back(what + fault);
  }
}

long count(const Judged& judged, Verdict verdict) {
  return std::ranges::count_if(judged.checked.results, [&](const CheckedResult& r) {
    return r.fault.empty() && r.verdict == verdict;
  });
}

// Removes all other results, so that they are neither listed nor decisive.
void keep_asked(std::vector<CheckedResult>& results, const std::vector<Subject>& subjects,
                const Asked& asked) {
  std::erase_if(results, [&](const CheckedResult& r) {
    const bool about = std::ranges::any_of(subjects, [&](const Subject& s) { return is_about(r, s); });
    const auto property =
        find_named<Property>(r.property == kGrowth ? name_of(Property::energy) : r.property);
    return !about || (!asked.properties.empty() &&
                      std::ranges::find(asked.properties, *property) == asked.properties.end() &&
                      std::ranges::find(asked.required, *property) == asked.required.end());
  });
}

}  // namespace

std::vector<Property> properties_named(const std::string& option, const std::vector<std::string>& names) {
  std::vector<Property> properties;
  for (const std::string& name : names) {
    const auto found = find_named<Property>(name);
    if (!found) throw InputError(option + " " + name + ": must be one of " + known_names<Property>());
    properties.push_back(*found);
  }
  return properties;
}

Judged judge(const io::Content& certificate, const Asked& asked) {
  Judged judged{check(certificate), {}};
  const bool readable = judged.checked.faults.empty() || !judged.checked.results.empty();
  if (!readable) return judged;
  const bool empty = judged.checked.results.empty();
  const std::vector<Subject> subjects = subjects_asked(asked, judged);
  keep_asked(judged.checked.results, subjects, asked);
  std::vector<Property> required = asked.required;
  required.insert(required.end(), asked.properties.begin(), asked.properties.end());
  std::ranges::sort(required);
  required.erase(std::unique(required.begin(), required.end()), required.end());
  for (const Property property : required) {
    for (const Subject& s : subjects) require(s, property, judged);
    if (subjects.empty())
      judged.short_of.push_back(std::string(name_of(property)) + ": the certificate has no such result");
  }
  if (empty)
    judged.short_of.push_back("the certificate has no result");
  else
    for (const Subject& s : subjects)
      if (std::ranges::none_of(judged.checked.results,
                               [&](const CheckedResult& r) { return is_about(r, s); }) &&
          required.empty())
        judged.short_of.push_back("the certificate has no result for " + words_of(s));
  judged.good = judged.checked.faults.empty() && judged.short_of.empty() &&
                count(judged, Verdict::proved) == long(judged.checked.results.size());
  return judged;
}

void print(std::ostream& out, const Judged& judged) {
  for (const CheckedResult& r : judged.checked.results) {
    const std::string subject = r.subject + (r.channel.empty() ? "" : " " + r.channel);
    out << std::left << std::setw(28) << io::printable(subject) << ' ' << std::setw(13) << r.property << ' '
        << std::setw(7) << scalar_of(r) << ' ' << std::setw(9)
        << (r.fault.empty() ? name_of(r.verdict) : "rejected") << "  " << (r.fault.empty() ? r.statement : "")
        << std::right << '\n';
  }
  for (const std::string& fault : judged.checked.faults) out << io::printable(fault) << '\n';
  for (const std::string& sentence : judged.short_of) out << io::printable(sentence) << '\n';
  const std::size_t results = judged.checked.results.size();
  const long leaves = judged.checked.leaves;
  out << results << (results == 1 ? " result, " : " results, ") << leaves
      << (leaves == 1 ? " leaf: " : " leaves: ");
  if (!judged.checked.faults.empty()) {
    out << "rejected\n";
    return;
  }
  std::string shown;
  for (const Verdict verdict : kVerdicts)
    if (const long n = count(judged, verdict); n > 0)
      shown += (shown.empty() ? "" : ", ") + std::to_string(n) + " " + std::string(name_of(verdict));
  out << (shown.empty() ? "nothing is shown" : shown)
      << (judged.short_of.empty() ? "" : "; a requested property is not shown") << '\n';
}

io::Json to_json(const Judged& judged) {
  io::Json rows = io::Json::array();
  for (const CheckedResult& r : judged.checked.results) {
    io::Json row{{"subject", r.subject}};
    if (!r.channel.empty()) row["channel"] = r.channel;
    row["property"] = r.property;
    row["scalar"] = scalar_of(r);
    row["verdict"] = r.fault.empty() ? io::Json(name_of(r.verdict)) : io::Json(nullptr);
    row["statement"] = r.fault.empty() ? r.statement : r.fault;
    rows.push_back(std::move(row));
  }
  return {{"results", judged.checked.results.size()},
          {"leaves", judged.checked.leaves},
          {"faults", judged.checked.faults},
          {"short_of", judged.short_of},
          {"shown", rows},
          {"holds", judged.good}};
}

}  // namespace brdf::prove
