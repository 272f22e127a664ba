// A session on trial: commands in, output and messages out.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "session/session.h"
#include "support/folder.h"

namespace lamella::trial {

inline std::string datafile(const std::string& name) {
  return std::string(LAMELLA_SOURCE_DIR) + "/datafiles/" + name;
}

// What a text printed, what it said on the standard error output, and how it ended.
struct Ran {
  std::string out;
  std::string messages;
  session::Outcome outcome = session::Outcome::done;
};

class Trial {
 public:
  // With a datafile of the project, or none.
  explicit Trial(const std::string& scene = {}) : session_(session::command_table()) {
    session_.set_quiet(true);
    if (!scene.empty()) session_.load(datafile(scene));
  }

  Ran run(const std::string& text, bool keep_going = false) {
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    Ran result;
    result.outcome = session_.run(text::make_source("test", text), keep_going);
    session_.output().flush();
    result.out = ::testing::internal::GetCapturedStdout();
    result.messages = ::testing::internal::GetCapturedStderr();
    return result;
  }

  // What a text prints that must succeed.
  std::string out(const std::string& text) {
    const Ran ran = run(text);
    EXPECT_EQ(ran.outcome, session::Outcome::done) << text << "\n" << ran.messages;
    EXPECT_EQ(ran.messages, "") << text;
    return ran.out;
  }

  double number(const std::string& expression) { return std::stod(out("print " + expression)); }

  // The messages of a text that must fail.
  std::string failure(const std::string& text) {
    const Ran ran = run(text);
    EXPECT_EQ(ran.outcome, session::Outcome::failed) << text;
    return ran.messages;
  }

  session::Session& session() { return session_; }

 private:
  session::Session session_;
};

inline ::testing::AssertionResult contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "\"" << part << "\" is not in:\n" << text;
}

}  // namespace lamella::trial
