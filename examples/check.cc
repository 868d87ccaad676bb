// Checks a program before it is sent to the machine: `check FILE`; exits with 1 if LinuxCNC would stop.
#include <owlint.hpp>

#include <fstream>
#include <iostream>
#include <iterator>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: " << argv[0] << " FILE\n";
    return 2;
  }
  std::ifstream file(argv[1], std::ios::binary);
  if (!file) {
    std::cerr << "cannot read " << argv[1] << '\n';
    return 2;
  }
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  owlint::api::Options options;
  options.path = argv[1];
  bool stops = false;
  for (const owlint::api::Finding& f : owlint::api::check(text, options)) {
    std::cout << "line " << f.begin.line << ": " << f.message << " [" << f.code << "]\n";
    stops = stops || f.stops;
  }
  return stops ? 1 : 0;
}
