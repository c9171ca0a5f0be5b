// Moves a viewpoint as a viewer's hand does: orbits around what is looked at, zooms, looks around, flies. Knows of no
// window: it is told what happened, in units that do not depend on one.
#pragma once
#include "common/vectors.hpp"
#include "common/viewpoint.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace course {

enum class Motion { forward, back, left, right, up, down };

class Navigator {
  public:
    explicit Navigator(const Viewpoint &home) : home_(home), view_(home), home_distance_(distance_of(home)) {}

    const Viewpoint &viewpoint() const { return view_; }
    void reset() { view_ = home_; }

    // The picture was dragged by (dx, dy), in heights of the window, to the right and down: the eye circles the target
    // as if the scene were held, half a turn for each height. It stops just short of straight above and below.
    void orbit(double dx, double dy) {
        view_.eye = view_.target + turned(view_.eye - view_.target, -dx * pi, -dy * pi);
    }

    // The same around the eye: what was under the pointer stays about there.
    void look(double dx, double dy) {
        const double angle = view_.field_of_view * pi / 180;
        view_.target = view_.eye + turned(view_.target - view_.eye, dx * angle, -dy * angle);
    }

    // Each notch of the wheel brings the eye a tenth nearer to the target, or takes it as much away.
    void zoom(double notches) {
        const double before = distance_of(view_);
        const double after = std::clamp(before * std::pow(0.9, notches), 1e-4 * home_distance_, 1e4 * home_distance_);
        view_.eye = view_.target + (view_.eye - view_.target) * (after / before);
    }

    // While a motion is held, elapse() flies: in a second, half the distance at which the viewer stood at first. The
    // press itself is a small step, so that the briefest tap is seen.
    void press(Motion motion) {
        held(motion) = true;
        fly(motion, tap_seconds);
    }
    void release(Motion motion) { held(motion) = false; }
    bool flying() const { return std::ranges::find(held_, true) != held_.end(); }
    void elapse(double seconds) {
        for (std::size_t i = 0; i < held_.size(); ++i)
            if (held_[i])
                fly(static_cast<Motion>(i), seconds);
    }

  private:
    static constexpr double tap_seconds = 0.05;
    static constexpr double pole_margin = 0.02; // radians that keep the view off straight up and down

    bool &held(Motion motion) { return held_[static_cast<std::size_t>(motion)]; }

    // Never 0: a viewer who looks at their own eye is a unit away from everything.
    static double distance_of(const Viewpoint &view) {
        const double distance = length(view.eye - view.target);
        return distance > 0 ? distance : 1;
    }

    static Vec<double> unit_or(const Vec<double> &v, const Vec<double> &otherwise) {
        const double size = length(v);
        return size > 0 ? v / size : otherwise;
    }

    Vec<double> up() const { return unit_or(view_.up, {0, 1, 0}); }

    Vec<double> right() const {
        const Vec<double> forward = unit_or(view_.target - view_.eye, {0, 0, -1});
        const Vec<double> aside = std::abs(up().x) < 0.9 ? Vec<double>(1, 0, 0) : Vec<double>(0, 0, 1);
        const Vec<double> sideways = cross(forward, up());
        return length(sideways) > 1e-9 ? normalize(sideways) : normalize(cross(cross(up(), aside), up()));
    }

    // `arm` turned by `around` about the up direction, and its angle to that direction changed by `tilt`.
    Vec<double> turned(const Vec<double> &arm, double around, double tilt) const {
        const double size = length(arm), height = dot(arm, up());
        if (!(size > 0))
            return arm;
        const Vec<double> level = arm - height * up();
        const Vec<double> ahead = length(level) > 1e-9 * size ? normalize(level) : cross(up(), right());
        const Vec<double> heading = std::cos(around) * ahead + std::sin(around) * cross(up(), ahead);
        const double from_up = std::clamp(std::atan2(length(level), height) + tilt, pole_margin, pi - pole_margin);
        return size * (std::cos(from_up) * up() + std::sin(from_up) * heading);
    }

    void fly(Motion motion, double seconds) {
        const Vec<double> forward = unit_or(view_.target - view_.eye, {0, 0, -1});
        const std::array<Vec<double>, 6> directions{forward, -forward, -right(), right(), up(), -up()};
        const Vec<double> step = 0.5 * home_distance_ * seconds * directions[static_cast<std::size_t>(motion)];
        view_.eye += step;
        view_.target += step;
    }

    Viewpoint home_, view_;
    double home_distance_;
    std::array<bool, 6> held_{};
};

} // namespace course
