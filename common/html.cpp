#include "common/html.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>

namespace course::html {

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        case '\'':
            result += "&#39;";
            break;
        default:
            if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t')
                result += "\uFFFD";
            else
                result += c;
        }
    }
    return result;
}

std::string address(std::string_view path) {
    std::string result;
    for (const char c : path) {
        if (std::isalnum(static_cast<unsigned char>(c)) ||
            std::string_view("-._~/").find(c) != std::string_view::npos) {
            result += c;
            continue;
        }
        char encoded[4];
        std::snprintf(encoded, sizeof encoded, "%%%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
        result += encoded;
    }
    return result;
}

std::string element(const std::string &name, const Attributes &attributes, const std::string &content) {
    static constexpr std::array<std::string_view, 5> without_content{"img", "input", "meta", "link", "br"};
    std::string result = "<" + name;
    for (const auto &[key, value] : attributes)
        result += " " + key + "=\"" + escaped(value) + "\"";
    result += ">";
    if (std::ranges::find(without_content, name) == without_content.end())
        result += content + "</" + name + ">";
    return result;
}

std::string link(const std::string &to, const std::string &text) { return element("a", {{"href", to}}, escaped(text)); }

} // namespace course::html
