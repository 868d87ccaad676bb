/* owlint for C programs: checks the text of a program for LinuxCNC and gives the findings. Find it with CMake's
 * find_package(owlint) and link owlint::owlint; examples/check.c is a whole program.
 *
 * Any number of threads may check at the same time; one report is for one thread at a time. Texts are UTF-8, end with a
 * NUL, and live as long as the report. Lines and columns count from 1, columns in code points; offsets count bytes from 0;
 * ends are exclusive. */
#ifndef OWLINT_H
#define OWLINT_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum owlint_severity { OWLINT_INFO = 0, OWLINT_WARNING = 1, OWLINT_ERROR = 2 };

/* All zero is a good start: LinuxCNC 2.9, no machine, the rules that are on by default. */
typedef struct owlint_options {
  const char* path;     /* what the program is called; its folder is where called files are looked for without an INI */
  const char* ini;      /* INI of the machine */
  const char* linuxcnc; /* "2.7", "2.8", "2.9", "2.10" or "all" */
  const char* feature;  /* FEATURE mask, as "32" or "0x20" */
} owlint_options;

typedef struct owlint_finding {
  const char* code;        /* "OW104" */
  const char* rule;        /* "if-label-reused" */
  enum owlint_severity severity;
  int stops;               /* LinuxCNC stops here with this error, on some run at least */
  const char* message;     /* what was seen */
  const char* interpreter; /* what LinuxCNC prints; may be empty */
  const char* help;        /* how to fix it; may be empty */
  unsigned line, column, end_line, end_column;
  size_t offset, end_offset;
} owlint_finding;

typedef struct owlint_report owlint_report;

/* Checks `size` bytes of program. `options` may be null. Null where the options are wrong, or the INI cannot be read;
 * then `*error`, if `error` is not null, is a message that owlint_free_text() frees. */
owlint_report* owlint_check(const char* text, size_t size, const owlint_options* options, char** error);
size_t owlint_count(const owlint_report* report);
/* Findings are ordered by place; null behind the last one. */
const owlint_finding* owlint_get(const owlint_report* report, size_t index);
void owlint_free(owlint_report* report);
void owlint_free_text(char* text);
/* "0.1.0" */
const char* owlint_version(void);

#ifdef __cplusplus
}
#endif
#endif
