// HTML put together from elements, so that every tag that is opened is closed and every text is escaped.
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace course::html {

using Attributes = std::vector<std::pair<std::string, std::string>>;

// The text with & < > " ' as entities: for content and attribute values alike. Control characters, which no HTML may
// hold, become U+FFFD.
std::string escaped(std::string_view text);

// A path with '/' between its parts as a relative address: every byte percent-encoded that means something in a URL.
std::string address(std::string_view path);

// <name attributes>content</name>; `content` is HTML already, attribute values are plain text. An element that has no
// content by its nature (img, input, meta) is written without an end tag.
std::string element(const std::string &name, const Attributes &, const std::string &content = {});
inline std::string element(const std::string &name, const std::string &content) { return element(name, {}, content); }

std::string link(const std::string &to, const std::string &text);

} // namespace course::html
