#include "trade/approximations/lookup.h"

#include "trade/questions/names.h"
#include "trade/questions/questions.h"

namespace brdf::trade {
namespace {

// The specular term as f_r for the picture, plus the article's Lambert term.
template <class L>
struct lookup_material {
  L lookup;
  template <class T>
  T operator()(const DirectionRow<T>& x) const {
    return T(0.5 / kPi) + T(0.5) * lookup(x) / at_least(x.wi.z, T(1e-6));
  }
};

template <class L>
void add(Question& q, std::string name, L lookup, std::string note) {
  Kernel picture = untimed_kernel(lookup_material<L>{lookup});
  q.choices.push_back({std::move(name), kernel(std::move(lookup)), std::move(note), std::move(picture)});
}

template <template <class, bool> class Table, class Texel>
void add_tables(Question& q, const LookupMaterial& m, int size, int bits, const std::string& kind,
                const char* note) {
  add(q, names::texels(size, bits, "nearest") + kind, Table<Texel, false>(m, size), note);
  add(q, names::texels(size, bits, "bilinear") + kind, Table<Texel, true>(m, size), note);
}
template <template <class, bool> class Table>
void add_depths(Question& q, const LookupMaterial& m, int size, const std::string& kind, const char* note) {
  add_tables<Table, std::uint8_t>(q, m, size, 8, kind, note);
  add_tables<Table, std::uint16_t>(q, m, size, 16, kind, note);
  add_tables<Table, float>(q, m, size, 32, kind, note);
}

Question lookup_question(const LookupMaterial& m) {
  Question q{names::lookup(m.alpha),
             "specular f_r cos_i, 1/sr",
             Measure::absolute,
             direction_domain(0, 80),
             {direction_domain(80, 89), direction_domain(0, 20)},
             {}};
  add(q, names::kExact, lookup_exact{m}, "Beckmann, V-cavities, exact Fresnel");
  add(q, names::kCollapsed, lookup_collapsed<false>{m}, "the article's assumption alone");
  add(q, "H = N, clamped to 1", lookup_collapsed<true>{m}, "and the texel's range");
  for (int size = 32; size <= 1024; size *= 2)
    add_depths<lookup_article>(q, m, size, "", "(n.h, n.l), clamped to 1");
  for (int size = 32; size <= 128; size *= 2)
    add_depths<lookup_scaled>(q, m, size, ", scaled", "(tan/alpha, wi.h), G computed");
  return q;
}

}  // namespace

std::vector<Question> lookup_questions() {
  return {lookup_question({1.5, 0.3}), lookup_question({1.5, 0.05})};
}

}  // namespace brdf::trade
