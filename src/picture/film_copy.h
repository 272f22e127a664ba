// A film that is drawn in place of another: parts of it, moved or repeated.
#pragma once

#include <string_view>
#include <vector>

#include "picture/content.h"
#include "scene/scene.h"

namespace lamella::picture {

struct FilmCopy {
  scene::Scene scene;  // the film with the columns that pictures look at
  Content content;     // as given, for the rows of this scene
};

// Which row of the original each row of the copy comes from.
struct CopiedRows {
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> edges;
  std::vector<std::uint32_t> triangles;
};

// After the elements were made: gives the copy the original's columns, orders its borders and carries what is
// told of rows over.
void finish_copy(FilmCopy& copy, const film::Film& original, const Content& content, const CopiedRows& rows);

}  // namespace lamella::picture
