// CGAL's AABB_tree as a peer: a binary tree of boxes, in double. That part of CGAL is under the GPL, so it can be left
// out of the build (COURSE_CGAL_PEER); nothing else uses it.
#include "chapters/16_comparison/contest.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

namespace course {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Tree =
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;

Kernel::Point_3 point(const Vec<float> &p) {
    return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

class CgalTree final : public Contestant {
  public:
    explicit CgalTree(std::span<const Triangle<>> triangles) {
        triangles_.reserve(triangles.size());
        for (const auto &[a, b, c] : triangles)
            triangles_.emplace_back(point(a), point(b), point(c));
        tree_.insert(triangles_.begin(), triangles_.end());
        tree_.build();
    }

    void closest(std::span<const TestRay> rays, std::span<Hit<double>> found) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto start = point(rays[i].origin);
            const auto hit = tree_.first_intersected_primitive(
                Kernel::Ray_3(start, start + (point(rays[i].direction) - CGAL::ORIGIN)));
            found[i] = hit ? Hit<double>{0, static_cast<Id>(*hit - triangles_.begin())} : Hit<double>{};
        }
    }
    // A shadow ray here ends at t = t_max: a segment.
    void shadow(std::span<const TestRay> rays, std::span<unsigned char> blocked) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto start = point(rays[i].origin);
            const auto way = static_cast<double>(rays[i].t_max) * (point(rays[i].direction) - CGAL::ORIGIN);
            blocked[i] = tree_.do_intersect(Kernel::Segment_3(start, start + way));
        }
    }
    // Its nodes hold a box of doubles and two pointers, n - 1 of them; and a primitive and a triangle for each.
    std::size_t bytes() const override {
        return triangles_.size() *
               (sizeof(CGAL::AABB_node<Tree::AABB_traits>) + sizeof(Tree::Primitive) + sizeof(Kernel::Triangle_3));
    }

  private:
    Triangles triangles_;
    Tree tree_;
};

} // namespace

std::vector<Entrant> cgal_contestants() {
    return {{"cgal", "own", [](std::span<const Triangle<>> triangles) -> std::unique_ptr<Contestant> {
                 return std::make_unique<CgalTree>(triangles);
             }}};
}

} // namespace course
