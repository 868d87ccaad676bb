/* Checks a program before it is sent to the machine: `check FILE`; exits with 1 if LinuxCNC would stop. */
#include <owlint.h>
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char** argv) {
  if (argc != 2) {
    fprintf(stderr, "usage: %s FILE\n", argv[0]);
    return 2;
  }
  FILE* file = fopen(argv[1], "rb");
  if (file == NULL) {
    perror(argv[1]);
    return 2;
  }
  fseek(file, 0, SEEK_END);
  const size_t size = (size_t)ftell(file);
  rewind(file);
  char* text = malloc(size + 1);
  if (text == NULL || fread(text, 1, size, file) != size) return 2;
  fclose(file);

  owlint_options options = {0};
  options.path = argv[1];
  char* error = NULL;
  owlint_report* report = owlint_check(text, size, &options, &error);
  free(text);
  if (report == NULL) {
    fprintf(stderr, "%s\n", error);
    owlint_free_text(error);
    return 2;
  }
  int stops = 0;
  for (size_t i = 0; i < owlint_count(report); ++i) {
    const owlint_finding* f = owlint_get(report, i);
    printf("line %u: %s [%s]\n", f->line, f->message, f->code);
    stops = stops || f->stops;
  }
  owlint_free(report);
  return stops;
}
