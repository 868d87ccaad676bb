// Prints what owlint reads in an INI, for ini.py: lines `SECTION<tab>KEY<tab>NUMBER` on standard input, a value a line.
#include <iostream>
#include <sstream>

#include "analyzer/machine/ini.h"

int main(int, char** argv) {
  owlint::Ini ini;
  std::string error;
  if (!ini.read(owlint::disk(), argv[1], &error)) {
    std::cerr << error << '\n';
    return 1;
  }
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream in(line);
    std::string section;
    std::string key;
    size_t number = 0;
    std::getline(in, section, '\t');
    std::getline(in, key, '\t');
    in >> number;
    std::string value;
    size_t at = 0;
    for (const owlint::Ini::Entry& e : ini.entries()) {
      if (e.section == section && e.key == key && ++at == number) value = e.value;
    }
    std::cout << value << '\n';
  }
  return 0;
}
