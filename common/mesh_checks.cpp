#include "common/mesh_checks.hpp"

#include "common/errors.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace course {
namespace {

// A file line by line, in words; what follows a # is a comment.
class Lines {
  public:
    Lines(const std::string &name, std::string_view content, bool comments = true)
        : name_(name), content_(content), comments_(comments) {}

    // The words of the next line, empty for an empty line; nullopt at the end.
    std::optional<std::vector<std::string_view>> next() {
        if (place_ >= content_.size())
            return {};
        const std::size_t end = std::min(content_.find('\n', place_), content_.size());
        std::string_view line = content_.substr(place_, end - place_);
        place_ = end + 1;
        ++number_;
        if (comments_)
            line = line.substr(0, line.find('#'));
        std::vector<std::string_view> words;
        constexpr std::string_view blank = " \t\r\v\f";
        for (std::size_t at = line.find_first_not_of(blank); at < line.size();) {
            const std::size_t stop = std::min(line.find_first_of(blank, at), line.size());
            words.push_back(line.substr(at, stop - at));
            at = line.find_first_not_of(blank, stop);
        }
        return words;
    }

    // The next line that is not empty.
    std::vector<std::string_view> need(const std::string &what) {
        while (const auto words = next())
            if (!words->empty())
                return *words;
        throw InputError(name_, "ends before " + what);
    }

    [[noreturn]] void reject(const std::string &why) const {
        throw InputError(name_, "line " + std::to_string(number_) + ": " + why);
    }

    std::size_t place() const { return std::min(place_, content_.size()); }

  private:
    std::string name_;
    std::string_view content_;
    bool comments_;
    std::size_t place_ = 0, number_ = 0;
};

template <class Number> std::optional<Number> number(std::string_view word) {
    if (word.starts_with('+'))
        word.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size())
        return {};
    return value;
}

// Adds the three coordinates that begin at words[first] to the text.
void add_point(const Lines &lines, const std::vector<std::string_view> &words, std::size_t first, std::string &text) {
    if (words.size() < first + 3)
        lines.reject("a point needs three coordinates");
    for (std::size_t i = first; i < first + 3; ++i) {
        const auto value = number<double>(words[i]);
        if (!value)
            lines.reject("'" + std::string(words[i]) + "' is not a number");
        if (!std::isfinite(static_cast<float>(*value)))
            lines.reject("the coordinate " + std::string(words[i]) + " is not finite in single precision");
        (text += ' ') += words[i];
    }
    text += '\n';
}

constexpr long long most_points = 1LL << 31;

// The words of OBJ that say something else than points and faces.
bool is_other_obj_word(std::string_view word) {
    constexpr std::string_view known =
        " vn vt vp o g s l p mtllib usemtl usemap bevel lod c_interp d_interp shadow_obj trace_obj mg cstype deg step "
        "bmat con curv curv2 surf parm trim hole scrv sp end ";
    return known.find(" " + std::string(word) + " ") != std::string_view::npos;
}

} // namespace

std::string checked_obj(const std::string &name, const std::string &content) {
    std::string text;
    Lines lines(name, content);
    long long points = 0, highest = 0;
    while (const auto words = lines.next()) {
        if (words->empty() || is_other_obj_word(words->front()))
            continue;
        if (words->front() == "v") {
            add_point(lines, *words, 1, text += 'v');
            ++points;
            continue;
        }
        if (words->front() != "f")
            lines.reject("'" + std::string(words->front().substr(0, 20)) + "' means nothing in an OBJ file");
        if (words->size() < 4)
            lines.reject("a face needs three corners");
        text += 'f';
        for (std::size_t i = 1; i < words->size(); ++i) {
            const auto index = number<long long>((*words)[i].substr(0, (*words)[i].find('/')));
            if (!index || *index == 0 || *index > most_points || *index < -points)
                lines.reject("'" + std::string((*words)[i]) + "' names no point");
            const long long absolute = *index > 0 ? *index : points + *index + 1;
            highest = std::max(highest, absolute);
            (text += ' ') += std::to_string(absolute);
        }
        text += '\n';
    }
    if (highest > points)
        throw InputError(name, "a face names point " + std::to_string(highest) + " of " + std::to_string(points));
    return text;
}

std::string checked_off(const std::string &name, const std::string &content) {
    Lines lines(name, content);
    auto words = lines.need("the word OFF");
    const std::string_view kind = words.front();
    if (!(kind == "OFF" || kind == "COFF" || kind == "NOFF" || kind == "CNOFF" || kind == "STOFF"))
        lines.reject("does not begin with OFF (points in three dimensions)");
    words.erase(words.begin());
    if (words.empty())
        words = lines.need("the numbers of points and faces");
    if (words.front() == "BINARY")
        lines.reject("the binary form of OFF cannot be read, only its text form");
    const auto points = number<long long>(words[0]);
    const auto faces = words.size() > 1 ? number<long long>(words[1]) : std::nullopt;
    if (!points || !faces || *points < 0 || *faces < 0 || *points > most_points || *faces > most_points)
        lines.reject("no numbers of points and faces");

    std::string text = "OFF\n" + std::to_string(*points) + " " + std::to_string(*faces) + " 0\n";
    for (long long i = 0; i < *points; ++i)
        add_point(lines, lines.need("point " + std::to_string(i + 1) + " of " + std::to_string(*points)), 0, text);
    for (long long i = 0; i < *faces; ++i) {
        words = lines.need("face " + std::to_string(i + 1) + " of " + std::to_string(*faces));
        const auto corners = number<long long>(words[0]);
        if (!corners || *corners < 3 || static_cast<std::size_t>(*corners) >= words.size())
            lines.reject("a face needs the number of its corners, at least three, and as many points");
        text += std::to_string(*corners);
        for (std::size_t k = 1; k <= static_cast<std::size_t>(*corners); ++k) {
            const auto index = number<long long>(words[k]);
            if (!index || *index < 0 || *index >= *points)
                lines.reject("'" + std::string(words[k]) + "' names no point of " + std::to_string(*points));
            (text += ' ') += words[k];
        }
        text += '\n';
    }
    return text;
}

namespace {

// PLY's scalar types: bytes in a binary file.
std::size_t ply_bytes(std::string_view type) {
    static const std::map<std::string_view, std::size_t> bytes{
        {"char", 1},   {"int8", 1},    {"uchar", 1},  {"uint8", 1},  {"short", 2}, {"int16", 2},
        {"ushort", 2}, {"uint16", 2},  {"int", 4},    {"int32", 4},  {"uint", 4},  {"uint32", 4},
        {"float", 4},  {"float32", 4}, {"double", 8}, {"float64", 8}};
    const auto found = bytes.find(type);
    return found == bytes.end() ? 0 : found->second;
}

struct PlyProperty {
    std::string name;
    std::size_t bytes;       // of a value
    std::size_t count_bytes; // of a list's length; 0 for a single value
    bool whole;              // an integer of four bytes
};

struct PlyElement {
    std::string name;
    long long count;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    std::string format;
    std::vector<PlyElement> elements;
    std::size_t body = 0;
};

PlyHeader ply_header(const std::string &name, const std::string &content) {
    Lines lines(name, content, false);
    if (const auto first = lines.need("the word ply"); first.size() != 1 || first[0] != "ply")
        lines.reject("does not begin with ply");
    PlyHeader header;
    while (true) {
        const auto words = lines.need("end_header");
        if (words[0] == "end_header")
            break;
        if (words[0] == "format" && words.size() > 1)
            header.format = words[1];
        else if (words[0] == "element") {
            const auto count = words.size() == 3 ? number<long long>(words[2]) : std::nullopt;
            if (!count || *count < 0 || *count > most_points)
                lines.reject("an element needs a name and a number");
            header.elements.push_back({std::string(words[1]), *count, {}});
        } else if (words[0] == "property") {
            const bool list = words.size() == 5 && words[1] == "list";
            const std::size_t bytes = words.size() < 3 ? 0 : ply_bytes(words[words.size() - 2]);
            const std::size_t count_bytes = list ? ply_bytes(words[2]) : 0;
            if (header.elements.empty() || !bytes || (list && (!count_bytes || count_bytes == 8)) ||
                (!list && words.size() != 3))
                lines.reject("a property of an unknown kind");
            const std::string_view type = words[words.size() - 2];
            header.elements.back().properties.push_back(
                {std::string(words.back()), bytes, count_bytes, bytes == 4 && !type.starts_with("float")});
        } else if (words[0] != "comment" && words[0] != "obj_info")
            lines.reject("'" + std::string(words[0].substr(0, 20)) + "' means nothing in a PLY file");
    }
    header.body = lines.place();
    if (header.format != "ascii" && header.format != "binary_little_endian" && header.format != "binary_big_endian")
        throw InputError(name, "its header names no format that can be read");
    return header;
}

// The reader needs x, y and z as floats or doubles, and faces as one list of four-byte integers.
void require_points_and_faces(const std::string &name, const PlyHeader &header) {
    bool points = false, faces = false;
    for (const PlyElement &element : header.elements) {
        const auto with = [&](std::string_view property, bool list) {
            return std::ranges::any_of(element.properties, [&](const PlyProperty &p) {
                return p.name == property && (p.count_bytes != 0) == list &&
                       (list ? p.whole : p.bytes >= 4 && !p.whole);
            });
        };
        if (element.name == "vertex")
            points = with("x", false) && with("y", false) && with("z", false);
        if (element.name == "face")
            faces = with("vertex_indices", true) || with("vertex_index", true);
    }
    if (!points)
        throw InputError(name, "its header has no points with x, y and z as float or double");
    if (!faces)
        throw InputError(name, "its header has no faces with a list vertex_indices of int or uint");
}

// Walks through a PLY file's values, in text or in binary.
class PlyValues {
  public:
    PlyValues(const std::string &name, const PlyHeader &header, const std::string &content)
        : name_(name), text_(header.format == "ascii"), swapped_(header.format == "binary_big_endian"),
          content_(content), place_(header.body) {}

    // A list's length.
    std::size_t length(std::size_t bytes) {
        if (text_) {
            const auto value = number<long long>(word());
            if (!value || *value < 0 || *value > 65535)
                throw InputError(name_, "a list has no sensible length");
            return static_cast<std::size_t>(*value);
        }
        need(bytes);
        std::size_t value = 0;
        for (std::size_t i = 0; i < bytes; ++i)
            value |= std::size_t{static_cast<unsigned char>(content_[place_ + (swapped_ ? bytes - 1 - i : i)])}
                     << 8 * i;
        place_ += bytes;
        return value;
    }

    void skip(std::size_t count, std::size_t bytes) {
        if (!text_) {
            need(count * bytes);
            place_ += count * bytes;
            return;
        }
        for (std::size_t i = 0; i < count; ++i) {
            const auto w = word();
            if (const auto value = number<double>(w); !value || !std::isfinite(*value))
                throw InputError(name_, "'" + std::string(w.substr(0, 20)) + "' is not a finite number");
        }
    }

  private:
    void need(std::size_t bytes) const {
        if (bytes > content_.size() - place_)
            throw InputError(name_, "ends before all that its header promises");
    }
    std::string_view word() {
        constexpr std::string_view blank = " \t\r\n\v\f";
        const std::size_t start = content_.find_first_not_of(blank, place_);
        if (start == std::string_view::npos)
            throw InputError(name_, "ends before all that its header promises");
        place_ = std::min(content_.find_first_of(blank, start), content_.size());
        return content_.substr(start, place_ - start);
    }

    std::string name_;
    bool text_, swapped_;
    std::string_view content_;
    std::size_t place_;
};

} // namespace

std::string checked_ply(const std::string &name, const std::string &content) {
    const PlyHeader header = ply_header(name, content);
    require_points_and_faces(name, header);
    PlyValues values(name, header, content);
    for (const PlyElement &element : header.elements) {
        if (static_cast<std::size_t>(element.count) > content.size())
            throw InputError(name, "ends before all that its header promises");
        for (long long i = 0; i < element.count; ++i)
            for (const PlyProperty &property : element.properties)
                values.skip(property.count_bytes ? values.length(property.count_bytes) : 1, property.bytes);
    }
    return content;
}

std::string checked_stl(const std::string &name, const std::string &content) {
    constexpr std::size_t head = 80, facet_bytes = 50;
    std::uint32_t facets = 0;
    if (content.size() >= head + 4)
        std::memcpy(&facets, content.data() + head, 4);
    const bool fits = content.size() == head + 4 + facet_bytes * facets;
    const std::size_t start = content.find_first_not_of(" \t\r\n");
    if (!fits && start != std::string::npos && content.compare(start, 5, "solid") == 0) {
        if (content.find("endsolid") == std::string::npos)
            throw InputError(name, "ends before endsolid");
        std::string coordinates;
        Lines lines(name, content, false);
        while (const auto words = lines.next())
            if (!words->empty() && words->front() == "vertex")
                add_point(lines, *words, 1, coordinates);
        return content;
    }
    if (content.size() < head + 4 + facet_bytes * facets || content.size() < head + 4)
        throw InputError(name, "is no STL file, or ends before all the facets that it promises");
    for (std::uint32_t i = 0; i < facets; ++i)
        for (std::size_t k = 3; k < 12; ++k) {
            float value = 0;
            std::memcpy(&value, content.data() + head + 4 + facet_bytes * i + 4 * k, 4);
            if (!std::isfinite(value))
                throw InputError(name, "facet " + std::to_string(i + 1) + " has a coordinate that is not finite");
        }
    return std::string(head, ' ').replace(0, 6, "binary") + content.substr(head); // a header that is no "solid"
}

} // namespace course
