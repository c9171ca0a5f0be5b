// What the gallery takes from the course's own texts: titles, questions, descriptions.
#pragma once
#include <string>

namespace course::gallery_texts {

// The first heading without the words that only number it: "# Chapter 03: Light" and "# 03 · Light" are "Light".
std::string heading_of(const std::string &markdown);

// What a lesson says of its picture: the words in ![...](picture.png).
std::string picture_words(const std::string &markdown);

// The paragraph that begins with these words, without them and in one line; with no words, the first paragraph of all.
std::string paragraph_of(const std::string &markdown, const std::string &beginning = {});

// "35 to read, 60 to do" from a lesson's line "**Time.** 35 minutes to read, 60 to do."
std::string minutes_of(const std::string &markdown);

// A value of the front matter, such as title, of a deck of slides.
std::string front_matter_of(const std::string &markdown, const std::string &key);

std::string capitalised(std::string text);
std::string in_words(std::string file_name); // speed_of_each as "Speed of each"
std::string between(const std::string &text, const std::string &before, const std::string &after);

} // namespace course::gallery_texts
