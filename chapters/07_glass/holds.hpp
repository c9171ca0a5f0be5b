// Lesson 07, step 3: what a scene contains, asked of its type.
#pragma once

namespace course {

// Whether the type is one of the kind, or is made of types that hold one: holds<decltype(scene), Dielectric> finds
// glass in a scene, within a sum of materials and under an acceleration structure alike.
template <class Type, template <class...> class Kind> inline constexpr bool holds = false;

template <template <class...> class Outer, class... Parts, template <class...> class Kind>
inline constexpr bool holds<Outer<Parts...>, Kind> = (holds<Parts, Kind> || ...);

template <template <class...> class Kind, class... Parts> inline constexpr bool holds<Kind<Parts...>, Kind> = true;

} // namespace course
