// The parts of the gallery's page below its chapters, and what all parts share.
#pragma once
#include "common/gallery.hpp"
#include "common/html.hpp"

namespace course::gallery_parts {

std::string formatted(const char *format, double number);
std::string counted(std::size_t count, const std::string &one, const std::string &many);

// A text as the course's Markdown has it, as HTML: `code`, *stress*, $formula$; everything else as it is written.
std::string prose(const std::string &text);

// A command that breaks, where it must, between its words and not at its hyphens.
std::string command_html(const std::string &command);

std::string findings_html(const Findings &);

// Claims can lead to the chapters of the gallery.
std::string section_html(const GallerySection &, const Gallery &);

} // namespace course::gallery_parts
