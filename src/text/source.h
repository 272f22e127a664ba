// Text that a person wrote (a datafile, a script, a typed line) and places in it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace lamella::text {

// One text with the name that messages show for it: a path, "<prompt>", "-e 1".
// Places keep their source alive, so an error can be shown after the reader is gone.
struct Source {
  std::string name;
  std::string content;
};

using SourcePointer = std::shared_ptr<const Source>;

SourcePointer make_source(std::string name, std::string content);

// A stretch of a source: `length` bytes from byte `offset`.
struct Place {
  SourcePointer source;
  std::uint32_t offset = 0;
  std::uint32_t length = 0;

  bool known() const { return source != nullptr; }
};

// Line and column of a place, both counted from 1; the column counts characters (UTF-8 sequences), a
// tab as one. Lines end at LF, CR LF or a lone CR.
struct LineColumn {
  int line = 1;
  int column = 1;
};

LineColumn line_and_column(const Place& place);

// The whole line in which a place begins, without its end-of-line characters.
std::string_view line_of(const Place& place);

}  // namespace lamella::text
