// The page of page.h with marks where data go: @title@, @camera@, @style@, @interference@, @frames@.
#pragma once

#include <string_view>

namespace lamella::picture {

std::string_view page_text();

}  // namespace lamella::picture
