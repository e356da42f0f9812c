#include <array>

#include "prove/scalar/lemmas.h"

namespace brdf::prove {

Bounds student_polynomial() {
  static const Bounds range = [] {
    using I = Interval<double>;
    constexpr int kX = 256, kY = 128;
    const auto part = [](int k, int count) {  // the part k of [-1.001, 1.001]
      return I::of(1.001 * (2.0 * k / count - 1), 1.001 * (2.0 * (k + 1) / count - 1));
    };
    I all = I::poison();
    for (int j = 0; j < kY; ++j) {
      const I y = part(j, kY);
      std::array<I, std::size(detail::kStudentMasking)> c;
      for (std::size_t k = 0; k < c.size(); ++k) c[k] = kernels::horner(y, detail::kStudentMasking[k]);
      for (int i = 0; i < kX; ++i) {
        const I x = part(i, kX);
        I p = c.back();
        for (std::size_t k = c.size() - 1; k-- > 0;) p = p * x + c[k];
        all = all.poisoned() ? p : hull(all, p);
      }
    }
    return Bounds{all.lo, all.hi};
  }();
  return range;
}

}  // namespace brdf::prove
