// Lesson 15, step 6c: memory in large pages. A processor remembers where some two thousand pages lie; of 4 kilobytes
// each, that is little against a large mesh, and each forgotten one costs several looks into memory.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace course {

// Gives std::vector its memory, and asks for pages of 2 megabytes where it takes one or more. Where the system has none
// to give, all works as before.
template <class T> struct LargePages {
    using value_type = T;
    static constexpr std::size_t page = std::size_t{1} << 21;

    LargePages() = default;
    template <class U> LargePages(const LargePages<U> &) {}

    T *allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T),
                          unit = bytes < page ? std::max(alignof(T), alignof(std::max_align_t)) : page;
        void *const memory = std::aligned_alloc(unit, (bytes + unit - 1) / unit * unit);
        if (memory == nullptr)
            throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
        if (unit == page)
            madvise(memory, bytes, MADV_HUGEPAGE); // no more than a wish
#endif
        return static_cast<T *>(memory);
    }
    void deallocate(T *memory, std::size_t) { std::free(memory); }

    template <class U> bool operator==(const LargePages<U> &) const { return true; }
};

template <class T> using LargeVector = std::vector<T, LargePages<T>>;

} // namespace course
