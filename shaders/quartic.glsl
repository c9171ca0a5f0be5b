// Surfaces of degree four: to come.
