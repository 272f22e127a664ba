// The cells along strings where their ends are joined anew: each keeps its loop.
#pragma once

#include <map>
#include <span>

#include "film/film.h"

namespace lamella::surgery {

// By how many times more each cell arrives along some ends of strings, at the vertex where they end, than it
// leaves.
std::map<int, int> arrivals(const film::Film& film, std::span<const film::EdgeEnd> ends);

// Gives a string the cells that have arrived at one of its ends and go on along it.
void pass_on(film::Film& film, film::EdgeEnd from, const std::map<int, int>& arrived);

}  // namespace lamella::surgery
