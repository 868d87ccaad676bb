// Highway compiles the code between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once for each kind of processor. Which of these
// runs is asked here and not of Highway: that would need its library, which Debian does not have for programs that are linked
// statically.
#include "analyzer/syntax/byte_classes.h"

#include <algorithm>
#include <vector>

#include "analyzer/text/characters.h"

// With AVX3, a block is one vector, and what is found in it comes as bits. SSE4 adds nothing to SSSE3 here.
#define HWY_DISABLED_TARGETS (HWY_AVX3_DL | HWY_SSE4)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "analyzer/syntax/byte_classes.cc"
#include <hwy/foreach_target.h>  // includes this file again, once for each target
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace owlint::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Bytes = hn::CappedTag<uint8_t, ByteClasses::kBlock>;
using Vector = hn::Vec<Bytes>;

HWY_INLINE Vector each(char c) { return hn::Set(Bytes(), static_cast<uint8_t>(c)); }

/// Whether a byte is one of so many that follow each other.
HWY_INLINE auto is_among(Vector bytes, char first, uint8_t count) {
  const Vector from_first = hn::Sub(bytes, each(first));
  return hn::Eq(hn::Min(from_first, hn::Set(Bytes(), static_cast<uint8_t>(count - 1))), from_first);
}

template <typename Mask>
HWY_INLINE void put(Mask mask, size_t at, ByteClasses::Bits& bits) {
  hn::StoreMaskBits(Bytes(), mask, reinterpret_cast<uint8_t*>(bits.data()) + at / 8);
}

void classify(const char* bytes, size_t blocks, size_t first, ByteClasses* classes) {
  const size_t end = (first + blocks) * ByteClasses::kBlock;
  const auto* in = reinterpret_cast<const uint8_t*>(bytes);
  for (size_t at = first * ByteClasses::kBlock; at < end; at += hn::Lanes(Bytes()), in += hn::Lanes(Bytes())) {
    const Vector v = hn::LoadU(Bytes(), in);
    put(is_among(v, '0', 10), at, classes->digits);
    put(hn::Eq(v, each('.')), at, classes->points);
    put(hn::Or(hn::Eq(v, each('-')), hn::Eq(v, each('+'))), at, classes->signs);
    put(is_among(hn::Or(v, each(0x20)), 'a', 26), at, classes->letters);
    put(hn::Or(hn::Eq(v, each(' ')), hn::Eq(v, each('\t'))), at, classes->blanks);
    put(hn::Eq(v, each('\r')), at, classes->returns);
    put(hn::Eq(v, each('\n')), at, classes->feeds);
  }
}

void find_looks(const char* bytes, size_t blocks, uint64_t* bits) {
  const auto* in = reinterpret_cast<const uint8_t*>(bytes);
  auto* out = reinterpret_cast<uint8_t*>(bits);
  for (size_t at = 0; at < blocks * ByteClasses::kBlock; at += hn::Lanes(Bytes())) {
    const Vector v = hn::LoadU(Bytes(), in + at);
    const auto comments = hn::Or(hn::Eq(v, each('(')), hn::Eq(v, each(';')));
    const auto words = hn::Or(is_among(hn::Or(v, each(0x20)), 'a', 26), hn::Eq(v, each('\n')));
    hn::StoreMaskBits(Bytes(), hn::Or(words, comments), out + at / 8);
  }
}

}  // namespace
ByteClassifier classifier(const char* name) { return {name, classify, find_looks}; }
}  // namespace owlint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace owlint {
namespace {

void classify_one_by_one(const char* bytes, size_t blocks, size_t first, ByteClasses* classes) {
  for (size_t block = first; block < first + blocks; ++block, bytes += ByteClasses::kBlock) {
    const auto bits = [bytes](const auto& is_there) {
      uint64_t out = 0;
      for (size_t i = 0; i < ByteClasses::kBlock; ++i) out |= uint64_t{is_there(bytes[i])} << i;
      return out;
    };
    classes->digits[block] = bits([](char c) { return is_digit(c); });
    classes->points[block] = bits([](char c) { return c == '.'; });
    classes->signs[block] = bits([](char c) { return c == '-' || c == '+'; });
    classes->letters[block] = bits([](char c) { return is_letter(c); });
    classes->blanks[block] = bits([](char c) { return is_space_or_tab(c); });
    classes->returns[block] = bits([](char c) { return c == '\r'; });
    classes->feeds[block] = bits([](char c) { return c == '\n'; });
  }
}

void find_looks_one_by_one(const char* bytes, size_t blocks, uint64_t* bits) {
  for (size_t i = 0; i < blocks * ByteClasses::kBlock; ++i) {
    const char c = bytes[i];
    const bool found = is_letter(c) || c == '\n' || c == '(' || c == ';';
    uint64_t& block = bits[i / ByteClasses::kBlock];
    if (i % ByteClasses::kBlock == 0) block = 0;
    block |= uint64_t{found} << i % ByteClasses::kBlock;
  }
}

std::vector<ByteClassifier> classifiers_here() {
  std::vector<ByteClassifier> all;
#if HWY_ARCH_X86 && (HWY_TARGETS & HWY_AVX3)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma"))
    all.push_back(N_AVX3::classifier("AVX3"));
#endif
#if HWY_ARCH_X86 && (HWY_TARGETS & HWY_AVX2)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma"))
    all.push_back(N_AVX2::classifier("AVX2"));
#endif
#if HWY_ARCH_X86 && (HWY_TARGETS & HWY_SSSE3)
  if (__builtin_cpu_supports("ssse3")) all.push_back(N_SSSE3::classifier("SSSE3"));
#endif
#if HWY_ARCH_ARM_A64
  all.push_back(HWY_STATIC_DISPATCH(classifier)("NEON"));
#endif
  all.push_back({"none", classify_one_by_one, find_looks_one_by_one});
  return all;
}

}  // namespace

std::span<const ByteClassifier> byte_classifiers() {
  static const std::vector<ByteClassifier> all = classifiers_here();
  return all;
}

}  // namespace owlint
#endif  // HWY_ONCE
