// The structures taught so far, by the names that --structure takes.
#pragma once
#include "chapters/11_octree/taught.hpp"
#include "chapters/12_kd_tree/kd_tree.hpp"

namespace course {

inline const auto structures_of_12 =
    std::tuple_cat(structures_of_11, std::tuple{Named<KdTreeMiddle>{"kd-middle"}, Named<KdTreeMedian>{"kd-median"},
                                                Named<KdTreeSah>{"kd-sah"}});

} // namespace course
