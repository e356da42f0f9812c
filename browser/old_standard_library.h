// Parts of C++20 that the standard library of emscripten 3.1.6 (libc++ 14) lacks, with the standard's names:
// algorithms of ranges, numbers as text, bit_cast and jthread. The preset `wasm` includes this header before
// each file, so that no other file knows of this gap. A newer libc++ needs a part less with each version;
// the header ends with an error then, so that the part is removed.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <thread>
#include <utility>

#if _LIBCPP_VERSION >= 15000
#error "this libc++ has algorithms of ranges: remove what it has from browser/old_standard_library.h"
#endif

#include <fast_float/fast_float.h>

namespace std {

#ifndef __cpp_lib_bit_cast
template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}
#endif

// A browser's worker has one thread: hardware_concurrency() is 1 there, so that none of these is made.
class jthread {
 public:
  template <class... Words>
  explicit jthread(Words&&... words) : thread_(std::forward<Words>(words)...) {}
  jthread(jthread&&) noexcept = default;
  ~jthread() {
    if (thread_.joinable()) thread_.join();
  }

 private:
  thread thread_;
};

// As the standard's: fast_float accepts infinity for values beyond the range.
template <class T>
  requires is_floating_point_v<T>
from_chars_result from_chars(const char* first, const char* last, T& value) {
  T read = 0;
  const fast_float::from_chars_result found = fast_float::from_chars(first, last, read);
  if (found.ec != errc()) return {found.ptr, found.ec};
  const bool is_word = first != found.ptr && isalpha(static_cast<unsigned char>(first[*first == '-'])) != 0;
  bool is_nothing = read == 0;  // a digit other than 0 in front of the exponent: the value is too small
  if (is_nothing) {
    for (const char* c = first; c != found.ptr && *c != 'e' && *c != 'E'; ++c)
      is_nothing = is_nothing && !(*c >= '1' && *c <= '9');
    if (!is_nothing) return {found.ptr, errc::result_out_of_range};
  }
  if (isinf(read) && !is_word) return {found.ptr, errc::result_out_of_range};
  value = read;
  return {found.ptr, errc()};
}

template <class T>
  requires is_floating_point_v<T>
to_chars_result to_chars(char* first, char* last, T value, chars_format format, int precision) {
  char text[400];
  const char* const pattern = format == chars_format::scientific ? "%.*e"
                              : format == chars_format::fixed    ? "%.*f"
                                                                 : "%.*g";
  const int size = snprintf(text, sizeof text, pattern, precision, double(value));
  if (size < 0 || size > last - first || size >= int(sizeof text)) return {last, errc::value_too_large};
  memcpy(first, text, size_t(size));
  return {first + size, errc()};
}

// The shortest of the texts with 1 to 17 digits that is read back as the same value.
template <class T>
  requires is_floating_point_v<T>
to_chars_result to_chars(char* first, char* last, T value) {
  if (!isfinite(value)) return to_chars(first, last, value, chars_format::general, 1);
  char digits[40];
  int size = 0;
  for (int precision = 0; precision < numeric_limits<T>::max_digits10; ++precision) {
    size = snprintf(digits, sizeof digits, "%.*e", precision, double(value));
    T back = 0;
    fast_float::from_chars(digits, digits + size, back);
    if (back == value) break;
  }
  // The standard takes the shorter of both notations, and the fixed one of equally long texts.
  char fixed[400];
  const char* const exponent = static_cast<const char*>(memchr(digits, 'e', size_t(size)));
  const int power = atoi(exponent + 1), written = int(exponent - digits) - (value < 0 || signbit(value)),
            significant = written > 1 ? written - 1 : 1;
  int length = snprintf(fixed, sizeof fixed, "%.*f", max(significant - 1 - power, 0), double(value));
  const bool takes_fixed = length > 0 && length <= size && length < int(sizeof fixed);
  const char* const chosen = takes_fixed ? fixed : digits;
  if (!takes_fixed) length = size;
  if (length > last - first) return {last, errc::value_too_large};
  memcpy(first, chosen, size_t(length));
  return {first + length, errc()};
}

namespace ranges {

namespace old {
template <class Compare, class Project>
auto projected(Compare& compare, Project& project) {
  return [&](auto&& a, auto&& b) -> bool {
    return std::invoke(compare, std::invoke(project, a), std::invoke(project, b));
  };
}

// Puts places below `count` in order, equal ones as they come, by merges of longer and longer runs. `spare`
// has the room of `places`. One copy serves all types: sort() for each type would be 40 kB of the page.
[[gnu::noinline, clang::minsize]] inline void order_places(unsigned* places, unsigned* spare, size_t count,
                                                           const void* context,
                                                           bool (*is_less)(const void*, unsigned, unsigned)) {
  for (size_t k = 0; k < count; ++k) places[k] = unsigned(k);
  for (size_t run = 1; run < count; run *= 2)
    for (size_t start = 0; start + run < count; start += 2 * run) {
      const size_t middle = start + run, end = min(middle + run, count);
      memcpy(spare, places + start, run * sizeof *places);
      size_t left = 0, right = middle, out = start;
      while (left < run && right < end)
        places[out++] = is_less(context, places[right], spare[left]) ? places[right++] : spare[left++];
      memcpy(places + out, spare + left, (run - left) * sizeof *places);
    }
}

template <class At, class Compare>
[[clang::minsize]] void order(At first, At last, Compare compare) {
  struct Context {
    At first;
    Compare& compare;
  };
  const Context context{first, compare};
  constexpr size_t kFew = 64;
  const size_t count = size_t(last - first);
  unsigned few[2 * kFew];
  const std::unique_ptr<unsigned[]> many(count > kFew ? new unsigned[2 * count] : nullptr);
  unsigned* const places = many ? many.get() : few;
  order_places(places, places + count, count, &context, [](const void* c, unsigned a, unsigned b) -> bool {
    const Context& in = *static_cast<const Context*>(c);
    return in.compare(in.first[a], in.first[b]);
  });
  using Distance = typename iterator_traits<At>::difference_type;
  for (size_t start = 0; start < count; ++start) {  // each cycle of the permutation
    if (places[start] == start) continue;
    auto held = std::move(first[Distance(start)]);
    size_t at = start;
    for (size_t next; (next = places[at]) != start; at = next) {
      first[Distance(at)] = std::move(first[Distance(next)]);
      places[at] = unsigned(at);
    }
    first[Distance(at)] = std::move(held);
    places[at] = unsigned(at);
  }
}
}  // namespace old

template <class Range, class Compare = std::less<>, class Project = identity>
void stable_sort(Range&& range, Compare compare = {}, Project project = {}) {
  old::order(std::begin(range), std::end(range), old::projected(compare, project));
}
template <class Range, class Compare = std::less<>, class Project = identity>
void sort(Range&& range, Compare compare = {}, Project project = {}) {
  stable_sort(range, std::move(compare), std::move(project));
}

#define BRDF_OF_PREDICATE(NAME)                                                                          \
  template <class Range, class Predicate, class Project = identity>                                      \
  constexpr auto NAME(Range&& range, Predicate predicate, Project project = {}) {                        \
    return std::NAME(std::begin(range), std::end(range),                                                 \
                     [&](auto&& x) -> bool { return std::invoke(predicate, std::invoke(project, x)); }); \
  }
BRDF_OF_PREDICATE(any_of)
BRDF_OF_PREDICATE(all_of)
BRDF_OF_PREDICATE(none_of)
BRDF_OF_PREDICATE(find_if)
BRDF_OF_PREDICATE(count_if)
#undef BRDF_OF_PREDICATE

#define BRDF_OF_ORDER(NAME, COMPARE)                                                        \
  template <class Range, class Compare = COMPARE, class Project = identity>                 \
  constexpr auto NAME(Range&& range, Compare compare = {}, Project project = {}) {          \
    return std::NAME(std::begin(range), std::end(range), old::projected(compare, project)); \
  }
BRDF_OF_ORDER(is_sorted, std::less<>)
BRDF_OF_ORDER(adjacent_find, std::equal_to<>)
BRDF_OF_ORDER(min_element, std::less<>)
BRDF_OF_ORDER(max_element, std::less<>)
BRDF_OF_ORDER(minmax_element, std::less<>)
#undef BRDF_OF_ORDER

#define BRDF_OF_MIDDLE(NAME)                                                                        \
  template <class Range, class Middle, class Compare = std::less<>, class Project = identity>       \
  constexpr auto NAME(Range&& range, Middle middle, Compare compare = {}, Project project = {}) {   \
    return std::NAME(std::begin(range), middle, std::end(range), old::projected(compare, project)); \
  }                                                                                                 \
  template <class At, class Compare = std::less<>, class Project = identity>                        \
  constexpr auto NAME(At first, At middle, At last, Compare compare = {}, Project project = {}) {   \
    return std::NAME(first, middle, last, old::projected(compare, project));                        \
  }
BRDF_OF_MIDDLE(nth_element)
BRDF_OF_MIDDLE(partial_sort)
#undef BRDF_OF_MIDDLE

template <class First, class Second>
constexpr bool equal(const First& a, const Second& b) {
  return std::equal(std::begin(a), std::end(a), std::begin(b), std::end(b));
}
template <class Range, class T, class Project = identity>
constexpr auto find(Range&& range, const T& value, Project project = {}) {
  return std::find_if(std::begin(range), std::end(range),
                      [&](auto&& x) -> bool { return std::invoke(project, x) == value; });
}
template <class At, class T, class Project = identity>
  requires(!requires(At at) { std::begin(at); })
constexpr auto find(At first, At last, const T& value, Project project = {}) {
  return std::find_if(first, last, [&](auto&& x) -> bool { return std::invoke(project, x) == value; });
}
template <class Range, class T, class Project = identity>
constexpr auto count(Range&& range, const T& value, Project project = {}) {
  return std::count_if(std::begin(range), std::end(range),
                       [&](auto&& x) -> bool { return std::invoke(project, x) == value; });
}
template <class Range, class T, class Compare = std::less<>, class Project = identity>
constexpr auto lower_bound(Range&& range, const T& value, Compare compare = {}, Project project = {}) {
  return std::lower_bound(std::begin(range), std::end(range), value, [&](auto&& x, const T& v) -> bool {
    return std::invoke(compare, std::invoke(project, x), v);
  });
}
template <class Range, class T, class Compare = std::less<>, class Project = identity>
constexpr auto upper_bound(Range&& range, const T& value, Compare compare = {}, Project project = {}) {
  return std::upper_bound(std::begin(range), std::end(range), value, [&](const T& v, auto&& x) -> bool {
    return std::invoke(compare, v, std::invoke(project, x));
  });
}
template <class Range, class Compare = std::less<>, class Project = identity>
constexpr auto max(Range&& range, Compare compare = {}, Project project = {}) {
  return *std::max_element(std::begin(range), std::end(range), old::projected(compare, project));
}
template <class Range, class T>
constexpr void fill(Range&& range, const T& value) {
  std::fill(std::begin(range), std::end(range), value);
}
template <class Range, class T>
constexpr void replace(Range&& range, const T& old_value, const T& new_value) {
  std::replace(std::begin(range), std::end(range), old_value, new_value);
}
template <class Range, class Predicate, class T>
constexpr void replace_if(Range&& range, Predicate predicate, const T& value) {
  std::replace_if(std::begin(range), std::end(range), predicate, value);
}
template <class Range, class Out>
constexpr void copy(Range&& range, Out out) {
  std::copy(std::begin(range), std::end(range), out);
}

}  // namespace ranges
}  // namespace std
