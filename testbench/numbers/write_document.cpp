// Writes docs/formats.md or docs/accuracy.md: scripts/numbers calls it.
#include <exception>
#include <iostream>
#include <string_view>

#include "documents.hpp"

int main(int argc, char* argv[]) {
  const std::string_view which = argc > 1 ? argv[1] : "";
  try {
    if (which == "formats" && argc == 2) {
      std::cout << sailmap::numbers::formats_document();
    } else if (which == "accuracy" && argc == 3) {
      std::cout << sailmap::numbers::accuracy_document(argv[2]);
    } else {
      std::cerr << "usage: write_document formats | accuracy DATA\n";
      return 2;
    }
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
