// Lesson 10, step 3: what is in which cell, in little memory: most cells are empty and take one bit.
#pragma once
#include "chapters/01_ray_casting/hit.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

namespace course {

// "This shape is in this cell."
struct Entry {
    std::uint32_t cell;
    Id slot;
};

// A table with a number for each cell would be large and mostly say "nothing here", each time with a trip to memory.
// Cells are kept in blocks of 4 x 4 x 4 instead, with one bit each that says whether there is anything. Only occupied
// cells have a place in the table of beginnings; how many of them come before is counted from the bits.
class CellLists {
  public:
    explicit CellLists(const glm::ivec3 &cells) : blocks_((cells + 3) >> 2) {
        const double total = 64.0 * blocks_.x * blocks_.y * blocks_.z;
        if (total > std::numeric_limits<std::uint32_t>::max())
            throw std::length_error("more cells than a grid can number");
        table_.resize(static_cast<std::size_t>(total / 64));
    }

    // Cells are numbered block by block, so that neighbours in space are neighbours in memory.
    std::uint32_t number(const glm::ivec3 &cell) const {
        const glm::ivec3 block = cell >> 2, rest = cell & 3;
        return static_cast<std::uint32_t>((((block.z * blocks_.y + block.y) * blocks_.x + block.x) << 6) +
                                          (rest.z << 4) + (rest.y << 2) + rest.x);
    }

    // The slots of the shapes in the cell.
    std::span<const Id> in(const glm::ivec3 &at) const {
        const std::uint32_t cell = number(at);
        const Block &block = table_[cell >> 6];
        const std::uint64_t bit = std::uint64_t{1} << (cell & 63);
        if (!(block.occupied & bit))
            return {};
        const std::uint32_t *begin = &begins_[block.first + count_bits(block.occupied & (bit - 1))];
        return {slots_.data() + begin[0], slots_.data() + begin[1]};
    }

    // Fills the lists; each cell's shapes stay in the order of the entries. To be called once.
    void fill(std::span<const Entry> entries) {
        if (entries.size() > std::numeric_limits<std::uint32_t>::max())
            throw std::length_error("more entries than a grid can number");
        for (const auto &[cell, slot] : entries)
            table_[cell >> 6].occupied |= std::uint64_t{1} << (cell & 63);
        std::uint32_t occupied = 0;
        for (Block &block : table_) {
            block.first = occupied;
            occupied += count_bits(block.occupied);
        }
        // Count, add up, and put each entry behind those before it: afterwards begins_[i] has moved on to the end of
        // list i, which is where list i + 1 begins. So the counts stand two places on, and end up one place on.
        begins_.assign(occupied + 2, 0);
        for (const auto &[cell, slot] : entries)
            ++begins_[place(cell) + 2];
        for (std::size_t i = 2; i < begins_.size(); ++i)
            begins_[i] += begins_[i - 1];
        slots_.resize(entries.size());
        for (const auto &[cell, slot] : entries)
            slots_[begins_[place(cell) + 1]++] = slot;
    }

    std::size_t occupied() const { return begins_.size() < 2 ? 0 : begins_.size() - 2; }
    std::size_t entries() const { return slots_.size(); }
    std::size_t bytes() const {
        return table_.size() * sizeof(Block) + begins_.size() * sizeof(std::uint32_t) + slots_.size() * sizeof(Id);
    }

  private:
    struct Block {
        std::uint64_t occupied = 0; // one bit for each of 64 cells
        std::uint32_t first = 0;    // how many cells are occupied in the blocks before
    };

    static std::uint32_t count_bits(std::uint64_t bits) { return static_cast<std::uint32_t>(std::popcount(bits)); }
    std::size_t place(std::uint32_t cell) const {
        const Block &block = table_[cell >> 6];
        return block.first + count_bits(block.occupied & ((std::uint64_t{1} << (cell & 63)) - 1));
    }

    glm::ivec3 blocks_;
    std::vector<Block> table_;
    std::vector<std::uint32_t> begins_; // of each occupied cell's list in slots_, and the end of the last
    std::vector<Id> slots_;
};

} // namespace course
