// What vectors can do: simdjson parses a file of JSON. `./dev bench` compares its bytes per second with those of owlint.
#include <cstdlib>
#include <iostream>

#include <simdjson.h>

int main(int argc, char** argv) {
  simdjson::dom::parser parser;
  const auto document = parser.load(argc == 2 ? argv[1] : "");
  if (document.error() == simdjson::SUCCESS) return EXIT_SUCCESS;
  std::cerr << document.error() << '\n';
  return EXIT_FAILURE;
}
