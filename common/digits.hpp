// Numbers in pictures: digits of 3 by 5 dots, for the scale of a heat map.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace course {

// Whether the dot (x, y) of the text is set: every letter is 3 dots wide and 5 high, with one empty dot between. Knows
// digits, '.', 'k' and 'M'; other letters are empty.
inline bool dot_of_text(std::string_view text, int x, int y) {
    // Five rows from the top, three bits each, the left dot first.
    constexpr std::string_view known = "0123456789.kM";
    constexpr std::array<std::uint16_t, 13> rows{075557, 026227, 071747, 071717, 055711, 074717, 074757,
                                                 071122, 075757, 075717, 000002, 045655, 057755};
    if (x < 0 || y < 0 || y >= 5 || x % 4 == 3 || static_cast<std::size_t>(x / 4) >= text.size())
        return false;
    const std::size_t letter = known.find(text[static_cast<std::size_t>(x / 4)]);
    return letter != known.npos && (rows[letter] >> (3 * (4 - y) + 2 - x % 4) & 1);
}

// 1, 10, 1k, 20k, 3M: a round number in few letters.
inline std::string short_number(double number) {
    const auto whole = [](double n) { return std::to_string(static_cast<long long>(n + 0.5)); };
    return number < 1e3 ? whole(number) : number < 1e6 ? whole(number / 1e3) + "k" : whole(number / 1e6) + "M";
}

} // namespace course
