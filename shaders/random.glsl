// common/random.hpp's numbers, bit for bit: PCG32 (O'Neill 2014). GLSL has no 64 bits; two halves stand for them, the
// lower one first.
uniform uvec2 seed;

uvec2 times(uvec2 a, uvec2 b) {
    uint high, low;
    umulExtended(a.x, b.x, high, low);
    return uvec2(low, high + a.x * b.y + a.y * b.x);
}

uvec2 plus(uvec2 a, uvec2 b) {
    uint carry, low = uaddCarry(a.x, b.x, carry);
    return uvec2(low, a.y + b.y + carry);
}

uvec2 shifted(uvec2 a, int places) { return uvec2(a.x >> places | a.y << (32 - places), a.y >> places); }

uvec2 stirred(uvec2 x) {
    x = times(x ^ shifted(x, 30), uvec2(0x1ce4e5b9u, 0xbf58476du));
    x = times(x ^ shifted(x, 27), uvec2(0x133111ebu, 0x94d049bbu));
    return x ^ shifted(x, 31);
}

uvec2 random_state, random_increment;

uvec2 next_state(uvec2 state) { return plus(times(state, uvec2(0x4c957f2du, 0x5851f42du)), random_increment); }

// One stream for each pixel and pass.
void start_random(uvec2 pixel, uint pass) {
    uvec2 index = uvec2(pixel.x | pixel.y << 24, pixel.y >> 8 | pass << 16);
    index = stirred(plus(index, uvec2(0x7f4a7c15u, 0x9e3779b9u)));
    random_increment = uvec2(index.x << 1 | 1u, index.y << 1 | index.x >> 31);
    random_state = next_state(plus(random_increment, stirred(seed)));
}

uint random_bits() {
    uvec2 old = random_state;
    random_state = next_state(old);
    uint word = shifted(shifted(old, 18) ^ old, 27).x;
    int turn = int(old.y >> 27);
    return word >> turn | word << ((32 - turn) & 31);
}

// Uniform in [0, 1): as many bits as a float holds.
float random() { return float(random_bits() >> 8) / 16777216.0; }
