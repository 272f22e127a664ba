// Commands that scripts use and that are not supported, each with the reason.
#pragma once

#include <string_view>

namespace lamella::session {

// Empty for other words. Single letters are told apart by case, words are not.
std::string_view refusal(std::string_view word);

}  // namespace lamella::session
