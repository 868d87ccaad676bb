/* owlint for C programs: checks the text of a LinuxCNC program and returns the findings. In CMake, use
 * find_package(owlint) and link owlint::owlint; examples/check.c is a complete program.
 *
 * Any number of threads may check at the same time, but only one thread at a time may use a report. Texts are UTF-8, end
 * with a NUL, and live as long as the report. Lines and columns count from 1, columns in code points; offsets count bytes
 * from 0; ends are exclusive. */
#ifndef OWLINT_H
#define OWLINT_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum owlint_severity { OWLINT_INFO = 0, OWLINT_WARNING = 1, OWLINT_ERROR = 2 };

/* All zero means: LinuxCNC 2.9, no machine, the rules that are on by default. */
typedef struct owlint_options {
  const char* path;     /* the program's path; without an INI, called files are looked for in its folder */
  const char* ini;      /* INI of the machine */
  const char* linuxcnc; /* "2.7", "2.8", "2.9", "2.10" or "all" */
  const char* feature;  /* FEATURE mask, as "32" or "0x20" */
} owlint_options;

typedef struct owlint_finding {
  const char* code; /* "OW104" */
  const char* rule; /* "if-label-reused" */
  enum owlint_severity severity;
  int stops;               /* LinuxCNC stops here with this error, at least on some runs */
  const char* message;     /* what is wrong */
  const char* interpreter; /* the message that LinuxCNC prints; may be empty */
  const char* help;        /* how to fix it; may be empty */
  unsigned line, column, end_line, end_column;
  size_t offset, end_offset;
} owlint_finding;

typedef struct owlint_report owlint_report;

/* Checks `size` bytes of program. `options` may be null. Returns null if the options are wrong or the INI cannot be
 * read; then `*error`, if `error` is not null, is a message that owlint_free_text() frees. */
owlint_report* owlint_check(const char* text, size_t size, const owlint_options* options, char** error);
size_t owlint_count(const owlint_report* report);
/* Findings are ordered by position; null after the last one. */
const owlint_finding* owlint_get(const owlint_report* report, size_t index);
void owlint_free(owlint_report* report);
void owlint_free_text(char* text);
/* "0.1.0" */
const char* owlint_version(void);

#ifdef __cplusplus
}
#endif
#endif
