// Large blocks of memory in huge pages. A program of nothing but O-words fills hundreds of megabytes with flat arrays,
// and a sixth of the time went into 60,000 page faults (`./dev bench`: dense O-words). Left out under the sanitizers,
// which have allocation functions of their own.
#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t kHugePage = 2 << 20;     // bytes; where pages are of another size, nothing is lost
constexpr std::size_t kLarge = 2 * kHugePage;  // smaller blocks would waste too much of their last page

void* allocate(std::size_t size) {
  if (size < kLarge) return std::malloc(size == 0 ? 1 : size);
  const std::size_t whole = (size + kHugePage - 1) / kHugePage * kHugePage;
  void* block = whole < size ? nullptr : std::aligned_alloc(kHugePage, whole);
#ifdef MADV_HUGEPAGE
  if (block != nullptr) ::madvise(block, whole, MADV_HUGEPAGE);  // an offer; a kernel that refuses gives small pages
#endif
  return block;
}

}  // namespace

void* operator new(std::size_t size) {
  for (;;) {
    if (void* block = allocate(size)) return block;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
