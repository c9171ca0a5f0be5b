#include "common/gallery_texts.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>

namespace course::gallery_texts {

std::string capitalised(std::string text) {
    if (!text.empty())
        text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

std::string in_words(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return capitalised(name);
}

std::string between(const std::string &text, const std::string &before, const std::string &after) {
    const auto start = text.find(before);
    if (start == std::string::npos)
        return {};
    const auto from = start + before.size(), to = text.find(after, from);
    return to == std::string::npos ? std::string() : text.substr(from, to - from);
}

std::string heading_of(const std::string &markdown) {
    std::istringstream lines(markdown);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("# ")) {
            std::string heading = line.substr(2);
            if (heading.starts_with("Chapter "))
                heading.erase(0, 8);
            std::size_t start = 0;
            while (start < heading.size() && std::isdigit(static_cast<unsigned char>(heading[start])))
                ++start;
            if (start > 0)
                for (const std::string_view mark : {" ", ".", ":", "·", "–", "—", "-", " "})
                    while (std::string_view(heading).substr(start).starts_with(mark))
                        start += mark.size();
            while (!heading.empty() && std::isspace(static_cast<unsigned char>(heading.back())))
                heading.pop_back();
            return capitalised(heading.substr(std::min(start, heading.size())));
        }
    return {};
}

std::string picture_words(const std::string &markdown) {
    const auto end = markdown.find("](picture.png)");
    const auto start = end == std::string::npos ? end : markdown.rfind("![", end);
    if (start == std::string::npos)
        return {};
    std::string words = markdown.substr(start + 2, end - start - 2);
    std::ranges::replace(words, '\n', ' ');
    return words;
}

std::string paragraph_of(const std::string &markdown, const std::string &beginning) {
    std::istringstream lines(markdown);
    std::string paragraph;
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (!inside && !line.empty() && !line.starts_with("#") && line.starts_with(beginning)) {
            inside = true;
            line.erase(0, beginning.size());
        }
        if (!inside)
            continue;
        if (line.empty())
            break;
        paragraph += (paragraph.empty() || paragraph.ends_with(' ') ? "" : " ") + line;
    }
    paragraph.erase(0, std::min(paragraph.find_first_not_of(' '), paragraph.size()));
    return paragraph;
}

std::string minutes_of(const std::string &markdown) {
    const std::string time = paragraph_of(markdown, "**Time.**"), unit = " minutes";
    const auto at = time.find(unit);
    return at == std::string::npos || !time.ends_with('.')
               ? std::string()
               : time.substr(0, at) + time.substr(at + unit.size(), time.size() - at - unit.size() - 1);
}

std::string front_matter_of(const std::string &markdown, const std::string &key) {
    return markdown.starts_with("---\n")
               ? between(markdown.substr(0, markdown.find("\n---", 4)) + "\n", "\n" + key + ": ", "\n")
               : std::string();
}

} // namespace course::gallery_texts
