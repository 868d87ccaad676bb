// The bundled page, as bytes of the program. OWLINT_PAGE is the file that the build has made; without it there is none.
#include "analyzer/audit/page_template.h"

#ifdef OWLINT_PAGE
__asm__(
    ".section .rodata\n"
    "owlint_page_begin:\n"
    ".incbin \"" OWLINT_PAGE
    "\"\n"
    "owlint_page_end:\n"
    ".byte 0\n"
    ".previous\n");
extern "C" const char owlint_page_begin[];
extern "C" const char owlint_page_end[];
#endif

namespace owlint::audit {

std::string_view page_template() {
#ifdef OWLINT_PAGE
  return {owlint_page_begin, static_cast<size_t>(owlint_page_end - owlint_page_begin)};
#else
  return {};
#endif
}

}  // namespace owlint::audit
