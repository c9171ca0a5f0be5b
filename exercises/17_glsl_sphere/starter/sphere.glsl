// Exercise 17: where a ray meets a sphere, on the GPU. README.md says what is asked.
float hit_sphere(vec3 origin, vec3 direction, vec3 centre, float radius) {
    return NOT_DONE; // put your own lines in place of this one
}
