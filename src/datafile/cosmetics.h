// Words of the top section that only a picture or another program cares about: checked, and kept for saving.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lamella::datafile {

struct Reading;

// What follows such a word.
enum class CosmeticShape {
  nothing,
  number,
  optional_number,
  string,
  braces,      // = { numbers, also nested }
  matrix,      // 16 numbers
  transforms,  // a count, and so many matrices, each after `color c` or `swap_colors` or neither
};

struct CosmeticWord {
  std::string_view word;
  CosmeticShape shape = CosmeticShape::nothing;
  bool kept = true;  // else it says nothing that will still be true when the scene is saved
};

// Null if it is none.
const CosmeticWord* cosmetic_word(std::string_view word);
void collect_cosmetics(std::vector<std::string>& into);

// Takes what follows the word, which is taken already, and adds it to the scene with all formulas evaluated.
void read_cosmetic(Reading& reading, const CosmeticWord& word);

}  // namespace lamella::datafile
