// Lesson 16, step 2: who takes part, in plain types, so that Embree, CGAL and the course's own stand behind one door.
#pragma once
#include "chapters/08_mesh/triangle.hpp"
#include "chapters/09_aabb/counters.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace course {

// A ray of floats, exactly the same for every contestant whatever it computes in: 0 < t < t_max.
struct TestRay {
    Vec<float> origin, direction;
    float t_max = infinity<float>;
};

// A scene that was built, ready for rays. A whole batch goes through each call, so the call itself costs nothing.
// found[i] and blocked[i] answer rays[i].
class Contestant {
  public:
    virtual ~Contestant() = default;
    virtual void closest(std::span<const TestRay> rays, std::span<Hit<double>> found) const = 0;
    virtual void shadow(std::span<const TestRay> rays, std::span<unsigned char> blocked) const = 0;
    virtual std::size_t bytes() const = 0;

    // The steps of all these rays together; only the course's own structures can tell.
    virtual Counts steps(std::span<const TestRay>, bool /*shadow*/) const { return {}; }
};

// One line of the table: who it is, and how it is built. Building is what build_ms measures.
struct Entrant {
    std::string structure; // "bvh" ...
    std::string kernel;    // "default", "plain" (Möller–Trumbore in float), or "own" for a peer's
    std::function<std::unique_ptr<Contestant>(std::span<const Triangle<>>)> build;
    bool on_request = false; // takes part only where it is named, or what it is a variant of

    bool ours() const { return kernel != "own"; }
    bool exact() const { return kernel == "default"; }
};

std::vector<Entrant> our_structures();     // contestants/ours.cpp
std::vector<Entrant> wide_variants();      // contestants/wide.cpp: chapter 15 with a step left out, and rays in flight
std::vector<Entrant> embree_contestants(); // contestants/embree.cpp; empty where Embree is not installed
std::vector<Entrant> cgal_contestants();   // contestants/cgal.cpp; empty where the build leaves it out

// Everybody: ours first, in the order in which the course teaches them.
inline std::vector<Entrant> contestants() {
    auto all = our_structures();
    for (auto list : {wide_variants(), embree_contestants(), cgal_contestants()})
        for (auto &entry : list)
            all.push_back(std::move(entry));
    return all;
}

} // namespace course
