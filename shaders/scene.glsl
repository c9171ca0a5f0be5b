// Where the scene lies: everything but meshes in one buffer of four floats a texel, written by pack.hpp.
uniform samplerBuffer scene;

// The runs of shapes in the scene's order, and the lights: where each begins, and how many it holds. Where they are known
// to the compiler, it writes the loops over them out.
#ifdef LIST_TABLE
const ivec2 lists[LIST_COUNT] = ivec2[LIST_COUNT](LIST_TABLE), lights = LIGHT_RUN;
#else
uniform ivec2 lists[LIST_COUNT], lights;
#endif

const int NOTHING = 0, SPHERE = 1, PLANE = 2, DISK = 3, CYLINDER = 4, CONE = 5, BOX = 6, TRIANGLE = 7, TORUS = 8, BLOB = 9;

// Whether a loop ended before its work was done: llvmpipe stops all loops of a pixel silently after 65,535 rounds. Each
// loop looks afterwards whether it was let finish.
bool out_of_steps = false;

// The nearest hit so far: at which t, what kind of shape, and where it is stored.
struct Hit {
    float t;
    int kind, at;
};
