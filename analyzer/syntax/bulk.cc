#include "analyzer/syntax/bulk.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "analyzer/syntax/bulk_classes.h"
#include "analyzer/syntax/line_text.h"

// Of Highway only the headers are used. Loading its library costs a small program more than the whole check (it measures
// the processor's clock), and all that it would do here is to choose among the variants: choose() below.
#define HWY_DISABLED_TARGETS (HWY_AVX3_DL | HWY_SSSE3)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "analyzer/syntax/bulk.cc"
#include <hwy/foreach_target.h>  // compiles what follows once for each kind of vector
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace owlint::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

// A processor without vectors for this: byte by byte.
Passed pass(const uint8_t* data, size_t size, size_t from) {
  return pass_plain_lines_scalar({reinterpret_cast<const char*>(data), size}, from);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

constexpr size_t kBlock = 64;  // bytes that are looked at together, one bit of a mask each

/// One bit for each byte of a block.
struct Masks {
  uint64_t feed = 0, ret = 0, odd = 0, letter = 0;  // always
  uint64_t blank = 0, digit = 0;                    // only where lines do not begin as motion does
};

template <bool kAll>
HWY_INLINE Masks classify(const uint8_t* at) {
  const hn::CappedTag<uint8_t, kBlock> d;
  const size_t lanes = hn::Lanes(d);
  const auto upper = hn::LoadDup128(d, bulk::kUpperHalf.data());
  const auto lower = hn::LoadDup128(d, bulk::kLowerHalf.data());
  Masks m;
  for (size_t i = 0; i < kBlock; i += lanes) {
    const auto bytes = hn::LoadU(d, at + i);
    const auto high = hn::TableLookupBytes(upper, hn::ShiftRight<4>(bytes));
    const auto low = hn::TableLookupBytes(lower, hn::And(bytes, hn::Set(d, 15)));
    const auto bits = hn::And(high, low);
    const auto has = [&](uint8_t wanted) { return hn::Ne(hn::And(bits, hn::Set(d, wanted)), hn::Zero(d)); };
    const auto collect = [&](auto mask, uint64_t* out) {
      uint64_t piece = 0;
      hn::StoreMaskBits(d, mask, reinterpret_cast<uint8_t*>(&piece));
      if (lanes < kBlock) piece &= (uint64_t{1} << lanes) - 1;
      *out |= piece << i;
    };
    collect(hn::Eq(bytes, hn::Set(d, '\n')), &m.feed);
    collect(hn::Eq(bytes, hn::Set(d, '\r')), &m.ret);
    collect(hn::Eq(bits, hn::Zero(d)), &m.odd);
    collect(has(bulk::kLetter), &m.letter);
    if constexpr (kAll) {
      collect(has(bulk::kBlank), &m.blank);
      collect(has(bulk::kDigit), &m.digit);
    }
  }
  return m;
}

/// All bits below the highest one of `mask`, that one included.
uint64_t up_to_highest(uint64_t mask) { return mask == 0 ? 0 : ~uint64_t{0} >> std::countl_zero(mask); }

/// Passes over lines, block by block.
class Pass {
 public:
  Pass(const uint8_t* data, size_t size, size_t from) : data_(data), size_(size), at_(from), line_(from) {}

  Passed run() {
    for (; at_ < size_; at_ += kBlock) {
      if (at_ + kBlock < size_ ? step(data_ + at_, kBlock) : last_step()) break;
    }
    if (code_base_ != kNone)
      out_.last_code = number_of(code_base_, code_feeds_, uint64_t{1} << (63 - std::countl_zero(code_lines_)));
    if (at_ >= size_ && line_ < size_) {  // a last line without line feed
      ++out_.lines;
      if (code_ && out_.first_code == 0) out_.first_code = out_.lines;
      if (code_) out_.last_code = out_.lines;
      line_ = size_;
    }
    out_.next = line_;
    return out_;
  }

 private:
  static constexpr uint32_t kNone = UINT32_MAX;

  static uint32_t number_of(uint32_t base, uint64_t feeds, uint64_t bit) {
    return base + static_cast<uint32_t>(std::popcount(feeds & (bit - 1))) + 1;
  }

  bool last_step() {
    uint8_t padded[kBlock];
    const size_t here = size_ - at_;
    std::memset(padded, '\n', kBlock);
    std::memcpy(padded, data_ + at_, here);
    return step(padded, here);
  }

  /// One block; true when a line in it may matter.
  HWY_INLINE bool step(const uint8_t* block, size_t here) {
    const uint64_t inside = up_to_highest(uint64_t{1} << (here - 1));
    Masks m = classify<false>(block);
    const uint64_t starts = m.feed << 1 | at_start_;
    uint64_t code_bytes = 0;  // in lines that end here; what lies after the last line feed follows from `rest`
    uint64_t odd = m.odd | ((m.ret << 1 | after_return_) & ~m.feed);
    after_return_ = m.ret >> 63;
    odd |= (m.letter << 1 | after_letter_) & m.letter;
    after_letter_ = m.letter >> 63;
    // Do all lines that begin here begin with a letter, as motion does, or not at all?
    const bool plain = (code_ || at_start_ != 0) && (starts & ~(m.letter | m.feed)) == 0;
    if (plain) {
      code_bytes = ~(m.feed & starts);  // all lines but empty ones are code
      at_start_ = m.feed >> 63;
    } else {
      m = classify<true>(block);
      // The first byte of each line that is no blank: adding a line's start to the blanks carries it over them.
      uint64_t carried = 0;
      const bool beyond = __builtin_add_overflow(m.blank, starts & m.blank, &carried);
      const uint64_t first = (starts | carried) & ~m.blank;
      odd |= first & m.digit;
      at_start_ = m.feed >> 63 | (beyond ? 1 : 0);
      code_bytes = ~(m.blank | m.feed);
    }
    odd &= inside;

    // Lines that end here, before the one with the first odd byte.
    const uint64_t feeds = m.feed & (odd == 0 ? inside : inside & ((odd & -odd) - 1));
    const size_t line_end = feeds == 0 ? at_ + here : at_ + static_cast<size_t>(std::countr_zero(feeds));
    if (line_end - line_ > kLineLimit) return true;
    const uint64_t over = up_to_highest(feeds);
    if (feeds != 0) {
      // A line is marked by its bytes, or at its end where its bytes are in the blocks before.
      const uint64_t lines = (code_bytes & over) | (code_ ? feeds & -feeds : 0);
      if (lines != 0) {
        if (out_.first_code == 0) out_.first_code = number_of(out_.lines, feeds, lines & -lines);
        code_base_ = out_.lines;
        code_feeds_ = feeds;
        code_lines_ = lines;
      }
      out_.lines += static_cast<uint32_t>(std::popcount(feeds));
      line_ = at_ + 64 - static_cast<size_t>(std::countl_zero(feeds));
      code_ = false;
    }
    code_ = code_ || (code_bytes & ~m.feed & inside & ~over) != 0;
    return odd != 0;
  }

  const uint8_t* data_;
  size_t size_;
  size_t at_;                  // the block
  size_t line_;                // where the line begins that is not over yet
  bool code_ = false;          // it has something other than blanks, in the blocks before
  uint64_t at_start_ = 1;      // only blanks of it have come so far
  uint64_t after_letter_ = 0;  // the last byte of the block before was a letter
  uint64_t after_return_ = 0;  // so was a carriage return
  Passed out_;
  // The last block with code: its lines are counted at the end only.
  uint32_t code_base_ = kNone;
  uint64_t code_feeds_ = 0;
  uint64_t code_lines_ = 0;
};

Passed pass(const uint8_t* data, size_t size, size_t from) { return Pass(data, size, from).run(); }

#endif  // HWY_SCALAR

}  // namespace owlint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace owlint {

namespace {

using PassFunction = Passed (*)(const uint8_t* data, size_t size, size_t from);

Passed pass_scalar(const uint8_t* data, size_t size, size_t from) {
  return pass_plain_lines_scalar({reinterpret_cast<const char*>(data), size}, from);
}

PassFunction chosen = nullptr;  // by a test

}  // namespace

const std::vector<BulkVariant>& bulk_variants() {
  static const std::vector<BulkVariant> all = [] {
    std::vector<BulkVariant> list;
#if HWY_ARCH_X86
#if HWY_TARGETS & HWY_AVX3
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512cd")) {
      list.push_back({"AVX-512", &N_AVX3::pass});
    }
#endif
#if HWY_TARGETS & HWY_AVX2
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") &&
        __builtin_cpu_supports("fma")) {
      list.push_back({"AVX2", &N_AVX2::pass});
    }
#endif
#if HWY_TARGETS & HWY_SSE4
    if (__builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("aes") && __builtin_cpu_supports("pclmul")) {
      list.push_back({"SSE4", &N_SSE4::pass});
    }
#endif
#else
    list.push_back({"compiled for", &HWY_STATIC_DISPATCH(pass)});
#endif
    list.push_back({"scalar", &pass_scalar});
    return list;
  }();
  return all;
}

Passed pass_plain_lines(std::string_view bytes, size_t from) {
  static const PassFunction best = bulk_variants().front().pass;
  return (chosen == nullptr ? best : chosen)(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size(), from);
}

void choose_bulk_variant(const BulkVariant* variant) { chosen = variant == nullptr ? nullptr : variant->pass; }

Passed pass_plain_lines_scalar(std::string_view bytes, size_t from) {
  Passed out;
  out.next = from;
  while (out.next < bytes.size()) {
    const size_t end = std::min(bytes.find('\n', out.next), bytes.size());
    const std::string_view line = bytes.substr(out.next, end - out.next);
    bool first = true;
    bool code = false;
    bool odd = line.size() > kLineLimit;
    for (size_t i = 0; i < line.size() && !odd; ++i) {
      const uint8_t bits = bulk::bits_of(static_cast<uint8_t>(line[i]));
      if ((bits & bulk::kReturn) != 0 && i + 1 < line.size()) odd = true;
      if ((bits & bulk::kBlank) != 0) continue;
      code = true;
      if (bits == 0 || (first && (bits & bulk::kDigit) != 0)) odd = true;
      if ((bits & bulk::kLetter) != 0 && i + 1 < line.size() &&
          (bulk::bits_of(static_cast<uint8_t>(line[i + 1])) & bulk::kLetter) != 0)
        odd = true;
      first = false;
    }
    if (odd) return out;
    ++out.lines;
    if (code && out.first_code == 0) out.first_code = out.lines;
    if (code) out.last_code = out.lines;
    out.next = std::min(end + 1, bytes.size());
  }
  return out;
}

}  // namespace owlint
#endif  // HWY_ONCE
