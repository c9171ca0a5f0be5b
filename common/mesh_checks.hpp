// What must hold before a mesh file is handed to CGAL's readers, which would crash on some files, ask for all memory on
// others, and silently drop what they cannot read.
#pragma once
#include <string>

namespace course {

// Each takes a whole file's content and returns one with the same faces over the same points that the reader takes as
// it is meant; `name` is the file's, for messages. Throws InputError naming the line or the facet.
std::string checked_obj(const std::string &name, const std::string &content); // polygons; negative numbers count back
std::string checked_off(const std::string &name, const std::string &content); // text; colours and normals are dropped
std::string checked_ply(const std::string &name, const std::string &content); // text, binary of both byte orders
std::string checked_stl(const std::string &name, const std::string &content); // text, binary

} // namespace course
