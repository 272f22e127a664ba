// The tokens of a datafile: from the file and the files that it includes, with macros replaced.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "datafile/spot.h"
#include "language/lexer.h"

namespace lamella::datafile {

// Reading cannot go on: what follows would only be misunderstood.
class Unreadable : public text::Error {
 public:
  using text::Error::Error;
};

// Plain numbers that stand one after the other on one (logical) line.
struct PlainRow {
  std::vector<double> values;
  std::vector<Spot> spots;
  bool complete = false;  // the line ends after them
  Spot end;               // of a complete row: the line's end

  void clear();
};

// `#define NAME tokens` up to the line's end; names in their case. `#include "file"` anywhere.
class TokenSource : public language::TokenStream {
 public:
  explicit TokenSource(text::SourcePointer file);

  // Besides the lexer's errors: a macro that leads to itself, an unknown directive; Unreadable for an include
  // that cannot be read or leads to itself. The tokens of a macro have the place where the macro was used.
  const language::Token& peek(std::size_t ahead = 0) override;
  language::Token take() override;
  // Whether the next token is the first of its line.
  bool at_line_start() const { return at_line_start_; }
  // Up to the line's end, which stays. Bytes that are no token are passed over.
  void skip_line();
  // To the beginning of the next line that is not blank.
  void next_line();

  // The numbers with which the next line begins, read straight from the bytes; blank lines before it are
  // passed over. Stops in front of whatever may need more than that (a word, an operator, a comment), and
  // before the last number, which may belong to it. Reads nothing where a token has been looked at already.
  void take_plain_row(PlainRow& row);
  // The same for the numbers that stand next on this line, up to a closing brace.
  void take_plain_values(PlainRow& row);

  Spot spot(const text::Place& place) const;
  text::Place place(Spot spot) const;
  // In the order of opening.
  const std::vector<text::SourcePointer>& sources() const { return sources_; }

  // What has not been read yet: the rest of this file, then of those that include it. With `keep_macros` each
  // is a copy in which the macros of the lines to come are replaced. Nothing can be taken afterwards.
  std::vector<text::Place> take_rest(bool keep_macros);

 private:
  struct Macro {
    std::vector<language::Token> tokens;
    text::Place place;
  };
  struct OpenFile {
    language::Lexer lexer;
    std::string canonical_path;
    text::Place included_at;
  };

  language::Token next();
  std::uint32_t scan_numbers(std::uint32_t at, PlainRow& row) const;
  void give_back_last(std::uint32_t begin, PlainRow& row);
  void open(text::SourcePointer source, std::string canonical_path, const text::Place& included_at);
  void directive(const language::Token& hash);
  void define(const language::Token& hash);
  void include(const language::Token& hash);
  void refuse_loop(const std::string& canonical_path, const language::Token& name) const;
  void expand(const std::string& name, const language::Token& use, std::vector<std::string>& active,
              std::vector<language::Token>& into) const;
  std::string expanded_text(const text::Place& rest) const;

  std::vector<text::SourcePointer> sources_;
  std::vector<OpenFile> files_;  // the innermost last
  std::map<std::string, Macro, std::less<>> macros_;
  std::deque<language::Token> expanded_;  // of a macro, still to be taken
  std::deque<language::Token> ahead_;
  bool at_line_start_ = true;
};

}  // namespace lamella::datafile
